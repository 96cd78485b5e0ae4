#!/usr/bin/env bash
# campaign.sh BUILD TARGET [SECONDS]: fuzzes one target from its committed inputs; new inputs go to BUILD/fuzz/found-TARGET, failures to
# BUILD/fuzz/failed-TARGET. campaign.sh --keep BUILD TARGET merges what was found into the committed seeds.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
keep=false
if [ "${1:-}" = --keep ]; then
  keep=true
  shift
fi
build=$(cd "$1" && pwd)
target=$2
found="$build/fuzz/found-$target"
failed="$build/fuzz/failed-$target"
mkdir -p "$found" "$failed" "$here/corpus/$target"
limits=(-entropic=0 -max_len="$("$here/max_len" "$target")" -timeout=60 -rss_limit_mb=2048)
mapfile -t seeds < <("$here/seeds" "$target")
[ -f "$here/$target.dict" ] && limits+=(-dict="$here/$target.dict")
if $keep; then
  # The fewest files that reach the same edges.
  exec "$build/fuzz/fuzz_$target" "${limits[@]}" -set_cover_merge=1 -use_counters=0 -use_cmp=0 "$here/corpus/$target" "$found"
fi
export OSTEON_FUZZ_TALLY=1
export ASAN_OPTIONS="malloc_context_size=2:quarantine_size_mb=32:${ASAN_OPTIONS:-}"  # three times as fast; a replay has long traces
# Leaks are looked for once, at the end.
exec nice -n 10 "$build/fuzz/fuzz_$target" "${limits[@]}" -detect_leaks=0 -len_control=0 -max_total_time="${3:-1200}" -print_final_stats=1 -artifact_prefix="$failed/" \
  "$found" "${seeds[@]}"
