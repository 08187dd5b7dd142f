# What tests of the command line begin with, to be sourced: a folder of their own, $folder, that is gone
# afterwards, and how they fail. $glimt is the program.
folder=$(mktemp -d "${TMPDIR:-/tmp}/glimt-test-XXXXXX")
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "FAILED: $*"
  [ ! -s "$folder/errors" ] || sed 's/^/  /' "$folder/errors"
  exit 1
}

# ends STATUS WORDS COMMAND ARGUMENT...: that exit status, and a last line on standard error that
# holds the words.
ends() {
  wanted=$1
  words=$2
  shift 2
  status=0
  "$glimt" "$@" >"$folder/stdout" 2>"$folder/errors" || status=$?
  [ $status -eq "$wanted" ] || fail "$*: exit status $status, not $wanted"
  tail -n 1 "$folder/errors" | grep -qF -- "$words" || fail "$*: no '$words'"
}

# A room with a lamp, $folder/room.obj, open to the camera. Its right wall is of MATERIAL.
write_room() {
  cat >"$folder/room.obj" <<OBJ
mtllib room.mtl
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
usemtl white
f 1 2 3 4
f 1 2 6 5
f 1 5 8 4
usemtl ${1:-white}
f 2 6 7 3
usemtl lamp
f 4 3 7 8
OBJ
  printf 'newmtl white\nKd 0.7 0.7 0.7\nnewmtl lamp\nKd 0 0 0\nKe 2 2 2\n' >"$folder/room.mtl"
}
