#!/bin/sh
# What is lost beyond a bounce limit, against 32 bounces with the same seed, and how many rays more
# the limit takes than 4: rows of the table in docs/effects.md.
# usage, after ./dev build: [SAMPLES=32] [SIZE=96x96] tests/bench/bounces_table.sh SCENE...
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
glimt=$root/build/release/glimt
samples=${SAMPLES:-32}
size=${SIZE:-96x96}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# render SCENE BOUNCES
render() {
  "$glimt" render "$1" --bounces "$2" --spp "$samples" --size "$size" --traversal octant-ahead \
    --quiet -o "$folder/$2.pfm" --json "$folder/$2.json"
}

# raysOf BOUNCES: all of them, camera, bounce and shadow.
raysOf() {
  sed -n '/"rays"/,/}/s/.*": \([0-9.e+]*\).*/\1/p' "$folder/$1.json" | awk '{ sum += $1 } END { print sum }'
}

# row SCENE BOUNCES: the mean of the channels' ratios, the root of the relative MSE, the rays.
row() {
  "$glimt" compare "$folder/$2.pfm" "$folder/32.pfm" |
    awk -v scene="$(basename "$1" | sed 's/\..*//')" -v bounces="$2" -v rays="$(raysOf "$2")" \
      -v first="$(raysOf 4)" '
      /^mean ratio/ { lost = 1 - ($3 + $4 + $5) / 3 }
      /^relMSE/ { rms = sqrt($2) }
      END { printf "| %s | %s | %.2f%% | %.2f%% | %.2f |\n", scene, bounces, 100 * lost,
                   100 * rms, rays / first }'
}

for scene in "$@"; do
  for bounces in 4 6 8 12 16 32; do render "$scene" "$bounces"; done
  for bounces in 4 6 8 12 16; do row "$scene" "$bounces"; done
done
