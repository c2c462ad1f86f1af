#!/usr/bin/env bash
# Makes the pictures of Documentation/walk.md anew, on an X server of its own. After ./run build.
# Needs Debian's python3-pyqt5 and imagemagick.
# Usage: Documentation/Build/walk.sh
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
readonly root
: "${VOLUMEBENCH_PLUGIN:=$root/build/release/lib/paraview-5.11/plugins/VolumeBench/VolumeBench.so}"
export VOLUMEBENCH_PLUGIN
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

export VOLUMEBENCH_WALK=$folder/your-volume.mhd VOLUMEBENCH_PICTURES=$root/Documentation/Pictures
mkdir -p "$VOLUMEBENCH_PICTURES"
/usr/bin/python3 "$root/Python/generate.py" lemniscate --dims 40 40 60 --out "$VOLUMEBENCH_WALK"
xvfb-run -a -s "-noreset -screen 0 1500x1000x24" /usr/bin/python3 \
  "$root/Testing/EndToEnd/Gui/start_paraview.py" "$root/Documentation/Build/walk.py"
for picture in "$VOLUMEBENCH_PICTURES"/walk-*.png; do
  convert "$picture" +dither -colors 128 -strip -define png:compression-level=9 "$picture"
done
