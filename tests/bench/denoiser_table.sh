#!/bin/sh
# What the denoiser brings and costs: rows of the table in docs/denoiser.md, of scenes that have a
# reference beside them, NAME.scene.json and NAME.pfm.
# usage, after ./dev build: [SAMPLES="4 16 64"] tests/bench/denoiser_table.sh SCENE...
set -eu
glimt=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)/build/release/glimt
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# compared NAME REFERENCE: mean ratio of green, relMSE and FLIP.
compared() {
  "$glimt" compare "$folder/$1.exr" "$2" |
    awk '/^mean ratio/ { mean = $4 } /^relMSE/ { relmse = $2 } /^FLIP/ { flip = $2 }
         END { printf "%.4f %.4f %.3f\n", mean, relmse, flip }'
}

seconds() {
  sed -n "s/.*\"$1\": \\([0-9.]*\\).*/\\1/p" "$folder/denoised.json" | head -n 1
}

echo '| scene | samples | relMSE | denoised | FLIP | denoised | mean, denoised / not | rendering, s | denoising, s |'
echo '|---|---:|---:|---:|---:|---:|---:|---:|---:|'
for scene in "$@"; do
  reference=${scene%.scene.json}.pfm
  name=$(basename "$scene" .scene.json)
  for samples in ${SAMPLES:-4 16 64}; do
    "$glimt" render "$scene" --size 256x256 --spp "$samples" --quiet -o "$folder/plain.exr"
    "$glimt" render "$scene" --size 256x256 --spp "$samples" --quiet --denoise \
      -o "$folder/denoised.exr" --json "$folder/denoised.json"
    echo "$(compared plain "$reference") $(compared denoised "$reference")" \
      "$(seconds render) $(seconds denoise)" |
      awk -v name="$name" -v samples="$samples" '{
        printf "| %s | %s | %s | %s | %s | %s | %.4f | %.1f | %.2f |\n",
               name, samples, $2, $5, $3, $6, $4 / $1, $7, $8 }'
  done
done
