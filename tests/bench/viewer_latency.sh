#!/bin/sh
# How fast the window answers while a hand turns the camera: usage: viewer_latency.sh GLIMT SHARED
# Needs a machine that has nothing else to do: the load that it tells first should be below 0.5.
# A row of docs/viewer.md for each scene, from a window of 1280 x 720 under an X server of its own.
# An event's latency ends when the picture that shows what it did is on the screen; one that came
# while the window was busy counts from when it can have come at the earliest.
set -eu

glimt=$1
shared=$2
seconds=6 # of turning

folder=$(mktemp -d "${TMPDIR:-/tmp}/glimt-latency-XXXXXX")
server=''
viewer=''
clean_up() {
  [ -z "$viewer" ] || kill "$viewer" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT
trap 'exit 1' HUP INT PIPE TERM

Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp -noreset 3>"$folder/display" >/dev/null 2>&1 &
server=$!
until [ -s "$folder/display" ]; do sleep 0.05; done
DISPLAY=:$(cat "$folder/display")
export DISPLAY
unset WAYLAND_DISPLAY

# Some samples in full size: by then the driver has compiled what a picture takes.
has_picture() {
  xdotool getwindowname "$window" | grep -q ' - \([3-9]\|[1-9][0-9,]\{1,\}\) samples, [0-9.]* samples/s - '
}

# To and fro, from one process, so that the hand takes no time from what is measured.
turn() {
  set -- mousemove --window "$window" 800 360 mousedown 1
  step=0
  while [ $step -lt $((50 * seconds)) ]; do
    step=$((step + 1))
    if [ $((step % 80)) -lt 40 ]; then x=5; else x=-5; fi
    set -- "$@" mousemove_relative -- $x 0 sleep 0.02
  done
  xdotool "$@" mouseup 1
}

figure() {
  sed -n "/\"$1\"/,/}/s/.*\"$2\": *\([0-9.]*\).*/\1/p" "$folder/report.json"
}

measure() {
  "$glimt" view "$2" --json "$folder/report.json" 2>/dev/null &
  viewer=$!
  until window=$(xdotool search --onlyvisible --name ' - glimt$' 2>/dev/null) && [ -n "$window" ]; do
    sleep 0.1
  done
  until has_picture; do sleep 0.1; done
  turn
  xdotool windowfocus "$window" key Escape
  wait "$viewer"
  viewer=''
  printf '| %s | %s | %s | %s | %s | %s |\n' "$1" "$(figure latency_ms median)" \
    "$(figure latency_ms p95)" "$(figure latency_ms max)" \
    "$(awk "BEGIN { printf \"%.0f\", 1000 / $(figure frame_ms median) }")" "$(figure frame_ms p95)"
}

echo "load of the machine before: $(cut -d' ' -f1-3 /proc/loadavg)"
echo '| scene | event to picture, median ms | 95% below, ms | longest, ms | pictures a second | 95% of the gaps below, ms |'
echo '|---|---|---|---|---|---|'
measure cornell "$shared/reference/cornell.scene.json"
measure knot "$shared/reference/knot.scene.json"
measure ToyCar "$shared/models/gltf/ToyCar/ToyCar.gltf"
measure MetalRoughSpheresNoTextures \
  "$shared/models/gltf/MetalRoughSpheresNoTextures/MetalRoughSpheresNoTextures.glb"
