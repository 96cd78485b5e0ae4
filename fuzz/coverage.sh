#!/usr/bin/env bash
# coverage.sh [BUILD [FOLDER...]]: builds the replays for clang's source coverage, runs the committed inputs, and the folders' inputs of each
# target (FOLDER/found-TARGET), and reports the library's and the kernels' headers. BUILD/fuzz-coverage.txt lists them; HTML=1 writes BUILD/fuzz-coverage too.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=${1:-"$here/../build-coverage"}
shift || true
cmake -S "$here/.." -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DOSTEON_BUILD_APPS=OFF \
  -DCMAKE_CXX_FLAGS="-fprofile-instr-generate -fcoverage-mapping" > "$build.log" 2>&1 || { cat "$build.log"; exit 1; }
rm -f "$build.log"
build=$(cd "$build" && pwd)
programs=()
for source in "$here"/fuzz_*.cpp; do
  target=$(basename "$source" .cpp)
  target=${target#fuzz_}
  cmake --build "$build" --target "replay_$target" > /dev/null
  mapfile -t inputs < <("$here/seeds" "$target")
  for folder in "$@"; do [ -d "$folder/found-$target" ] && inputs+=("$folder/found-$target"); done
  LLVM_PROFILE_FILE="$build/$target.profraw" "$build/fuzz/replay_$target" "${inputs[@]}" | tail -n 1 | sed "s/^/$target: /"
  programs+=("$build/fuzz/replay_$target")
done
llvm-profdata-14 merge -o "$build/fuzz.profdata" "$build"/*.profraw
objects=("${programs[0]}")
for program in "${programs[@]:1}"; do objects+=(-object "$program"); done
root=$(cd "$here/.." && pwd)
report=("${objects[@]}" -instr-profile="$build/fuzz.profdata")
llvm-cov-14 report "${report[@]}" "$root/include" "$root/kernels" | tee "$build/fuzz-coverage.txt"
if [ -n "${HTML:-}" ]; then
  llvm-cov-14 show "${report[@]}" -format=html -output-dir="$build/fuzz-coverage" "$root/include" "$root/kernels"
fi
