#!/bin/sh
# The viewer under a display of its own, with real mouse and key events. usage: view_test.sh GLIMT
# Nothing is decided by a fixed sleep: each step polls for what it waits for.
set -eu

glimt=$1
patience=60 # seconds that a step may take

for tool in Xvfb xdotool; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

folder=$(mktemp -d "${TMPDIR:-/tmp}/glimt-view-XXXXXX")
server=''
viewer=''

clean_up() {
  [ -z "$viewer" ] || kill "$viewer" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT
trap 'exit 1' HUP INT TERM

fail() {
  echo "FAILED: $*"
  [ ! -s "$folder/errors" ] || sed 's/^/  stderr: /' "$folder/errors"
  [ -z "${window:-}" ] || echo "  title: $(title)"
  exit 1
}

# wait_for WHAT COMMAND...: until the command succeeds.
wait_for() {
  what=$1
  shift
  end=$(($(date +%s) + patience))
  until "$@"; do
    [ "$(date +%s)" -lt $end ] || fail "waited $patience s for $what"
    sleep 0.05
  done
}

# --- A scene, a display, the viewer ---------------------------------------------------------------

write_scene() {
  cat >"$folder/blocks.obj" <<'END'
mtllib blocks.mtl
v -3 0 -3
v 3 0 -3
v 3 0 3
v -3 0 3
v 0 0 0
v 1.2 0 0.4
v 0.5 1.6 0.2
v -1 0 1
v -0.2 0 1.2
v -0.6 1 0.3
usemtl grey
f 4 3 2 1
usemtl red
f 5 6 7
usemtl blue
f 8 9 10
END
  cat >"$folder/blocks.mtl" <<'END'
newmtl grey
Kd 0.6 0.6 0.6
newmtl red
Kd 0.8 0.1 0.1
newmtl blue
Kd 0.1 0.2 0.9
END
  cat >"$folder/blocks.scene.json" <<'END'
{ "model": "blocks.obj",
  "camera": { "position": [0, 2, 5], "target": [0, 0.5, 0], "vertical_fov": 40 },
  "environment": { "color": [0.8, 0.8, 0.8] } }
END
}

start_display() {
  Xvfb -displayfd 3 -screen 0 640x480x24 -nolisten tcp 3>"$folder/display" >/dev/null 2>&1 &
  server=$!
  wait_for "Xvfb" test -s "$folder/display"
  DISPLAY=:$(cat "$folder/display")
  export DISPLAY
  unset WAYLAND_DISPLAY
}

find_window() {
  window=$(xdotool search --onlyvisible --name ' - glimt$' 2>/dev/null) && [ -n "$window" ]
}

start_viewer() {
  # Pictures are saved in the current folder.
  cd "$folder"
  "$glimt" view blocks.scene.json --size 160x120 --bounces 2 2>errors &
  viewer=$!
  wait_for "the window" find_window
}

# --- What the window says, and what is done to it -------------------------------------------------

title() {
  xdotool getwindowname "$window" 2>/dev/null || true
}

# "SAMPLES RATE" of a picture in full size, nothing while the title says something else.
progress() {
  title | tr -d , | sed -n 's|.* - \([0-9]*\) samples\{0,1\} \([0-9]*\)[.0-9]* samples/s - glimt$|\1 \2|p'
}

# Enough samples to compare pictures by, and more than can be made between two looks at the title.
settled() {
  kill -0 "$viewer" 2>/dev/null || fail "the viewer ended"
  # shellcheck disable=SC2046  # words are what is wanted
  set -- $(progress)
  [ $# = 2 ] && [ "$1" -ge 48 ] && [ "$1" -ge $((2 * $2)) ]
}

fewer_than() {
  most=$1
  # shellcheck disable=SC2046  # words are what is wanted
  set -- $(title | tr -d , | sed -n 's|.* - \([0-9]*\) samples\{0,1\} .*|\1|p')
  [ $# = 1 ] && [ "$1" -lt "$most" ]
}

saved() {
  grep -q "^glimt: saved $1," errors && [ -s "$1" ]
}

# save FILE: press S when the picture has settled, and expect it under that name.
save() {
  wait_for "the picture to settle" settled
  press s
  wait_for "$1" saved "$1"
  samples=$(sed -n "s/^glimt: saved $1, \([0-9,]*\) samples\{0,1\}$/\1/p" errors | tr -d ,)
}

# After what should start the picture again.
expect_restart() {
  wait_for "the picture to start again after $1" fewer_than "$samples"
}

press() {
  xdotool windowfocus "$window" key "$1"
}

# drag BUTTON X Y
drag() {
  xdotool mousemove --window "$window" 80 60 mousedown "$1" mousemove_relative -- "$2" "$3" mouseup "$1"
}

mean_square() {
  "$glimt" compare "$1" "$2" --json - | sed -n 's/.*"mse": *\([^,]*\),.*/\1/p'
}

expect_same() {
  mse=$(mean_square "$1" "$2")
  echo "$1 and $2: $mse, $3"
  awk "BEGIN { exit !($mse < 0.0002) }" || fail "$3: $1 and $2 differ"
}

expect_different() {
  mse=$(mean_square "$1" "$2")
  echo "$1 and $2: $mse, $3"
  awk "BEGIN { exit !($mse > 0.002) }" || fail "$3: $1 and $2 are the same"
}

# --- The tests ------------------------------------------------------------------------------------

test_mouse_and_keys() {
  save blocks.png

  drag 1 -40 10
  expect_restart "a drag"
  save blocks-2.png
  expect_different blocks-2.png blocks.png "a drag orbits"

  press r
  expect_restart "R"
  save blocks-3.png
  expect_same blocks-3.png blocks.png "R resets"

  xdotool mousemove --window "$window" 80 60 click 4 click 4 click 4
  expect_restart "the wheel"
  save blocks-4.png
  expect_different blocks-4.png blocks.png "the wheel zooms"

  press r
  xdotool keydown shift
  drag 1 30 -20
  xdotool keyup shift
  expect_restart "a drag with shift"
  save blocks-5.png
  expect_different blocks-5.png blocks.png "a drag with shift pans"

  press r
  drag 3 30 -20
  expect_restart "a drag with the right button"
  save blocks-6.png
  expect_same blocks-6.png blocks-5.png "the right button pans like shift"
}

test_resize() {
  xdotool windowsize "$window" 300 200
  expect_restart "a resize"
  save blocks-7.png
  # Width and height stand in the file's bytes 16 to 23.
  size=$(od -An -tu1 -j16 -N8 blocks-7.png | tr -s ' ')
  [ "$size" = " 0 0 1 44 0 0 0 200" ] || fail "resized to 300x200, saved (bytes)$size"
  echo "blocks-7.png: 300x200"
}

gone() {
  ! kill -0 "$viewer" 2>/dev/null
}

test_escape() {
  press Escape
  wait_for "the viewer to end" gone
  status=0
  wait "$viewer" || status=$?
  viewer=''
  window=''
  [ $status = 0 ] || fail "Esc ended the viewer with status $status"
}

# expect_error STATUS TEXT COMMAND...: one line on standard error, nothing on standard output.
expect_error() {
  wanted=$1
  text=$2
  shift 2
  status=0
  env -u DISPLAY -u WAYLAND_DISPLAY "$@" >output 2>errors || status=$?
  [ $status = "$wanted" ] || fail "$*: status $status, not $wanted"
  [ ! -s output ] || fail "$*: wrote to standard output"
  [ "$(wc -l <errors)" = 1 ] || fail "$*: not one line"
  grep -q "^glimt: .*$text" errors || fail "$*: no '$text' in the message"
  echo "status $status: $(cat errors)"
}

test_errors() {
  expect_error 4 'cannot open a window (.*); use glimt render' "$glimt" view blocks.scene.json
  # Before a window is even tried.
  expect_error 3 'missing.obj' "$glimt" view missing.obj
  expect_error 2 '--camera\|no camera' "$glimt" view blocks.scene.json --camera none
}

# The scene that comes with glimt is found from where the program lies.
test_default_scene() {
  mkdir -p tree/build/release tree/assets
  cp "$glimt" tree/build/release/glimt
  expect_error 2 'glimt view SCENE' tree/build/release/glimt view
  cp blocks.obj blocks.mtl tree/assets
  cp blocks.scene.json tree/assets/default.scene.json
  expect_error 4 'cannot open a window' tree/build/release/glimt view
}

write_scene
start_display
start_viewer
test_mouse_and_keys
test_resize
test_escape
test_errors
test_default_scene
echo "passed"
