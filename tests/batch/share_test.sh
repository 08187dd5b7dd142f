#!/bin/sh
# Shares of a picture's samples and what they come to together. usage: share_test.sh GLIMT
set -eu

glimt=$1
. "$(dirname -- "$0")/../command_test.sh"

# One wall is a mirror.
write_room mirror
cat >"$folder/room.mtl" <<'MTL'
newmtl white
Kd 0.7 0.6 0.5
newmtl mirror
Kd 0 0 0
Ks 0.9 0.9 0.9
illum 3
newmtl lamp
Kd 0 0 0
Ke 2 2 2
MTL

render() {
  "$glimt" render "$folder/room.obj" --eye 0,0,3 --target 0,0,0 --size 24x24 --quiet "$@"
}

render --spp 256 -o "$folder/whole.pfm"
for first in 0 64 128 192; do render --samples $first:64 -o "$folder/share$first.exr"; done
"$glimt" merge "$folder/share128.exr" "$folder/share0.exr" "$folder/share192.exr" \
  "$folder/share64.exr" -o "$folder/merged.pfm" -o "$folder/merged.exr" --quiet
python3 - "$folder/merged.pfm" "$folder/whole.pfm" <<'PY' || fail "the shares are not the whole"
import array, sys
def pixels(path):
    file = open(path, "rb")
    kind, size, scale = file.readline(), file.readline(), file.readline()
    assert kind == b"PF\n" and float(scale) < 0
    return array.array("f", file.read())
merged, whole = pixels(sys.argv[1]), pixels(sys.argv[2])
assert len(merged) == len(whole) == 3 * 24 * 24
largest = max(abs(a - b) / max(b, 1e-30) for a, b in zip(merged, whole))
print("largest relative difference of a channel: %.2g" % largest)
assert max(whole) > 0.1
# What docs/batch.md promises.
assert largest <= 1e-5, largest
PY

# A merged picture is a share again.
ends 0 "256 samples" merge "$folder/merged.exr" -o "$folder/again.pfm"
cmp "$folder/merged.pfm" "$folder/again.pfm" || fail "a share of one is another picture"
ends 0 "128 samples" merge "$folder/share0.exr" "$folder/share128.exr" -o "$folder/gap.png"
grep -q "samples are missing, there are 0 to 63, 128 to 191" "$folder/errors" ||
  fail "a gap is not told"

ends 3 "share0.exr: has samples in common" merge "$folder/share0.exr" "$folder/share0.exr" -o "$folder/a.exr"
render --samples 64:64 --seed 3 -o "$folder/other.exr"
ends 3 "other.exr: is of another picture" merge "$folder/share0.exr" "$folder/other.exr" -o "$folder/a.exr"
render --spp 1 -o "$folder/plain.exr"
ends 3 "plain.exr: no share of a picture" merge "$folder/plain.exr" -o "$folder/a.exr"
ends 3 "only an .exr has layers" merge "$folder/whole.pfm" -o "$folder/a.exr"
[ ! -e "$folder/a.exr" ] || fail "a picture was written after an error"
ends 2 "--samples takes FIRST:COUNT" render "$folder/room.obj" --samples 3 -o "$folder/a.exr"
ends 2 "is written as .exr" render "$folder/room.obj" --samples 0:3 -o "$folder/a.png"
ends 2 "cannot be merged" render "$folder/room.obj" --samples 0:3 --background transparent -o "$folder/a.exr"

echo "all passed"
