#!/bin/sh
# What `glimt doctor` answers where a context can be had, and where none can. usage:
# doctor_command_test.sh GLIMT
set -eu

glimt=$1
folder=$(mktemp -d "${TMPDIR:-/tmp}/glimt-doctor-XXXXXX")
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "FAILED: $*"
  sed 's/^/  /' "$folder/output" "$folder/errors"
  exit 1
}

# run STATUS COMMAND...: the command, which has to end with this status.
run() {
  wanted=$1
  shift
  status=0
  "$@" >"$folder/output" 2>"$folder/errors" || status=$?
  [ "$status" = "$wanted" ] || fail "exit status $status, not $wanted: $*"
}

run 0 "$glimt" doctor --json "$folder/report.json"
grep -q '^ok .*float targets' "$folder/output" || fail "no row about float targets"
grep -q '"usable": true' "$folder/report.json" || fail "the report does not say usable"
[ "$(grep -c '"verdict"' "$folder/report.json")" -gt 10 ] || fail "too few findings in the report"
[ ! -s "$folder/errors" ] || fail "something on standard error"

run 0 "$glimt" doctor --json -
head -n 1 "$folder/output" | grep -q '^{$' || fail "the report is not alone on standard output"

run 4 env __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null "$glimt" doctor --backend egl
[ "$(wc -l <"$folder/errors")" = 1 ] || fail "the error is not one line"
grep -q 'EGL surfaceless' "$folder/errors" || fail "the error does not name what was tried"
[ ! -s "$folder/output" ] || fail "something on standard output"

run 2 "$glimt" doctor --backend vulkan
echo "as it should be"
