#!/bin/bash -eu
# The build script of OSS-Fuzz and ClusterFuzzLite: all targets with $CXX, $CXXFLAGS and $LIB_FUZZING_ENGINE into $OUT, with their seeds.
source="$SRC/osteon"
build="${WORK:-/tmp}/osteon-fuzz"
gmp=$($CC -print-file-name=libgmp.a)  # $OUT is run in an image without libgmp.so
cmake -S "$source" -B "$build" -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$CXXFLAGS" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DLIB_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" -DOSTEON_BUILD_APPS=OFF ${gmp:+-DGMP_LIBRARY="$gmp"}
cmake --build "$build" --target fuzzers -j "$(nproc)"
for program in "$build"/fuzz/fuzz_*; do
  [ -x "$program" ] || continue
  name=$(basename "$program")
  target=${name#fuzz_}
  cp "$program" "$OUT/"
  mapfile -t folders < <("$source/fuzz/seeds" "$target")
  [ ${#folders[@]} -eq 0 ] || zip -q -j -r "$OUT/${name}_seed_corpus.zip" "${folders[@]}"
  [ ! -f "$source/fuzz/$target.dict" ] || cp "$source/fuzz/$target.dict" "$OUT/$name.dict"
  printf '[libfuzzer]\nmax_len = %s\ntimeout = 10\nrss_limit_mb = 2048\n' "$("$source/fuzz/max_len" "$target")" > "$OUT/$name.options"
done
