#!/bin/sh
# SIGINT and SIGTERM at any moment of `glimt render` leave whole files or none. usage:
# signals_test.sh GLIMT [RUNS [SECONDS [SEED]]]
set -eu

glimt=$1
runs=${2:-40}
most_seconds=${3:-40}
seed=${4:-7}
. "$(dirname -- "$0")/../command_test.sh"
outputs="$folder/out/a.png $folder/out/b.exr $folder/out/c.pfm $folder/out/d.hdr"
report=$folder/out/report.json
mkdir "$folder/out" "$folder/old"

fail() {
  echo "FAILED: run $run, signal $signal after $moment s: $*"
  sed 's/^/  /' "$folder/errors"
  exit 1
}

milliseconds() { echo $(($(date +%s%N) / 1000000)); }

write_room

# render SIZE: becomes the program. Shells start what runs in the background with SIGINT ignored.
render() {
  set -- --size "$1" --spp 6 --quiet --json "$report"
  for output in $outputs; do set -- "$@" -o "$output"; done
  exec env --default-signal=INT "$glimt" render "$folder/room.obj" --eye 0,0,3 --target 0,0,0 "$@" \
    2>"$folder/errors"
}

# whole FILE: it can be read to its end.
whole() {
  case $1 in
    *.json) [ "$(tail -n 1 "$1")" = "}" ] ;;
    *) "$glimt" compare "$1" "$1" >/dev/null 2>&1 ;;
  esac
}

run=0 signal=none moment=0
(render 160x160) || fail "it fails when left alone"
start=$(milliseconds)
(render 160x160)
length=$(($(milliseconds) - start))
for file in $outputs "$report"; do whole "$file" || fail "$file is not whole when left alone"; done
(render 24x24)
cp "$folder/out/"* "$folder/old"

# A line for each run: moment, signal, whether the files are there before, seconds to a second signal.
awk -v runs="$runs" -v length_ms="$length" -v seed="$seed" 'BEGIN {
  srand(seed)
  for (i = 0; i < runs; ++i)
    printf "%.3f %s %d %s\n", rand() * length_ms / 1000, rand() < 0.5 ? "INT" : "TERM", rand() < 0.5,
           rand() < 0.3 ? sprintf("%.3f", rand() * 0.05) : "none"
}' >"$folder/plan"

finished=0 interrupted=0 killed=0 saved=0
end=$(($(milliseconds) + 1000 * most_seconds))
while read -r moment signal before again; do
  [ "$(milliseconds)" -lt "$end" ] || break
  run=$((run + 1))
  rm -f "$folder/out/"*
  [ "$before" = 0 ] || cp "$folder/old/"* "$folder/out"
  render 160x160 &
  pid=$!
  sleep "$moment"
  kill -"$signal" "$pid" 2>/dev/null || true
  if [ "$again" != none ]; then
    sleep "$again"
    kill -"$signal" "$pid" 2>/dev/null || true
  fi
  status=0
  wait "$pid" || status=$?
  case $status in
    0) finished=$((finished + 1)) ;;
    1)
      interrupted=$((interrupted + 1))
      grep -q 'interrupted before the first sample; nothing was written' "$folder/errors" ||
        fail "exit status 1 without saying why"
      ;;
    130 | 143) killed=$((killed + 1)) ;;
    *) fail "exit status $status" ;;
  esac
  for file in $outputs "$report"; do
    if [ ! -e "$file" ]; then
      [ "$before" = 0 ] || fail "$file is gone"
      [ "$status" != 0 ] || fail "$file is missing after exit status 0"
      continue
    fi
    whole "$file" || fail "$file is not whole"
    if ! cmp -s "$file" "$folder/old/${file##*/}"; then
      saved=$((saved + 1))
      [ "$status" != 1 ] || fail "$file was written after all"
    fi
  done
  for file in "$folder/out/".* "$folder/out/"*; do
    case " $outputs $report $folder/out/. $folder/out/.. $folder/out/* " in
      *" $file "*) ;;
      *) fail "$file is left over" ;;
    esac
  done
done <"$folder/plan"
echo "$run runs of up to $length ms: $finished ended with pictures, $interrupted had nothing yet," \
  "$killed were killed; $saved files were written"
