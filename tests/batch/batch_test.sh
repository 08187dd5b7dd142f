#!/bin/sh
# What glimt batch makes, makes again and leaves alone. usage: batch_test.sh GLIMT
set -eu

glimt=$1
. "$(dirname -- "$0")/../command_test.sh"
job=$folder/job.json
out=$folder/out

# A triangle with two variants of its material.
python3 - "$folder" <<'PY'
import base64, json, struct, sys
data = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0.2)
material = lambda name, color: {"name": name, "pbrMetallicRoughness": {
    "baseColorFactor": color + [1], "metallicFactor": 0}}
gltf = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "extensionsUsed": ["KHR_materials_variants"],
    "extensions": {"KHR_materials_variants": {"variants": [{"name": "red"}, {"name": "deep blue"}]}},
    "materials": [material("a", [0.8, 0.1, 0.1]), material("b", [0.1, 0.1, 0.8])],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0, "extensions": {
        "KHR_materials_variants": {"mappings": [{"material": 0, "variants": [0]},
                                                {"material": 1, "variants": [1]}]}}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 1, 0.2]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,"
                 + base64.b64encode(data).decode()}]}
open(sys.argv[1] + "/model.gltf", "w").write(json.dumps(gltf))
PY
cat >"$folder/scene.scene.json" <<'END'
{"model": "model.gltf", "environment": {"color": [1, 1, 1]},
 "cameras": {"close": {"position": [0.3, 0.3, 2]}}}
END

# write_job NOISE_OR_SAMPLES: that line among those of the job.
write_job() {
  cat >"$job" <<END
{"scene": "scene.scene.json", "output": "out", "formats": ["png", "pfm"], "variants": "all",
 "cameras": ["close"], "turntable": {"angles": 2, "start": 45}, "sizes": [[24, 16], [12, 8]], $1}
END
}

# Every file has its line in the manifest, with the sum that sha256sum finds.
check_manifest() {
  python3 - "$out" "$1" <<'PY' || fail "the manifest is wrong"
import hashlib, json, os, sys
folder, count = sys.argv[1], int(sys.argv[2])
manifest = json.load(open(folder + "/manifest.json"))
pictures = manifest["pictures"]
assert len(pictures) == count, (len(pictures), count)
assert not manifest["failed"], manifest["failed"]
for picture in pictures:
    data = open(os.path.join(folder, picture["file"]), "rb").read()
    assert hashlib.sha256(data).hexdigest() == picture["sha256"], picture["file"]
    assert "%dx%d" % tuple(picture["size"]) in picture["file"]
    assert ("camera" in picture) != ("angle" in picture)
files = {p for p in os.listdir(folder) if p.endswith((".png", ".pfm"))}
assert files == {p["file"] for p in pictures}, files
PY
}

write_job '"spp": 8'
ends 0 "12 pictures made, 0 up to date" batch "$job"
check_manifest 24
for name in red_close_24x16 deep-blue_close_12x8 red_045_24x16 deep-blue_225_12x8; do
  [ -s "$out/$name.png" ] || fail "there is no $name.png"
done
cmp -s "$out/red_close_24x16.pfm" "$out/deep-blue_close_24x16.pfm" && fail "variants look the same"
cmp -s "$out/red_045_24x16.pfm" "$out/red_225_24x16.pfm" && fail "angles look the same"
grep -q 'deep blue' "$out/contact-sheet.html" || fail "the contact sheet has no variant"
[ "$(grep -o 'data:image/png' "$out/contact-sheet.html" | wc -l)" = 12 ] ||
  fail "the contact sheet does not hold 12 pictures"

# What is kept from picture to picture does not show.
"$glimt" render "$folder/scene.scene.json" --variant "deep blue" --camera close --size 24x16 --spp 8 \
  --quiet -o "$folder/alone.pfm"
cmp "$folder/alone.pfm" "$out/deep-blue_close_24x16.pfm" || fail "glimt render gives another picture"

# glimt render makes a batch without a job.
some=$folder/some
set -- render "$folder/scene.scene.json" --turntable 2 --size 24x16 --spp 8
ends 0 "4 pictures made, 0 up to date" "$@" --variants all -o "$some"
ends 0 "0 pictures made, 2 up to date" "$@" --variant red -o "$some"
[ -s "$some/red_000_24x16.png" ] && [ -s "$some/contact-sheet.html" ] || fail "files are missing"
ends 0 "1 picture made, 0 up to date" render "$folder/scene.scene.json" --variants red --camera close \
  --size 24x16 --spp 8 -o "$folder/close"
cmp "$folder/close/red_24x16.png" "$out/red_close_24x16.png" || fail "render's batch is another one"
ends 2 "name one folder" "$@" --variants all -o "$some.png"
ends 2 "no picture to write" "$@" --variants all
ends 2 "excludes" "$@" --variants all --variant red -o "$some"
ends 2 "excludes" "$@" --layers all -o "$some"
ends 2 "different names" "$@" --variants red,,blue -o "$some"
ends 3 "no variant 'green'" "$@" --variants green -o "$some"

# Only what is out of date is made again.
ends 0 "0 pictures made, 12 up to date" batch "$job"
rm "$out/red_045_12x8.png"
echo damaged >"$out/red_225_12x8.png"
ends 0 "2 pictures made, 10 up to date" batch "$job"
check_manifest 24
sed -i 's/\[0.1, 0.1, 0.8, 1\]/[0.1, 0.7, 0.8, 1]/' "$folder/model.gltf"
ends 0 "made, 0 up to date" batch "$job"
write_job '"spp": 9'
ends 0 "12 pictures made, 0 up to date" batch "$job"

# Parts make together what one process makes.
mv "$out" "$folder/whole"
ends 0 "4 pictures made, 0 up to date" batch "$job" --job-part 1/3
ends 0 "4 pictures made, 0 up to date" batch "$job" --job-part 3/3
ends 0 "4 pictures made, 0 up to date" batch "$job" --job-part 2/3
[ ! -e "$out/manifest.json" ] || fail "a part wrote the manifest of all"
ends 0 "0 pictures made, 12 up to date" batch "$job"
check_manifest 24
for file in "$folder/whole/"*.png "$folder/whole/"*.pfm; do
  cmp "$file" "$out/${file##*/}" || fail "a part's picture is another one"
done
[ "$(find "$out" -name 'manifest*' | wc -l)" = 1 ] || fail "manifests of parts are left"

# A picture that cannot be written does not stop the others.
rm -r "$out"
mkdir -p "$out/red_close_12x8.png"
ends 1 "1 picture of 12 failed" batch "$job" --quiet
[ "$(find "$out" -name '*.png' -type f | wc -l)" = 11 ] || fail "the others were not made"
grep -q '"error"' "$out/manifest.json" || fail "the manifest does not say what failed"
rmdir "$out/red_close_12x8.png"
ends 0 "1 picture made, 11 up to date" batch "$job"
check_manifest 24

# Interrupted at any moment, and again: in the end everything is there, nothing was made twice.
mv "$out" "$folder/left_alone"
write_job '"spp": 1500'
made=0
for moment in 0.1 0.7 0.3 1.1 none; do
  status=0
  if [ $moment = none ]; then
    "$glimt" batch "$job" 2>"$folder/errors" || status=$?
  else
    env --default-signal=INT timeout --signal=INT "$moment" "$glimt" batch "$job" \
      2>"$folder/errors" || status=$?
  fi
  [ ! -e "$out/manifest.json" ] || python3 -m json.tool "$out/manifest.json" >/dev/null ||
    fail "the manifest is not whole after $moment s"
  [ -z "$(find "$out" -name '.glimt*' 2>/dev/null)" ] || fail "a temporary file is left"
  this=$(sed -n 's/.*[ ,]\([0-9]*\) pictures* made.*/\1/p' "$folder/errors")
  made=$((made + ${this:-0}))
done
[ $status = 0 ] || fail "exit status $status when left alone"
check_manifest 24
[ $made = 12 ] || fail "12 pictures were made in $made goes"

echo '{"scene": "scene.scene.json", "sise": 3}' >"$job"
ends 3 'job.json:1: unknown key "sise"; did you mean "sizes"?' batch "$job"
echo '{"scene": "scene.scene.json", "variants": ["green"]}' >"$job"
ends 3 "the scene has no variant 'green'; it has 'red' and 'deep blue'" batch "$job"
echo '{"scene": "no-such.obj"}' >"$job"
ends 3 "no-such.obj" batch "$job"
ends 2 "--job-part takes I/N" batch "$job" --job-part 4/3

echo "all passed"
