"""A stability study: which techniques and integrators are tried with which numbered cases."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from .errors import StudyError
from .json_file import check_schema, read_json
from .techniques import ENGINE, find_technique

KIND = "stability"


@dataclass(frozen=True)
class StabilityStudy:
    """Empty lists stand for all that the plugin has; `short` leaves out what takes long."""

    name: str
    description: str = ""
    techniques: tuple[str, ...] = ()
    integrators: tuple[str, ...] = ()
    cases: tuple[int, ...] = ()
    short: bool = False
    shortened: "StabilityStudy | None" = None  # what the study itself calls quick

    def quick(self) -> "StabilityStudy":
        """Return the study as --quick runs it."""
        return replace(self.shortened or self, short=True)

    def only(self, techniques: list[str]) -> "StabilityStudy":
        """Return the study with these techniques in place of its own."""
        if not techniques:
            raise StudyError(f"study {self.name}: no run is left")
        for technique in techniques:
            _check_technique(technique, "--techniques")
        shortened = self.shortened and replace(
            self.shortened, techniques=tuple(techniques)
        )
        return replace(self, techniques=tuple(techniques), shortened=shortened)


def is_stability_study(path: Path) -> bool:
    """Tell whether the file is a study of this kind."""
    document = read_json(path)
    return isinstance(document, dict) and document.get("kind") == KIND


def load_stability_study(path: Path) -> StabilityStudy:
    """Read, validate and return a stability study."""
    document = read_json(path)
    check_schema(document, "stability_study_schema.json", path)
    quick = document.get("quick")
    shortened = _study_from(document | quick, path) if quick is not None else None
    return replace(_study_from(document, path), shortened=shortened)


def _study_from(document: dict[str, Any], path: Path) -> StabilityStudy:
    for technique in document.get("techniques", []):
        _check_technique(technique, f'{path}: "techniques"')
    return StabilityStudy(
        name=document["name"],
        description=document.get("description", ""),
        techniques=tuple(document.get("techniques", [])),
        integrators=tuple(document.get("integrators", [])),
        cases=tuple(document.get("cases", [])),
    )


def _check_technique(technique: str, where: str) -> None:
    if ENGINE not in find_technique(technique, where).paths:
        raise StudyError(
            f'{where}: "{technique}" cannot be tried: it is drawn in ParaView\'s views only'
        )
