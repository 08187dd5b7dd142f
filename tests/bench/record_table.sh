#!/bin/sh
# What packing the hit record costs in accuracy and spares in time: rows of the table in
# docs/hit-record.md, and docs/images/record-difference-SCENE.png.
# usage, after ./dev test: [SAMPLES=4096] [SIZE=128x128] [PAIRS=5] tests/bench/record_table.sh SCENE...
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
glimt=$root/build/release/glimt
difference=$root/build/release/record_difference
samples=${SAMPLES:-4096}
size=${SIZE:-128x128}
pairs=${PAIRS:-5}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# render SCENE RECORD SAMPLES NAME: both in a context of ES 3.0, with the same seed.
render() {
  "$glimt" render "$1" --gles 3 --record "$2" --spp "$3" --size "$size" --seed 1 --quiet \
    -o "$folder/$4.pfm" --json "$folder/$4.json"
}

# milliseconds NAME: of one sample.
milliseconds() {
  sed -n 's/.*"samples": \([0-9]*\).*/\1/p; s/.*"render": \([0-9.]*\).*/\1/p' "$folder/$1.json" |
    paste -sd' ' | awk '{ printf "%.3f\n", 1000 * $2 / $1 }'
}

median() {
  sort -n | awk '{ all[NR] = $1 } END { print all[int((NR + 1) / 2)] }'
}

# Packed and wide in turns, so that both meet the same load.
timesOf() {
  pair=0
  while [ "$pair" -lt "$pairs" ]; do
    for record in packed wide; do
      render "$1" "$record" 128 "time-$record"
      milliseconds "time-$record" >>"$folder/$2-$record.times"
    done
    pair=$((pair + 1))
  done
  packed=$(median <"$folder/$2-packed.times")
  wide=$(median <"$folder/$2-wide.times")
  ratio=$(paste "$folder/$2-wide.times" "$folder/$2-packed.times" | awk '{ print $1 / $2 }' | median)
  printf '%s | %s | %.2f' "$packed" "$wide" "$ratio"
}

echo '| scene | difference of the mean, r, g, b, % | its standard deviation, % | correlation of neighbours (in deviations) | energy of 8 x 8 blocks | of 16 x 16 | white in the picture, % of the mean | packed, ms a sample | wide | wide / packed |'
echo '|---|---|---|---|---|---|---|---|---|---|'
for scene in "$@"; do
  name=$(basename "$scene" .scene.json)
  render "$scene" packed "$samples" packed
  render "$scene" wide "$samples" wide
  cells=$("$difference" "$folder/packed.pfm" "$folder/wide.pfm" \
    "$root/docs/images/record-difference-$name.png")
  echo "| $name, $size, $samples samples | $cells | $(timesOf "$scene" "$name") |"
done
