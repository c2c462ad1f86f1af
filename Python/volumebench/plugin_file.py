"""Finds the plugin that is measured."""

import os
from pathlib import Path

from .errors import BenchError

PLUGIN_VARIABLE = "VOLUMEBENCH_PLUGIN"
PLUGIN_NAME = "VolumeBench"
_REPOSITORY = Path(__file__).resolve().parents[2]


def find_plugin(given: str | None) -> Path:
    """Return the plugin: the argument, the environment variable, or the newest build here."""
    for text in (given, os.environ.get(PLUGIN_VARIABLE)):
        if text:
            if not Path(text).is_file():
                raise BenchError(f"plugin {text}: no such file")
            return Path(text)
    pattern = f"build/*/lib/paraview-*/plugins/{PLUGIN_NAME}/{PLUGIN_NAME}.so"
    builds = sorted(
        _REPOSITORY.glob(pattern), key=lambda path: path.stat().st_mtime, reverse=True
    )
    if not builds:
        raise BenchError(
            f"the plugin {PLUGIN_NAME}.so was not found under build/; build it, or give "
            f"--plugin FILE or the environment variable {PLUGIN_VARIABLE}"
        )
    return builds[0]
