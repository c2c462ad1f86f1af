"""Starts ParaView's window with a script in it, as a new user would find it; returns its exit code.

Usage: start_paraview.py SCRIPT [CHECK...] runs the script's `check_...` functions, or those named.
Environment: VOLUMEBENCH_PLUGIN, the plugin's file, which is not loaded where
VOLUMEBENCH_WITHOUT_PLUGIN is set; VOLUMEBENCH_PARAVIEW, the program; DISPLAY.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from patience import patient_s  # noqa: E402

SIZE = "1500x1000+0+0"
HERE = Path(__file__).resolve().parent
# ParaView gives its script no file name, and goes on when it fails.
BOOT = """
import os, sys, traceback
sys.path[:0] = {folders!r}
try:
    import window
    window.run_script({name!r}, {checks!r})
except BaseException:
    traceback.print_exc(file=sys.__stdout__)
    sys.__stdout__.flush()
    os._exit(1)
"""
SETTINGS = "[General]\nGeneralSettings.ShowWelcomeDialog=false\n"


def start(script: Path, checks: list[str]) -> int:
    """Run ParaView with an empty home; its settings are no one's."""
    with tempfile.TemporaryDirectory(prefix="volumebench-gui-") as home:
        folder = Path(home, ".config", "ParaView")
        folder.mkdir(parents=True)
        (folder / "ParaView5.11.0.ini").write_text(SETTINGS)
        folders = [str(one) for one in (script.parent, HERE, HERE.parent)]
        boot = Path(home, "boot.py")
        boot.write_text(BOOT.format(folders=folders, name=script.stem, checks=checks))
        environment = {
            **os.environ,
            "HOME": home,
            "XDG_CONFIG_HOME": str(folder.parent),
            "XDG_RUNTIME_DIR": home,
        }
        program = os.environ.get("VOLUMEBENCH_PARAVIEW", "paraview")
        command = [program, *plugin(), f"--script={boot}", "-geometry", SIZE]
        done = subprocess.run(command, env=environment, timeout=patient_s(280))
    return done.returncode


def plugin() -> list[str]:
    """Return what loads the plugin, as ./run gui does."""
    path = Path(os.environ["VOLUMEBENCH_PLUGIN"])
    if os.environ.get("VOLUMEBENCH_WITHOUT_PLUGIN"):
        return []
    return [f"--plugin-search-paths={path.parent}", f"--plugins={path.stem}"]


if __name__ == "__main__":
    sys.exit(start(Path(sys.argv[1]).resolve(), sys.argv[2:]))
