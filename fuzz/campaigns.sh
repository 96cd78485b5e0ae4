#!/usr/bin/env bash
# campaigns.sh BUILD SECONDS [TARGET...]: a campaign for each target, as many at a time as there are cores; then a line for each. Ends with status 1
# where one has failed; the failures are in BUILD/fuzz/failed-TARGET, the logs in BUILD/fuzz/TARGET.log.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
seconds=$2
shift 2
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  for program in "$build"/fuzz/fuzz_*; do
    [ -f "$program" ] && [ -x "$program" ] && targets+=("$(basename "$program" | sed 's/^fuzz_//')")
  done
fi
[ ${#targets[@]} -gt 0 ] || { echo "campaigns: no fuzzers in $build; hint: cmake --workflow --preset fuzz" >&2; exit 2; }
one() {
  if "$1/campaign.sh" "$2" "$4" "$3" > "$2/fuzz/$4.log" 2>&1; then
    echo "$4: $(sed -n 's/^stat::number_of_executed_units: *//p' "$2/fuzz/$4.log") runs, $(sed -n 's/^stat::average_exec_per_sec: *//p' "$2/fuzz/$4.log") a second"
  else
    tail -n 40 "$2/fuzz/$4.log"
    echo "$4: FAILED"
    return 1
  fi
}
export -f one
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I{} bash -c 'one "$@"' _ "$here" "$build" "$seconds" {}
