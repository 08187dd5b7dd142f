#!/bin/sh
# What glimt bench prints and writes, and how it ends. usage: bench_test.sh GLIMT
# Sizes are tiny: no time is judged here.
set -eu

glimt=$1
. "$(dirname -- "$0")/../command_test.sh"

# refuses WORDS ARGUMENT...: exit status 2, and one line on standard error that holds the words.
refuses() {
  words=$1
  shift
  status=0
  "$glimt" bench "$@" >"$folder/out" 2>"$folder/errors" || status=$?
  [ $status -eq 2 ] || fail "bench $*: exit status $status, not 2"
  [ "$(wc -l <"$folder/errors")" -eq 1 ] || fail "bench $*: not one line: $(cat "$folder/errors")"
  grep -qF -- "$words" "$folder/errors" || fail "bench $*: no '$words' in $(cat "$folder/errors")"
  [ ! -s "$folder/out" ] || fail "bench $*: something on standard output"
}

# reports SUITE KEYS ARGUMENT...: a report with these keys, where every row agrees, and a chart.
reports() {
  suite=$1
  keys=$2
  shift 2
  "$glimt" bench --suite "$suite" --quick --side 16 --triangles 100 "$@" \
    --json "$folder/report.json" --chart "$folder/chart.svg" >"$folder/table" ||
    fail "suite $suite: exit status $?"
  for key in gl_renderer gl_version cores side measurements suite scene triangles traversal gles \
    compile_seconds agrees $keys; do
    grep -q "\"$key\": " "$folder/report.json" || fail "suite $suite: no key '$key'"
  done
  grep -q "\"suite\": \"$suite\"" "$folder/report.json" || fail "suite $suite: names another"
  grep -q '"agrees": false' "$folder/report.json" && fail "suite $suite: a row does not agree"
  grep -q "triangles" "$folder/table" || fail "suite $suite: no table"
  head -c 4 "$folder/chart.svg" | grep -q '<svg' || fail "suite $suite: no chart"
}

refuses "traversal, passes, effects" --suite nothing
refuses "--suite effects" "$folder/scene.obj"
refuses "--suite effects" --suite passes "$folder/scene.obj"
refuses "--bounces" --suite passes --bounces 1,,2
refuses "--bounces" --suite passes --bounces 65
refuses "--side" --side 0
refuses "no-such-folder" --chart "$folder/no-such-folder/chart.svg"

reports traversal "camera_mrays bounce_mrays_least shadow_mrays_most bvh_seconds \
  gpu_bytes_per_triangle different compared reference"
reports passes "bounces variant sample_seconds median least most" --bounces 1
reports effects "bounces effect forced seconds_per_sample seconds_per_sample_least ratio ratio_most \
  compile_seconds_most" --bounces 1

# On one output the report is alone.
"$glimt" bench --suite passes --quick --side 8 --triangles 100 --bounces 0 --json - >"$folder/out"
[ "$(head -c 1 "$folder/out")" = '{' ] || fail "--json -: the report is not alone"

echo "all passed"
