#!/usr/bin/env bash
# The window, on a display in memory, with mouse and keys as a user moves them: test.sh PROGRAM DROP
# It looks at what --log prints and at the recorded pictures. DROP is the library that drop.c makes.
set -euo pipefail
program=$1
drop=$2
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
cleanup() {
    kill ${window:-} ${display:-} 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap cleanup EXIT
fail() {
    echo "$*" >&2
    cat "$work"/log* >&2
    exit 1
}

Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp 3>"$work/number" 2>"$work/xvfb.txt" &
display=$!
for ((i = 0; i < 100; ++i)); do [ ! -s "$work/number" ] || break; sleep 0.1; done
export DISPLAY=:$(<"$work/number") LIBGL_ALWAYS_SOFTWARE=1

# No OpenGL 3.3 in this display: nothing can be tested.
status=0
"$program" --frames 1 --size 320x240 >"$work/log" 2>&1 || status=$?
! grep -q 'OpenGL 3.3 is not available' "$work/log" || exit 77
[ $status -eq 0 ] || fail "the window ends with $status"

# Without a display it ends with a message.
status=0
env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER timeout 60 "$program" >"$work/log" 2>&1 || status=$?
[ $status -eq 1 ] || fail "without a display the window ends with $status"
grep -q '^window: ' "$work/log" || fail "without a display the window says nothing"

# wait_for PATTERN: until the program has printed it.
wait_for() {
    for ((i = 0; i < 600; ++i)); do
        ! grep -qE "$1" "$work/log" || return 0
        kill -0 "$window" 2>/dev/null || break
        sleep 0.1
    done
    fail "not printed: $1"
}
mkdir "$work/pictures"
"$program" --size 640x480 --preset 3 --log --record "$work/pictures" >"$work/log" 2>&1 &
window=$!
wait_for '^preset 2 4$'
id=$(xdotool search --sync --onlyvisible --name '^gamephys' | head -n 1)
at() { xdotool mousemove --window "$id" "$@"; }

# Over a cliff of stone, then a rectangle over the picture.
at 320 300
at 150 330
wait_for '^hover [1-9]'
xdotool key r space # no more pictures; the bridge stands still
wait_for '^key 114 '
wait_for '^key 32 '
xdotool keydown Shift_L
at 20 200
xdotool mousedown 1
at 300 300
at 620 470
xdotool mouseup 1 keyup Shift_L
wait_for '^selected [1-9]'
# The deck and the ropes cross the middle: somewhere on the way down the mouse takes a particle.
for y in 180 190 200 210 220 230 240 250 260; do
    at 320 $y
    xdotool mousedown 1
    at 330 $((y - 20))
    xdotool mouseup 1
done
wait_for '^pull '
xdotool key period o v bracketleft
wait_for '^key 91 0.5'
for number in 1 2 4 5 6 7 8; do
    xdotool key $number
    wait_for "^preset $((number - 1)) "
done
xdotool key Escape
status=0
wait "$window" || status=$?
window=
[ $status -eq 0 ] || fail "the window ends with $status"
grep -qE 'frames of far from the origin: ' "$work/log" || fail "it does not say what it did"
[ -s "$work/pictures/frame00000.png" ] || fail "no picture was recorded"
file "$work/pictures/frame00000.png" | grep -q 'PNG image data, 640 x 480' || fail "the picture is of another size"

# Every preset is drawn: its picture has more colours than ground and shadows.
for number in 1 2 3 4 5 6 7 8; do
    mkdir "$work/$number"
    "$program" --preset $number --size 480x360 --frames 2 --record "$work/$number" >"$work/log" 2>&1 || fail "preset $number"
done
# Pillow comes with the system's Python, which need not be the first of the path.
python=/usr/bin/python3
[ -x $python ] || python=python3
$python "$here/variance.py" 23 "$work"/[1-8]/frame00001.png || fail "a preset is not drawn"

# A mesh that is dropped on the window is shown in the preset that is there, if that has a mesh; else in the first.
dropped_on() {
    LD_PRELOAD=$drop DROP=$here/../viewer/octahedron.obj "$program" --preset "$1" --size 320x240 --frames 6 --log >"$work/log" 2>&1
    [ "$(grep -o '^preset [0-9]*' "$work/log" | paste -sd' ')" = "preset $(($1 - 1)) preset $2" ] || fail "a mesh dropped on preset $1"
}
dropped_on 6 5
dropped_on 5 0

# What is no mesh is said, and nothing is shown.
if "$program" "$0" --frames 1 >"$work/log" 2>&1; then fail "a script was taken for a mesh"; fi
