#!/bin/sh
# Changing a scene in the viewer: pick, edit, undo, variants, saving, reloading, opening. The panel is
# used as a hand does, by the places of its widgets. usage: edit_test.sh GLIMT
set -eu

glimt=$1
screen=800x560
enough=8
most_same=0.0015
. "$(dirname -- "$0")/viewer.sh"

write_scene() {
  # A triangle of three corners: floats -1, 1 and 0.
  minus='\000\000\200\277'
  plus='\000\000\200\077'
  zero='\000\000\000\000'
  # shellcheck disable=SC2059  # the format is what is written
  printf "$minus$minus$zero$plus$minus$zero$zero$plus$zero" >"$folder/two.bin"
  cat >"$folder/two.gltf" <<'END'
{ "asset": { "version": "2.0" }, "scene": 0, "scenes": [ { "nodes": [0] } ],
  "extensionsUsed": [ "KHR_materials_variants" ],
  "extensions": { "KHR_materials_variants": { "variants": [ { "name": "night" } ] } },
  "nodes": [ { "mesh": 0 } ],
  "meshes": [ { "primitives": [ { "attributes": { "POSITION": 0 }, "material": 0,
    "extensions": { "KHR_materials_variants": { "mappings": [ { "material": 1, "variants": [0] } ] } } } ] } ],
  "materials": [
    { "name": "red", "doubleSided": true, "pbrMetallicRoughness": { "baseColorFactor": [0.8, 0.1, 0.1, 1], "metallicFactor": 0 } },
    { "name": "blue", "doubleSided": true, "pbrMetallicRoughness": { "baseColorFactor": [0.1, 0.1, 0.8, 1], "metallicFactor": 0 } } ],
  "buffers": [ { "uri": "two.bin", "byteLength": 36 } ],
  "bufferViews": [ { "buffer": 0, "byteLength": 36 } ],
  "accessors": [ { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
    "min": [-1, -1, 0], "max": [1, 1, 0] } ] }
END
  write_scene_file 1
}

# write_scene_file STRENGTH, in one go, as editors do that take care.
write_scene_file() {
  cat >"$folder/new" <<END
{ "model": "two.gltf", "environment": { "image": "studio", "strength": $1 },
  "camera": { "position": [0, 0, 4], "target": [0, 0, 0] },
  "cameras": { "far": { "position": [0, 0, 9], "target": [0, 0, 0] } } }
END
  mv "$folder/new" "$folder/two.scene.json"
}

start_viewer() {
  cd "$folder"
  "$glimt" two.scene.json --size 800x560 --bounces 1 2>errors &
  viewer=$!
  wait_for "the window" find_window
  wait_for "the picture to settle" settled
}

# Presses the left button at a place in the window.
click() {
  xdotool mousemove --window "$window" "$1" "$2" click 1
}

# Whether there is something to save, which the title tells by a star.
changed() {
  title | grep -q '^two\* - '
}

# How often the scene was saved.
saves() {
  grep -c '^glimt: saved .*scene.json' errors || true
}

saved_again() {
  [ "$(saves)" -gt "$count" ]
}

# Saves the scene, and whether it then holds what is expected. What was done just before may be done
# only after the keys have come; then it is looked at again.
held_as_expected() {
  count=$(saves)
  press ctrl+s
  wait_for "the scene to be saved" saved_again
  if grep -q "$expected" two-edited.scene.json; then held=yes; else held=''; fi
  [ "$held" = "$holds" ]
}

# The saved scene comes to hold the text, or with a third argument not to.
expect_saved() {
  expected=$1
  holds=${3-yes}
  wait_for "$2" held_as_expected
  echo "$2"
}

test_pick_and_undo() {
  click 568 330
  expect_saved '"metallic"' "a click alone changes nothing" ''
  click 150 "$metallic_y"
  wait_for "the slider" changed
  expect_saved '"metallic"' "a slider changes the material that was clicked"
  grep -q '"red"' two-edited.scene.json || fail "another material was changed"
  press ctrl+z
  expect_saved '"metallic"' "Ctrl-Z takes it back" ''
  press ctrl+y
  expect_saved '"metallic"' "Ctrl-Y does it again"
}

# With as many samples of the same random numbers: what is left are the roundings of the camera in
# the file. Other random numbers show how much is noise.
test_same_as_render() {
  save two.png
  spp=$(sed -n 's/^glimt: saved two.png, \([0-9,]*\) .*/\1/p' errors | tr -d ,)
  "$glimt" render two-edited.scene.json --quiet --spp "$spp" -o rendered.png
  "$glimt" render two-edited.scene.json --quiet --spp "$spp" --seed 1 -o noise.png
  mse=$(mean_square rendered.png two.png)
  noise=$(mean_square rendered.png noise.png)
  echo "the saved scene, rendered: mean square $mse from the window's picture, $noise by noise"
  awk "BEGIN { exit !($mse < 0.01 * $noise) }" || fail "glimt render gives another picture"
}

# Of the look before, on the left, with the variant, on the right of a line that is dragged.
test_compare() {
  press c
  click "$variant_x" "$variant_y"
  wait_for "the look before, on the left" reddish $((middle - 15)) 300
  wait_for "the variant on the right" bluish $((middle + 15)) 300
  xdotool mousemove --window "$window" $middle 100 mousedown 1 mousemove_relative -- 60 0 mouseup 1
  wait_for "the line to be dragged" reddish $((middle + 15)) 300
  wait_for "the picture beyond the line to stay" bluish $((middle + 75)) 300
  press c
  wait_for "the end of the comparison" bluish $((middle - 15)) 300
  echo "C compares with the look before"
}

test_variant() {
  expect_saved '"variant": "night"' "a button chooses the variant"
  save two-2.png
  expect_different two-2.png two.png "the variant is another picture"
}

saved_camera() {
  count=$(saves)
  press ctrl+s
  wait_for "the scene to be saved" saved_again
  sed -n '/"camera"/,/vertical_fov/p' two-edited.scene.json
}

test_reload() {
  xdotool mousemove --window "$window" $middle 100 mousedown 1 mousemove_relative -- 40 0 mouseup 1
  expect_restart "a drag"
  turned=$(saved_camera)
  wait_for "the picture to settle" settled
  write_scene_file 3
  expect_restart "the file was changed"
  [ "$(saved_camera)" = "$turned" ] || fail "the camera did not stay: $(saved_camera)"
  save two-3.png
  expect_different two-3.png two-2.png "a changed file is shown"
}

told_of() {
  grep -q "$1" errors
}

test_bad_file() {
  echo '{ "model": 7 }' >"$folder/two.scene.json"
  wait_for "the message" told_of 'two.scene.json:1: model must be'
  save two-4.png
  expect_same two-4.png two-3.png "a bad file leaves the old scene standing"
}

# Cameras by number, after which the picture is another one.
test_camera() {
  press 1
  expect_restart "the key 1"
  save two-5.png
  expect_different two-5.png two-4.png "a number chooses the file's camera"
}

test_open() {
  sed 's/"red"/"other"/' two.gltf >other.gltf
  press ctrl+o
  wait_for "the field of the path" typing
  xdotool type --delay 20 "$folder/other.gltf"
  xdotool key Return
  wait_for "the other scene" other_shown
  echo "a typed path opens another scene"
}

typing() {
  title | grep -q ', typing - glimt$'
}

other_shown() {
  title | grep -q '^other - [1-9]'
}

test_escape() {
  press Escape
  wait_for "the viewer to end" gone
  wait "$viewer" || fail "Esc ended the viewer with status $?"
  viewer=''
}

# While a large scene is read.
test_quit_while_loading() {
  awk 'BEGIN { for (i = 0; i < 300000; ++i) print "v", i % 600, int(i / 600), i % 7
               for (i = 1; i < 299000; ++i) print "f", i, i + 1, i + 600 }' >large.obj
  "$glimt" view large.obj --size 160x120 2>errors &
  viewer=$!
  wait_for "the window" find_window
  test_escape
  echo "Esc ends the viewer while it loads"
}

# Places in the panel, in pixels.
metallic_y=465
middle=568 # of the picture
variant_x=104
variant_y=334

write_scene
start_display
start_viewer
test_pick_and_undo
test_same_as_render
test_compare
test_variant
test_reload
test_bad_file
test_camera
test_open
test_escape
test_quit_while_loading
echo "passed"
