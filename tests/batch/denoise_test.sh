#!/bin/sh
# Denoised pictures say so, wherever they come from; the noise that is told is that of the samples.
# usage: denoise_test.sh GLIMT
set -eu

glimt=$1
. "$(dirname -- "$0")/../command_test.sh"

write_room

render() {
  "$glimt" render "$folder/room.obj" --eye 0,0,3 --target 0,0,0 --size 24x24 --spp 16 "$@"
}

# told NAME KEY: the line of a report that has it.
told() {
  grep "\"$2\"" "$folder/$1.json"
}

render -o "$folder/plain.png" -o "$folder/plain.exr" --json "$folder/plain.json" --quiet
render -o "$folder/denoised.png" -o "$folder/denoised.exr" -o "$folder/denoised.hdr" \
  --json "$folder/denoised.json" --denoise --layers albedo 2>"$folder/said"
grep -q ", denoised in " "$folder/said" || fail "the end message does not say that it is denoised"
told plain denoised | grep -q false || fail "a picture that is not denoised is said to be"
told denoised denoised | grep -q true || fail "the report does not say that it is denoised"
[ "$(told plain relative)" = "$(told denoised relative)" ] || fail "the noise is another one"
for kind in png exr hdr; do
  "$glimt" compare "$folder/denoised.$kind" "$folder/plain.exr" >"$folder/difference"
  grep -q "^denoised    the first picture" "$folder/difference" || fail "a .$kind does not tell"
done
"$glimt" compare "$folder/plain.png" "$folder/plain.exr" >"$folder/difference"
! grep -q denoised "$folder/difference" || fail "a picture tells what it is not"
grep -q undenoised.R "$folder/denoised.exr" || fail "the layers lack the samples' picture"
! cmp -s "$folder/plain.png" "$folder/denoised.png" || fail "nothing was denoised"

ends 2 "cannot say that its picture is denoised" render "$folder/room.obj" --denoise -o "$folder/a.pfm"
ends 2 "denoise" render "$folder/room.obj" --denoise --samples 0:4 -o "$folder/a.exr"

cat >"$folder/job.json" <<'JSON'
{ "scene": "room.obj", "sizes": [[16, 16]], "spp": 8, "denoise": true }
JSON
ends 0 "1 picture made" batch "$folder/job.json"
told job/manifest denoised | grep -q true || fail "the manifest does not tell"
grep -q "denoised" "$folder/job/contact-sheet.html" || fail "the contact sheet does not tell"
sed -i 's/true/false/' "$folder/job.json"
ends 0 "1 picture made" batch "$folder/job.json"
! told job/manifest denoised >/dev/null || fail "the manifest tells what is not so"
sed -i 's/"denoise": false/"denoise": true, "formats": ["pfm"]/' "$folder/job.json"
ends 3 'denoise must be false where a format is pfm' batch "$folder/job.json"

echo "all passed"
