#!/bin/sh
# What is lost beyond a bounce limit, against 32 bounces with the same seed, and what the limit costs:
# rows of the table in docs/effects.md.
# usage, after ./dev build: [SAMPLES=32] [SIZE=96x96] [ROUNDS=3] tests/bench/bounces_table.sh SCENE...
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
glimt=$root/build/release/glimt
samples=${SAMPLES:-32}
size=${SIZE:-96x96}
rounds=${ROUNDS:-3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# render SCENE BOUNCES: the picture, and the seconds that its samples took added to a list.
render() {
  "$glimt" render "$1" --bounces "$2" --spp "$samples" --size "$size" --traversal octant-ahead \
    --quiet -o "$folder/$2.pfm" --json "$folder/report.json"
  sed -n 's/.*"render": \([0-9.]*\).*/\1/p' "$folder/report.json" >>"$folder/$2.seconds"
}

median() {
  sort -n "$1" | awk '{ all[NR] = $1 } END { print all[int((NR + 1) / 2)] }'
}

# row SCENE BOUNCES: the mean of the channels' ratios, the root of the relative MSE, the time.
row() {
  "$glimt" compare "$folder/$2.pfm" "$folder/32.pfm" |
    awk -v scene="$(basename "$1")" -v bounces="$2" -v seconds="$(median "$folder/$2.seconds")" \
      -v first="$(median "$folder/4.seconds")" '
      /^mean ratio/ { lost = 1 - ($3 + $4 + $5) / 3 }
      /^relMSE/ { rms = sqrt($2) }
      END { printf "| %s | %s | %.2f%% | %.2f%% | %.2f |\n", scene, bounces, 100 * lost,
                   100 * rms, seconds / first }'
}

for scene in "$@"; do
  rm -f "$folder"/*.seconds
  round=0
  # In turns, so that all meet the same load.
  while [ "$round" -lt "$rounds" ]; do
    for bounces in 4 6 8 12 16 32; do render "$scene" "$bounces"; done
    round=$((round + 1))
  done
  for bounces in 4 6 8 12 16; do row "$scene" "$bounces"; done
done
