#!/bin/sh
# The viewer under a display of its own, with real mouse and key events. usage: view_test.sh GLIMT
set -eu

glimt=$1
. "$(dirname -- "$0")/viewer.sh"

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

start_viewer() {
  # Pictures are saved in the current folder.
  cd "$folder"
  "$glimt" view blocks.scene.json --size 160x120 --bounces 2 2>errors &
  viewer=$!
  wait_for "the window" find_window
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
  xdotool keydown ctrl
  drag 1 30 -20
  xdotool keyup ctrl
  expect_restart "a drag with Ctrl"
  save blocks-5.png
  expect_different blocks-5.png blocks.png "a drag with Ctrl pans"

  # The camera is then where it was before, and both at once would change nothing.
  press r
  expect_restart "R"
  drag 3 30 -20
  save blocks-6.png
  expect_same blocks-6.png blocks-5.png "the right button pans like Ctrl"
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
}

# What is wrong with the first scene ends the viewer, as there is no other to show.
test_first_scene() {
  printf 'v 0 0 0\nf 1 2 9\n' >broken.obj
  for arguments in "broken.obj" "blocks.scene.json --camera none"; do
    wanted=3
    [ "$arguments" = broken.obj ] || wanted=2
    status=0
    # shellcheck disable=SC2086  # words are what is wanted
    timeout $patience "$glimt" view $arguments 2>errors || status=$?
    [ $status = $wanted ] || fail "view $arguments: status $status, not $wanted"
    [ "$(wc -l <errors)" = 1 ] || fail "view $arguments: not one line"
    echo "status $status: $(cat errors)"
  done
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
test_first_scene
test_default_scene
echo "passed"
