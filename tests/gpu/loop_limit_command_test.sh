#!/bin/sh
# What `glimt render` says of a scene of which a ray has to look at every triangle, where drivers end
# loops early. usage: loop_limit_command_test.sh GLIMT
set -eu

glimt=$1
. "$(dirname -- "$0")/../command_test.sh"

# render TRAVERSAL: its exit status is in $status.
render() {
  status=0
  "$glimt" render "$folder/crowd.obj" -o "$folder/crowd.png" --spp 1 --size 8x8 --bounces 0 \
    --traversal "$1" --json "$folder/report.json" 2>"$folder/errors" || status=$?
}

# 70,000 triangles in one place
{
  printf 'v -1 -1 0\nv 1 -1 0\nv 0 1 0\n'
  yes 'f 1 2 3' | head -n 70000
} >"$folder/crowd.obj"

render linear
[ "$status" = 3 ] || fail "exit status $status, not 3"
grep -q "one loop turn per triangle.*70,000.*ends loops after 65,[0-9]*; use --traversal auto" \
  "$folder/errors" || fail "the error does not say how many turns there are"

render skip
[ "$status" = 0 ] || fail "exit status $status, not 0"
if grep -q '"nonfinite_pixels": 0' "$folder/report.json"; then
  echo "no loop limit here"
else
  grep -q 'lost samples, in the last one .* took more steps than the [0-9,]* this driver allows' \
    "$folder/errors" || fail "the warning does not say why samples were lost"
fi
echo "as it should be"
