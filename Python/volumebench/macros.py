"""Writes the macros of ParaView that exchange transfer functions: python3 Python/macros.py [FOLDER]."""

import os
import sys
from pathlib import Path

from .errors import BenchError
from .json_file import make_writable_folder, write_atomically

PACKAGE_PARENT = Path(__file__).resolve().parents[1]
# The macro's name in ParaView, and what it calls.
MACROS = {
    "import_transfer_functions": "import_presets",
    "export_transfer_function": "export_active_function",
}
_TEXT = '''"""Written by ./run macros of VolumeBench, whose README tells what it does."""

import sys
from pathlib import Path

if {package!r} not in sys.path:
    sys.path.insert(0, {package!r})

from volumebench.paraview_functions import {function}

{function}(Path({folder!r}))
'''


def macro_folder() -> Path:
    """Return where ParaView looks for the macros of this user."""
    settings = os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config"
    return Path(settings) / "ParaView" / "Macros"


def write_macros(folder: Path) -> list[Path]:
    """Write all macros; they exchange files with the folder TransferFunctions beside this one."""
    make_writable_folder(folder)
    functions = folder.resolve().parent / "TransferFunctions"
    make_writable_folder(functions)
    paths = []
    for name, function in MACROS.items():
        text = _TEXT.format(
            package=str(PACKAGE_PARENT), function=function, folder=str(functions)
        )
        paths.append(folder / f"{name}.py")
        write_atomically(paths[-1], text)
    return paths


def main(arguments: list[str]) -> int:
    """Run the command line; bad input is one line on stderr and exit code 2."""
    if len(arguments) > 1:
        print("error: give one folder, or none", file=sys.stderr)
        return 2
    folder = Path(arguments[0]) if arguments else macro_folder()
    try:
        for path in write_macros(folder):
            print(path)
    except BenchError as fault:
        print(f"error: {fault}", file=sys.stderr)
        return 2
    functions = folder.resolve().parent / "TransferFunctions"
    print(f"Put .tfi and .json files into {functions}, then restart ParaView.")
    return 0
