#!/bin/sh
# What glimt accuracy and glimt compare write, and how they end. usage: accuracy_test.sh GLIMT
# Sizes are tiny: no time is judged here.
set -eu

glimt=$1
. "$(dirname -- "$0")/../command_test.sh"

# ends STATUS WORDS COMMAND ARGUMENT...: that exit status, and one line on standard error that holds
# the words.
ends() {
  wanted=$1
  words=$2
  shift 2
  status=0
  "$glimt" "$@" >"$folder/out" 2>"$folder/errors" || status=$?
  [ $status -eq "$wanted" ] || fail "$*: exit status $status, not $wanted"
  [ "$(wc -l <"$folder/errors")" -eq 1 ] || fail "$*: not one line: $(cat "$folder/errors")"
  grep -qF -- "$words" "$folder/errors" || fail "$*: no '$words' in $(cat "$folder/errors")"
}

cat >"$folder/scene.obj" <<'END'
mtllib scene.mtl
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
v -1 -1 1
v 1 -1 1
usemtl wall
f 1 2 3 4
f 1 2 6 5
END
printf 'newmtl wall\nKd 0.8 0.5 0.3\n' >"$folder/scene.mtl"
printf '{"model": "scene.obj", "environment": {"color": [1, 1, 1]}}' >"$folder/a scene.scene.json"

accuracy() {
  "$glimt" accuracy "$folder/a scene.scene.json" -o "$folder/report" --size 32x24 --time 4 --quiet "$@"
}
accuracy --bounces 1 || fail "accuracy: exit status $?"
for file in report.html report.json report.csv reference.pfm; do
  [ -s "$folder/report/$file" ] || fail "accuracy: no $file"
done
for key in reference budget noise truncation measured recommended command curves time_factor; do
  grep -q "\"$key\": " "$folder/report/report.json" || fail "report.json: no key '$key'"
done
for curve in "bounces,2" "sampler,random" "clamp,2" "record,wide" "traversal,stack"; do
  grep -q "^$curve," "$folder/report/report.csv" || fail "report.csv: no $curve"
done
grep -q "<svg" "$folder/report/report.html" || fail "report.html: no chart"
grep -q "data:image/png;base64,iVBOR" "$folder/report/report.html" || fail "report.html: no picture"
grep -q "http" "$folder/report/report.html" | grep -v w3.org && fail "report.html: needs a server"

# What is recommended can be pasted.
sed -n 's/.*"command": "glimt \(.*\)",*/\1/p' "$folder/report/report.json" >"$folder/commands"
[ -s "$folder/commands" ] || fail "nothing is recommended"
grep -v -- "--bounces" "$folder/commands" && fail "a command forgets what was asked for"
grep -- "--bounces.*--bounces" "$folder/commands" && fail "a command asks for two things"
tail -1 "$folder/commands" >"$folder/command"
(cd "$folder" && eval "\"$glimt\" $(cat command) --spp 1 --quiet") 2>"$folder/errors" || true
grep -q "takes one value" "$folder/errors" || fail "the command cannot be pasted: $(cat "$folder/errors")"

# What is there is not done again, and what is of something else is.
cp "$folder/report/report.csv" "$folder/before.csv"
rm "$folder/report/clamp-2.json"
accuracy --bounces 1
grep -v "^clamp,2," "$folder/report/report.csv" >"$folder/again.csv"
grep -v "^clamp,2," "$folder/before.csv" | cmp -s - "$folder/again.csv" || fail "measured again"
accuracy --bounces 2
grep "^,," "$folder/report/report.csv" >"$folder/again.csv"
grep "^,," "$folder/before.csv" | cmp -s - "$folder/again.csv" && fail "not measured again"

ends 2 "-o" accuracy "$folder/a scene.scene.json"
ends 3 "no-such" accuracy "$folder/no-such.obj" -o "$folder/report"
ends 3 "5x5" accuracy "$folder/a scene.scene.json" -o "$folder/report" --time 4 --reference "$folder/report/reference.pfm" --size 5x5

a=$folder/report/reference.pfm
b=$folder/report/as-asked-1.pfm
"$glimt" compare "$a" "$b" -o "$folder/difference.png" --threshold 1 >"$folder/out" ||
  fail "compare: exit status $? below the threshold"
grep -q "^FLIP" "$folder/out" || fail "compare: no FLIP"
[ -s "$folder/difference.png" ] || fail "compare: no picture of the difference"
ends 1 "above the threshold" compare "$a" "$b" --metric mse --threshold 0
ends 2 "png" compare "$a" "$b" -o "$folder/difference.pfm"

echo "all passed"
