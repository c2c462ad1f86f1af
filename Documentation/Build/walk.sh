#!/usr/bin/env bash
# Makes the pictures of Documentation/walk.md anew, on an X server of its own, by the test that compares them
# with the window (EndToEnd.gui_walk). After ./run build.
# Needs Debian's python3-pyqt5 and imagemagick.
# Usage: Documentation/Build/walk.sh
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
readonly root
: "${VOLUMEBENCH_PLUGIN:=$root/build/release/lib/paraview-5.11/plugins/VolumeBench/VolumeBench.so}"
export VOLUMEBENCH_PLUGIN
export VOLUMEBENCH_PICTURES=$root/Documentation/Pictures PYTHONDONTWRITEBYTECODE=1
xvfb-run -a -s "-noreset -screen 0 1500x1000x24" /usr/bin/python3 \
  "$root/Testing/EndToEnd/Gui/start_paraview.py" "$root/Testing/EndToEnd/Gui/walk.py"
for picture in "$VOLUMEBENCH_PICTURES"/walk-*.png; do
  convert "$picture" -strip -define png:compression-level=9 "png24:$picture" # all colours: a palette shows bands
done
