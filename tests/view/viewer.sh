# What the tests of the viewer share, read by them: a display of its own, a window, and how to wait.
# Nothing is decided by a fixed sleep: each step polls for what it waits for.

patience=60              # seconds that a step may take
screen=${screen:-640x480} # of the display
enough=${enough:-48}      # samples that pictures can be compared by,
most_same=${most_same:-0.0002} # and the mean square that their noise stays below; ten times that is
                               # another picture

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
trap 'exit 1' HUP INT PIPE TERM

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

start_display() {
  Xvfb -displayfd 3 -fbdir "$folder" -screen 0 "${screen}x24" -nolisten tcp -noreset 3>"$folder/display" >/dev/null 2>&1 &
  server=$!
  wait_for "Xvfb" test -s "$folder/display"
  DISPLAY=:$(cat "$folder/display")
  export DISPLAY
  unset WAYLAND_DISPLAY
}

find_window() {
  window=$(xdotool search --onlyvisible --name ' - glimt$' 2>/dev/null) && [ -n "$window" ]
}

# --- What the window says, and what is done to it -------------------------------------------------

title() {
  xdotool getwindowname "$window" 2>/dev/null || true
}

# Byte OFFSET of what is on the screen, as a number; as many bytes as COUNT, the first the highest.
screen_bytes() {
  od -An -tu1 -j"$1" -N"$2" "$folder/Xvfb_screen0" | awk '{ for (i = 1; i <= NF; ++i) n = 256 * n + $i; print n }'
}

# "RED GREEN BLUE" at X Y, whose file (XWD) tells in its header where its lines are.
pixel() {
  lines=$(($(screen_bytes 0 4) + 12 * $(screen_bytes 76 4)))
  od -An -tu1 -j$((lines + $2 * $(screen_bytes 48 4) + 4 * $1)) -N3 "$folder/Xvfb_screen0" |
    awk '{ print $3, $2, $1 }'
}

# reddish X Y, bluish X Y
reddish() {
  # shellcheck disable=SC2046  # words are what is wanted
  set -- $(pixel "$1" "$2")
  [ "$1" -gt $(($3 + 20)) ]
}
bluish() {
  # shellcheck disable=SC2046  # words are what is wanted
  set -- $(pixel "$1" "$2")
  [ "$3" -gt $(($1 + 20)) ]
}

# "SAMPLES RATE" of a picture in full size, nothing while the title says something else.
progress() {
  title | tr -d , | sed -n 's|.* - \([0-9]*\) samples\{0,1\} \([0-9]*\)[.0-9]* samples/s - glimt$|\1 \2|p'
}

# Enough samples to compare pictures by, and more than can be made between two looks at the title. That
# title's are $samples; it may be behind the picture, but as long as that goes on it never says fewer.
settled() {
  kill -0 "$viewer" 2>/dev/null || fail "the viewer ended"
  # shellcheck disable=SC2046  # words are what is wanted
  set -- $(progress)
  [ $# = 2 ] && [ "$1" -ge "$enough" ] && [ "$1" -ge $((2 * $2)) ] && samples=$1
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
  grep "^glimt: saved $1," errors
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
  awk "BEGIN { exit !($mse < $most_same) }" || fail "$3: $1 and $2 differ"
}

expect_different() {
  mse=$(mean_square "$1" "$2")
  echo "$1 and $2: $mse, $3"
  awk "BEGIN { exit !($mse > 10 * $most_same) }" || fail "$3: $1 and $2 are the same"
}

gone() {
  ! kill -0 "$viewer" 2>/dev/null
}
