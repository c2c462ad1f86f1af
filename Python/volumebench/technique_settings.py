"""Settings that only some techniques have: what studies call them and what they may be."""

import re
from dataclasses import dataclass
from typing import Any

Settings = tuple[tuple[str, Any], ...]

_SHAPE = re.compile(r"Auto|[1-9][0-9]{0,3}x[1-9][0-9]{0,3}")
_DEVICE = re.compile(r"Auto|[^;]+: [^;]+")
_CASTING = ("single-pass", "multi-pass", "compute", "opencl", "cuda")
_RAYS = ("single-pass", "multi-pass", "compute")
_SLICING = ("slices", "slices-threaded")
_VTK = ("vtk-gpu", "vtk-fixed-point")


@dataclass(frozen=True)
class TechniqueSetting:
    """One setting: its property on filter and representation, who has it, and its values."""

    property: str
    techniques: tuple[str, ...]
    values: tuple[Any, ...] = ()
    expected: str = ""
    kind: type = str
    limits: tuple[float, float] | None = None
    pattern: re.Pattern = _SHAPE

    def accepts(self, value: Any) -> bool:
        """Tell whether the value is one that the setting can take."""
        if self.limits:
            number = isinstance(value, (int, self.kind)) and value is not True
            return number and self.limits[0] <= value <= self.limits[1]
        if self.values:
            return type(value) is type(self.values[0]) and value in self.values
        return isinstance(value, str) and self.pattern.fullmatch(value) is not None

    def choice(self) -> str:
        """Return the values for readers."""
        return self.expected or ", ".join(str(value) for value in self.values)


TECHNIQUE_SETTINGS = {
    "termination_threshold": TechniqueSetting(
        *("TerminationThreshold", _CASTING, (), "a number from 0 to 0.999999"),
        *(float, (0, 0.999999)),
    ),
    "error_target": TechniqueSetting(
        *("ErrorTarget", _RAYS, (), "a number from 0 to 1"),
        *(float, (0, 1)),
    ),
    "interactive_frame_ms": TechniqueSetting(
        *("InteractiveFrameTime", _CASTING + _SLICING, (), "a number of 0 or more"),
        *(float, (0, 1e9)),
    ),
    "memory_budget_mib": TechniqueSetting(
        *("MemoryBudget", _CASTING + _SLICING, (), "a number of 0 or more"),
        *(float, (0, 1e9)),
    ),
    "jitter": TechniqueSetting("Jitter", _CASTING + _SLICING, (0, 1)),
    "jitter_seed": TechniqueSetting(
        *("JitterSeed", _CASTING + _SLICING, (), "a whole number from 0 to 16777215"),
        *(int, (0, 16777215)),
    ),
    "table_size": TechniqueSetting(
        *("TableSize", _CASTING + _SLICING, (), "a whole number from 0 to 65536"),
        *(int, (0, 65536)),
    ),
    "skipping": TechniqueSetting("Skipping", _CASTING + _SLICING, (True, False)),
    "macrocell_voxels": TechniqueSetting(
        *("MacrocellVoxels", _CASTING + _SLICING, (), "a whole number from 0 to 64"),
        *(int, (0, 64)),
    ),
    "work_group_shape": TechniqueSetting(
        *("WorkGroupShape", ("compute", "opencl", "cuda"), ()),
        "Auto, or WIDTHxHEIGHT such as 16x8",
    ),
    "ray_set_up": TechniqueSetting(
        "RaySetUp", ("single-pass", "compute"), ("Box", "Rasterised")
    ),
    "opencl_device": TechniqueSetting(
        *("OpenclDevice", ("opencl",), (), "Auto, or PLATFORM: DEVICE"),
        pattern=_DEVICE,
    ),
    "opencl_storage": TechniqueSetting(
        "OpenclStorage", ("opencl",), ("Auto", "Images", "Buffers")
    ),
    "voxel_order": TechniqueSetting(
        "VoxelOrder",
        ("compute", "opencl", "cuda"),
        ("Naive", "Block Shape", "In-Place Rotation"),
    ),
    "picture_transfer": TechniqueSetting(
        "PictureTransfer",
        ("cuda",),
        ("Register Once", "Register Each Frame", "Through Host"),
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
    "sample_distance_voxels": TechniqueSetting(
        *("", _VTK, (), "a number of voxels from 1/1024 to 100"),
        *(float, (1 / 1024, 100)),
    ),
}


def settings_of_technique(technique: str) -> list[str]:
    """Return the names of the settings that a technique has."""
    return [
        name
        for name, setting in TECHNIQUE_SETTINGS.items()
        if technique in setting.techniques
    ]


def variant_text(
    technique: str,
    integrator: str | None,
    step_voxels: float | None,
    settings: Settings,
) -> str:
    """Return a run as the benchmark filter reads it: a technique with all that it is drawn with."""
    sampling = (("integrator", integrator), ("step_voxels", step_voxels))
    given = [item for item in sampling if item[1] is not None]
    return "; ".join(
        [technique, *(f"{name}={_plain(value)}" for name, value in (*given, *settings))]
    )


def _plain(value: Any) -> str:
    """Return a value as JSON has it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def value_text(name: str, value: Any) -> str:
    """Return a value for readers: of 0 threads or table entries there are as many as it takes."""
    if isinstance(value, bool):
        return "on" if value else "off"
    automatic = name in ("slice_threads", "table_size", "macrocell_voxels")
    return "auto" if automatic and value == 0 else str(value)


def without(settings: dict[str, Any], names: frozenset[str]) -> dict[str, Any]:
    """Return settings less those of the given names."""
    return {name: value for name, value in settings.items() if name not in names}


def settings_text(settings: dict[str, Any]) -> str:
    """Return settings for readers: "slice threads 4, slice target RGBA8"."""
    return ", ".join(
        f"{name.replace('_', ' ')} {value_text(name, value)}"
        for name, value in settings.items()
    )
