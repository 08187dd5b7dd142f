#!/bin/sh
# Samples per second at 512 x 512 with 4 secondary bounces: median, least and most of five runs of ten
# seconds each, as rows of a table.
# usage, after ./dev build: tests/bench/samples_per_second.sh SCENE...
set -eu
glimt=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)/build/release/glimt
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo '| scene | triangles | samples/s, median of five | least | most |'
echo '|---|---|---|---|---|'
for scene in "$@"; do
  for run in 1 2 3 4 5; do
    "$glimt" render "$scene" --size 512x512 --bounces 4 --time 10 --quiet \
      -o "$folder/picture.pfm" --json "$folder/$run.json"
  done
  triangles=$(sed -n 's/.*"triangles": \([0-9]*\).*/\1/p' "$folder/1.json")
  for run in 1 2 3 4 5; do
    sed -n 's/.*"samples": \([0-9]*\).*/\1/p; s/.*"render": \([0-9.]*\).*/\1/p' "$folder/$run.json" |
      paste -sd' ' | awk '{ printf "%.2f\n", $1 / $2 }'
  done | sort -n | paste -sd' ' |
    awk -v scene="$(basename "$scene")" -v triangles="$triangles" \
      '{ printf "| %s | %s | %s | %s | %s |\n", scene, triangles, $3, $1, $5 }'
done
