#!/usr/bin/env bash
# Makes paraview-window.png: ParaView's window with a real MRI drawn by one of our representations
# and our rows in the Properties panel. For developers, by hand, when the panel has changed; the
# mouse goes to fixed places, so look at the picture afterwards.
#
# Usage: Documentation/make_screenshot.sh [LABEL]     after ./run build
# Needs: paraview, xvfb, xdotool, x11-apps, imagemagick, mricron-data (all Debian packages).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly root
readonly plugin="$root/build/release/lib/paraview-5.11/plugins/VolumeBench/VolumeBench.so"
readonly mri=/usr/share/mricron/templates/ch2.nii.gz
readonly picture="$root/Documentation/paraview-window.png"

folder=$(mktemp -d)
started=()
cleanup() {
  for process in "${started[@]}"; do
    kill "$process" 2>/dev/null || true
    wait "$process" 2>/dev/null || true
  done
  rm -rf "$folder"
}
trap cleanup EXIT

wait_until() {
  local patience=600
  until "$@"; do
    ((patience-- > 0)) || { echo "make_screenshot.sh: gave up on: $*" >&2; exit 1; }
    sleep 0.1
  done
}

# drag FROM_X FROM_Y TO_X TO_Y, in steps that Qt takes for a hand
drag() {
  local step
  xdotool mousemove "$1" "$2"
  sleep 0.3
  xdotool mousedown 1
  for step in 1 2 3 4 5; do
    sleep 0.1
    xdotool mousemove $(($1 + ($3 - $1) * step / 5)) $(($2 + ($4 - $2) * step / 5))
  done
  sleep 0.2
  xdotool mouseup 1
  sleep 4
}

# An X server that takes a free display number and tells it.
Xvfb -displayfd 3 -noreset -screen 0 1600x1000x24 3>"$folder/display" 2>/dev/null &
started+=($!)
wait_until test -s "$folder/display"
DISPLAY=:$(<"$folder/display")
export DISPLAY

# A home without settings, so that the window looks like a new user's.
export HOME="$folder/home" XDG_CONFIG_HOME="$folder/home/.config" XDG_RUNTIME_DIR="$folder"
mkdir -p "$XDG_CONFIG_HOME/ParaView"
printf '[General]\nGeneralSettings.ShowWelcomeDialog=false\n' \
  >"$XDG_CONFIG_HOME/ParaView/ParaView5.11.0.ini"

gunzip -c "$mri" >"$folder/brain-mri.nii"
export VOLUMEBENCH_PLUGIN="$plugin" VOLUMEBENCH_SOURCE="$root" VOLUMEBENCH_READY="$folder/ready"
export VOLUMEBENCH_VOLUME="$folder/brain-mri.nii" VOLUMEBENCH_LABEL="${1:-Volume Slices Threaded}"
paraview --script="$root/Documentation/make_screenshot.py" -geometry 1600x1000+0+0 \
  >"$folder/log" 2>&1 &
started+=($!)
wait_until test -e "$folder/ready"
sleep 8 # while it draws, the window takes no notice of the mouse

drag 297 700 460 700 # a wider panel
drag 146 434 146 220 # a lower pipeline browser
# The search shows our group alone, advanced rows too.
xdotool mousemove 130 338 click 1
sleep 1
xdotool type "volume techniques"
sleep 5
xdotool mousemove 161 700 # Estimate Error, below the rows of Volume Slices Threaded
sleep 1
xdotool mousedown 1
sleep 0.3
xdotool mouseup 1
sleep 90 # the exact picture takes half a minute on two cores
xdotool mousemove 800 960
sleep 1

xwd -root | convert xwd:- -strip -define png:compression-level=9 "png24:$picture"
echo "$picture: $(stat -c %s "$picture") bytes"
