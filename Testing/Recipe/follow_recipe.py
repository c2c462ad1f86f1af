"""Prove that following CONTRIBUTING.md adds a technique, and edits one existing file only.

The build is one without CUDA's toolkit, which loads and says what it lacks.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import recipe
from source_tree import copy_source, digest

PLUGIN = "lib/paraview-5.11/plugins/VolumeBench/VolumeBench.so"
THE_LIST = "Plugin/Techniques.cmake"
# Together less than the test's own time limit, so that the temporary folder is always removed.
CONFIGURE_SECONDS, BUILD_SECONDS, SHOW_SECONDS = 120, 600, 120


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--pvpython", required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="volumebench-recipe-") as folder:
        tree, build = Path(folder) / "source", Path(folder) / "build"
        copy_source(arguments.source, tree)
        steps = recipe.read_steps(
            (tree / "CONTRIBUTING.md").read_text(encoding="utf-8")
        )
        check_edits(steps, tree)
        build_plugin(arguments.cmake, tree, build)
        show(arguments.pvpython, tree, build / PLUGIN, *recipe.id_and_label(steps))


def check_edits(steps: list[recipe.Step], tree: Path) -> None:
    """Follow the recipe; fail unless it edits the list of techniques and only adds otherwise."""
    before = digest(tree)
    recipe.follow(steps, tree)
    after = digest(tree)
    edited = [file for file in before if after.get(file) != before[file]]
    added = sorted(after.keys() - before.keys())
    print("added:", *added)
    print("edited:", *edited)
    assert edited == [THE_LIST], f"the recipe edits {edited}, not {THE_LIST} alone"


def build_plugin(cmake: str, tree: Path, build: Path) -> None:
    """Configure and build without optimisation, which would take minutes; warnings are errors."""
    configure = [
        cmake,
        "-S",
        str(tree),
        "-B",
        str(build),
        "-G",
        "Ninja",
        "-Wno-deprecated",
    ]
    settings = {
        "CMAKE_BUILD_TYPE": "Release",
        "CMAKE_CXX_FLAGS_RELEASE": "-O0 -DNDEBUG",
        "CMAKE_C_FLAGS_RELEASE": "-O0 -DNDEBUG",
        "VOLUMEBENCH_WARNINGS_AS_ERRORS": "ON",
        "BUILD_SHARED_LIBS": "ON",
        "BUILD_TESTING": "OFF",
        "VOLUMEBENCH_CUDA": "OFF",  # a build without CUDA's toolkit is tried as well
        "Python3_EXECUTABLE": sys.executable,
    }
    configure += [f"-D{name}={value}" for name, value in settings.items()]
    run(configure, CONFIGURE_SECONDS)
    run([cmake, "--build", str(build), "--parallel", "2"], BUILD_SECONDS)


def show(pvpython: str, tree: Path, plugin: Path, technique: str, label: str) -> None:
    """Draw with the new technique in ParaView."""
    environment = os.environ | {
        "VOLUMEBENCH_PLUGIN": str(plugin),
        "VOLUMEBENCH_LABEL": label,
        "VOLUMEBENCH_TECHNIQUE": technique,
        "PYTHONPATH": str(tree / "Testing" / "EndToEnd"),
    }
    script = str(tree / "Testing" / "Recipe" / "new_technique.py")
    limit = ["timeout", "--kill-after=10", str(SHOW_SECONDS)]
    print(run([*limit, pvpython, script], SHOW_SECONDS + 15, environment))


def run(
    words: list[str], seconds: int, environment: dict[str, str] | None = None
) -> str:
    """Run a program and return what it said; if it fails, print that and end."""
    finished = subprocess.run(
        words,
        timeout=seconds,
        env=environment,
        text=True,
        errors="replace",
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    if finished.returncode:
        print(finished.stdout[-20000:])
        sys.exit(f"{' '.join(words[:4])} ... ended with {finished.returncode}")
    return finished.stdout


if __name__ == "__main__":
    main()
