"""ParaView's presets (.json): colour maps, maybe with opacities, read to and written from our own."""

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .control_points import Point, ascending, rescaled
from .errors import BenchError, StudyError
from .json_file import read_json, write_atomically
from .transfer_functions import NORMALIZED, TransferFunction

RAMP = ((0.0, 0.0), (1.0, 1.0))  # what ParaView begins with
SAMPLES_BETWEEN_POINTS = 128  # of what is not straight between two points
PLAIN_OPACITY = (
    0.5,
    0.0,
)  # midpoint and sharpness of what is straight between two points
_SETTERS = {
    "HSV": "SetColorSpaceToHSV",
    "Lab": "SetColorSpaceToLab",
    "CIELAB": "SetColorSpaceToLab",
    "CIEDE2000": "SetColorSpaceToLabCIEDE2000",
    "Diverging": "SetColorSpaceToDiverging",
}


def read_presets(path: Path) -> list[TransferFunction]:
    """Read all presets of a file, each over x from 0 to 1.

    Colours that are not straight in RGB between their points are sampled. A preset without opacities
    gets the ramp that ParaView begins with, and all hold over one voxel.
    """
    document = read_json(path)
    items = document if isinstance(document, list) else [document]
    if not items:
        raise StudyError(f"{path}: holds no preset")
    return [
        function_of_preset(item, f"preset {i}", path) for i, item in enumerate(items, 1)
    ]


def read_preset(path: Path, name: str | None = None) -> TransferFunction:
    """Read the preset of that name; without one, the only preset of the file."""
    return preset_of(read_presets(path), name, path)


def preset_of(
    functions: list[TransferFunction], name: str | None, path: Path
) -> TransferFunction:
    """Return the function of that name; without one, the only function of the file."""
    names = ", ".join(function.name for function in functions)
    if name is None and len(functions) > 1:
        raise StudyError(f"{path}: holds {len(functions)} presets; say which: {names}")
    for function in functions:
        if name in (None, function.name):
            return function
    raise StudyError(f'{path}: holds no preset "{name}", but {names}')


def write_presets(functions: list[TransferFunction], path: Path) -> None:
    """Write presets as ParaView's dialog imports them."""
    items = [
        {
            "ColorSpace": "RGB",
            "Name": function.name,
            "NanColor": [1, 1, 0],
            "Points": [v for x, a in function.opacity for v in (x, a, *PLAIN_OPACITY)],
            "RGBPoints": [value for point in function.color for value in point],
        }
        for function in functions
    ]
    write_atomically(path, json.dumps(items, indent=1) + "\n")


def function_of_preset(item: Any, where: str, path: Path) -> TransferFunction:
    """Return a preset over x from 0 to 1; `path` and `where` are named in errors."""
    if not isinstance(item, dict):
        raise StudyError(f"{path}: {where} is no object")
    name = item.get("Name")
    if not isinstance(name, str) or not name:
        raise StudyError(f"{path}: {where}: Name is missing or no text")
    where = f'preset "{name[:40]}"'
    if "RGBPoints" not in item and "IndexedColors" in item:
        raise StudyError(
            f"{path}: {where} has colours for categories, none for a range"
        )
    color = _groups(item, "RGBPoints", where, path)
    opacity = _groups(item, "Points", where, path) if "Points" in item else None
    _check_units(color, "RGBPoints", (1, 2, 3), where, path)
    _check_units(opacity or (), "Points", (1, 2, 3), where, path)
    places = [point[0] for point in (*color, *(opacity or ()))]
    low, high = min(places), max(places)
    if not (low < high and math.isfinite(high - low)):
        raise StudyError(f"{path}: {where}: its points have one x")
    color = rescaled(color, low, high)
    space = item.get("ColorSpace", "RGB")
    if space != "RGB":
        color = _sampled_color(color, space, where, path)
    if opacity is None:
        opacity = RAMP
    else:
        opacity = _straight_opacity(rescaled(opacity, low, high))
    return TransferFunction(
        name, "", NORMALIZED, _with_jumps(opacity), _with_jumps(color), 1.0
    )


def _groups(
    item: dict[str, Any], key: str, where: str, path: Path
) -> tuple[Point, ...]:
    """Return a flat list of numbers as points of four, two at least, x not descending."""
    values = item.get(key)
    if not isinstance(values, list) or len(values) < 8 or len(values) % 4:
        raise StudyError(
            f"{path}: {where}: {key} is no list of 4 n numbers, n at least 2"
        )
    for value in values:
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise StudyError(
                f"{path}: {where}: {key}: {str(value)[:40]!r} is no number"
            )
        if abs(value) > 1e300:
            raise StudyError(f"{path}: {where}: {key}: {str(value)[:40]} is too large")
    points = tuple(
        tuple(float(value) for value in values[i : i + 4])
        for i in range(0, len(values), 4)
    )
    for before, after in zip(points, points[1:]):
        if after[0] < before[0]:
            raise StudyError(f"{path}: {where}: {key}: x {after[0]:g} descends")
    return points


def _check_units(
    points: tuple[Point, ...], key: str, parts: tuple[int, ...], where: str, path: Path
) -> None:
    for point in points:
        for part in parts:
            if not 0 <= point[part] <= 1:
                value = point[part]
                raise StudyError(
                    f"{path}: {where}: {key}: {value:g} is not from 0 to 1"
                )


def _with_jumps(points: tuple[Point, ...]) -> tuple[Point, ...]:
    return ascending([(point[0], point[1:], point[1:]) for point in points])


def _sampled_color(
    color: tuple[Point, ...], space: Any, where: str, path: Path
) -> tuple[Point, ...]:
    if not isinstance(space, str) or space not in _SETTERS:
        known = ", ".join(["RGB", *_SETTERS])
        raise StudyError(
            f"{path}: {where}: ColorSpace {str(space)[:40]!r} cannot be read; known are {known}"
        )
    map_of_vtk = _vtk("vtkRenderingCore", "vtkColorTransferFunction")
    getattr(map_of_vtk, _SETTERS[space])()
    for x, red, green, blue in color:
        map_of_vtk.AddRGBPoint(x, red, green, blue)

    def at(x: float) -> Point:
        return tuple(min(max(value, 0.0), 1.0) for value in map_of_vtk.GetColor(x))

    return _sampled([point[0] for point in color], at)


def _straight_opacity(opacity: tuple[Point, ...]) -> tuple[Point, ...]:
    """Return points [x, alpha]; where midpoint or sharpness bend the curve, more of them."""
    if all(point[2:] == PLAIN_OPACITY for point in opacity[:-1]):
        return tuple(point[:2] for point in opacity)
    curve = _vtk("vtkCommonDataModel", "vtkPiecewiseFunction")
    for point in opacity:
        curve.AddPoint(*point)
    return _sampled([point[0] for point in opacity], lambda x: (curve.GetValue(x),))


def _sampled(places: list[float], at: Callable[[float], Point]) -> tuple[Point, ...]:
    points: list[Point] = []
    for begin, end in zip(places, places[1:]):
        for i in range(SAMPLES_BETWEEN_POINTS):
            x = begin + (end - begin) * i / SAMPLES_BETWEEN_POINTS
            if not points or x > points[-1][0]:
                points.append((x, *at(x)))
    points.append((places[-1], *at(places[-1])))
    return tuple(points)


def _vtk(module: str, name: str) -> Any:
    """Return a new VTK object; only presets that are not straight in RGB need one."""
    try:
        found = __import__(f"vtkmodules.{module}", fromlist=[name])
    except ImportError:
        raise BenchError(
            f"VTK's Python module {module} is needed to sample a preset"
        ) from None
    return getattr(found, name)()
