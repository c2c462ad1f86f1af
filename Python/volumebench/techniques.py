"""What Python knows of each technique: its id, representation label and the paths it can take."""

import re
from dataclasses import dataclass
from pathlib import Path

from .errors import StudyError

ENGINE = "engine"
VIEW = "view"
INTERACTIVE = "interactive"
REMOTE = "remote"
DEFAULT_PATHS = (ENGINE, VIEW, INTERACTIVE)  # a server has to be asked for
PATHS = (*DEFAULT_PATHS, REMOTE)
REFERENCE_TECHNIQUE = "single-pass"
PARAVIEW = "paraview-volume"

_PLUGIN_LIST = Path(__file__).resolve().parents[2] / "Plugin" / "Techniques.cmake"
_PLUGIN_ROW = re.compile(
    r'^\s*volumebench_technique\(\s*([\w-]+)[^)]*\bLABEL\s+"Volume ([^"]+)"', re.M
)


@dataclass(frozen=True)
class Technique:
    """One contestant. A peer has no integrator or step that a study could set."""

    id: str
    title: str
    peer: bool = False
    paths: tuple[str, ...] = PATHS

    @property
    def representation(self) -> str:
        """Return the label in ParaView's Representation list."""
        return "Volume" if self.peer else f"Volume {self.title}"


_OURS = {
    "single-pass": "Single Pass",
    "multi-pass": "Multi Pass",
    "compute": "Compute",
    "slices": "Slices",
    "slices-threaded": "Slices Threaded",
    "opencl": "OpenCL",
    "cuda": "CUDA",
    "reference": "Reference",
}
_PEERS = (
    Technique(PARAVIEW, "ParaView Volume", True, (VIEW, INTERACTIVE, REMOTE)),
    Technique("vtk-gpu", "VTK GPU mapper", True, (ENGINE,)),
    Technique("vtk-fixed-point", "VTK fixed-point mapper", True, (ENGINE,)),
)


def techniques_of_plugin(text: str) -> dict[str, str]:
    """Return id and title of each row in the text of Plugin/Techniques.cmake."""
    return dict(_PLUGIN_ROW.findall(text))


def _all_techniques() -> dict[str, Technique]:
    """Join the published ids with the rows of the plugin, which may hold newer ones."""
    titles = dict(_OURS)
    if _PLUGIN_LIST.is_file():
        titles |= techniques_of_plugin(_PLUGIN_LIST.read_text(encoding="utf-8"))
    ours = {name: Technique(name, title) for name, title in titles.items()}
    return ours | {peer.id: peer for peer in _PEERS}


TECHNIQUES = _all_techniques()


def find_technique(technique_id: str, where: str) -> Technique:
    """Return the technique, or raise an error that lists the known ones."""
    if technique_id not in TECHNIQUES:
        known = ", ".join(TECHNIQUES)
        raise StudyError(f'{where}: unknown technique "{technique_id}"; known: {known}')
    return TECHNIQUES[technique_id]
