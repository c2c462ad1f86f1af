"""Settings that only some techniques have: what studies call them and what they may be."""

import re
from dataclasses import dataclass
from typing import Any

Settings = tuple[tuple[str, Any], ...]

_SHAPE = re.compile(r"Auto|[1-9][0-9]{0,3}x[1-9][0-9]{0,3}")
_SLICING = ("slices", "slices-threaded")


@dataclass(frozen=True)
class TechniqueSetting:
    """One setting: its property on filter and representation, who has it, and its values."""

    property: str
    techniques: tuple[str, ...]
    values: tuple[Any, ...] = ()
    expected: str = ""

    def accepts(self, value: Any) -> bool:
        """Tell whether the value is one that the setting can take."""
        if self.values:
            return type(value) is type(self.values[0]) and value in self.values
        return isinstance(value, str) and _SHAPE.fullmatch(value) is not None

    def choice(self) -> str:
        """Return the values for readers."""
        return self.expected or ", ".join(str(value) for value in self.values)


TECHNIQUE_SETTINGS = {
    "work_group_shape": TechniqueSetting(
        "WorkGroupShape", ("compute",), (), "Auto, or WIDTHxHEIGHT such as 16x8"
    ),
    "slice_extent": TechniqueSetting(
        "SliceExtent", _SLICING, ("Vertex Depth", "Vertex Distance", "Central Ray")
    ),
    "slice_threads": TechniqueSetting(
        "SliceThreads", ("slices-threaded",), (0, 1, 2, 4, 8, 16)
    ),
    "slice_target": TechniqueSetting(
        "SliceTarget", _SLICING, ("RGBA32F", "RGBA16F", "RGBA8")
    ),
    "slice_order": TechniqueSetting(
        "SliceOrder", _SLICING, ("Front to Back", "Back to Front")
    ),
}


def settings_of_technique(technique: str) -> list[str]:
    """Return the names of the settings that a technique has."""
    return [
        name
        for name, setting in TECHNIQUE_SETTINGS.items()
        if technique in setting.techniques
    ]


def variant_text(technique: str, settings: Settings) -> str:
    """Return a variant of a technique as the benchmark filter reads it."""
    return "; ".join([technique, *(f"{name}={value}" for name, value in settings)])


def value_text(name: str, value: Any) -> str:
    """Return a value for readers: 0 threads are as many as pay."""
    return "auto" if name == "slice_threads" and value == 0 else str(value)


def settings_text(settings: dict[str, Any]) -> str:
    """Return settings for readers: "slice threads 4, slice target RGBA8"."""
    return ", ".join(
        f"{name.replace('_', ' ')} {value_text(name, value)}"
        for name, value in settings.items()
    )
