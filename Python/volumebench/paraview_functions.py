"""Transfer functions of ParaView's displays; the session and the macros set and read them here."""

import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

from paraview import servermanager, simple

from .errors import BenchError
from .json_file import read_json
from .paraview_presets import function_of_preset, preset_of
from .paraview_presets import read_presets, write_presets
from .transfer_functions import TransferFunction, load_transfer_function
from .transfer_functions import save_transfer_function
from .voreen_functions import read_tfi, write_tfi

_STRAIGHT = (0.5, 0.0)  # midpoint and sharpness of an opacity point


def set_function(display: Any, array: str, function: TransferFunction) -> None:
    """Give colour map and opacity function of an array their points, which are over values."""
    colors = simple.GetColorTransferFunction(array)
    colors.AutomaticRescaleRangeMode = "Never"
    colors.ColorSpace = "RGB"
    colors.UseLogScale = 0
    colors.RGBPoints = [value for point in function.color for value in point]
    opacity = simple.GetOpacityTransferFunction(array)
    opacity.Points = [
        value for x, alpha in function.opacity for value in (x, alpha, *_STRAIGHT)
    ]
    display.LookupTable = colors
    display.ScalarOpacityFunction = opacity


def get_function(
    array: str, name: str, unit_distance_voxels: float
) -> TransferFunction:
    """Return what the colour map and the opacity function of an array show, over values."""
    colors = simple.GetColorTransferFunction(array)
    if colors.UseLogScale:
        raise BenchError(f"{array}: a logarithmic colour map cannot be written")
    rgb_points = list(colors.RGBPoints)
    points = list(simple.GetOpacityTransferFunction(array).Points)
    shown = {
        "Name": name,
        "ColorSpace": colors.GetProperty("ColorSpace").GetData(),
        "RGBPoints": rgb_points,
        "Points": points,
    }
    function = function_of_preset(shown, "colour map", Path(array))
    places = [*rgb_points[::4], *points[::4]]
    return replace(
        function.in_values(min(places), max(places)),
        unit_distance_voxels=unit_distance_voxels,
    )


def load_for_active_volume(path: Path, preset: str | None = None) -> str:
    """Show the active source through the function of a file; return what was done.

    Functions over x from 0 to 1 are stretched over the range of the array that the display is
    coloured by, and the unit distance is set.
    """
    display, array, source = _active()
    function = read_function(path, preset)
    low, high = source.PointData[array].GetRange(0)
    set_function(display, array, function.in_values(low, high))
    display.ScalarOpacityUnitDistance = function.unit_distance(*_grid(source))
    simple.Render()
    return f"{function.name}: {array} from {low:g} to {high:g}"


def save_of_active_volume(path: Path) -> str:
    """Write what the active source is shown through; return what was done.

    `.tfi` is Voreen's (its domain is a share of the largest magnitude in the array),
    `.preset.json` ParaView's, any other `.json` our own; only that tells the unit distance.
    """
    display, array, source = _active()
    mean_spacing = sum(_grid(source)[0]) / 3
    distance = display.ScalarOpacityUnitDistance / mean_spacing
    function = get_function(array, path.name.split(".")[0], distance)
    if path.suffix == ".tfi":
        largest = max(abs(value) for value in source.PointData[array].GetRange(0))
        write_tfi(function, path, largest or 1.0)
    elif path.name.endswith(".preset.json"):
        write_presets([function], path)
    elif path.suffix == ".json":
        save_transfer_function(function, path)
    else:
        raise BenchError(f"{path}: ends in none of .tfi, .preset.json and .json")
    return f"{path}: {array}"


def import_presets(folder: Path) -> list[str]:
    """Make each .tfi and .json file of a folder a preset of ParaView; return their names.

    A preset that was imported before is replaced; of several functions of one name the first file's is
    taken. Files that cannot be read are named on stderr.
    """
    folder.mkdir(parents=True, exist_ok=True)
    functions: dict[str, TransferFunction] = {}
    for path in sorted([*folder.glob("*.tfi"), *folder.glob("*.json")]):
        try:
            for function in read_functions(path):
                functions.setdefault(function.name, function)
        except BenchError as fault:
            print(f"error: {fault}", file=sys.stderr)
    presets = servermanager.vtkSMTransferFunctionPresets.GetInstance()
    names = list(functions)
    for index in reversed(range(presets.GetNumberOfPresets())):
        if presets.GetPresetName(index) in names and not presets.IsPresetBuiltin(index):
            presets.RemovePreset(index)
    if functions:
        with tempfile.TemporaryDirectory() as temporary:
            path = Path(temporary) / "presets.json"
            write_presets(list(functions.values()), path)
            simple.ImportPresets(str(path))
    print(f"{len(names)} presets from {folder}: {', '.join(names) or 'none'}")
    return names


def export_active_function(folder: Path) -> list[str]:
    """Write what the active source is shown through in all three kinds; return what was done."""
    folder.mkdir(parents=True, exist_ok=True)
    _, array, _ = _active()
    stem = "".join(sign if sign.isalnum() or sign in "_-" else "-" for sign in array)
    done = [
        save_of_active_volume(folder / f"{stem}{ending}")
        for ending in (".tfi", ".preset.json", ".json")
    ]
    print("\n".join(done))
    return done


def read_function(path: Path, preset: str | None = None) -> TransferFunction:
    """Read a file of any of the three kinds; `preset` says which of several is meant."""
    return preset_of(read_functions(path), preset, path)


def read_functions(path: Path) -> list[TransferFunction]:
    """Read all functions of a file of any of the three kinds."""
    if path.suffix == ".tfi":
        return [read_tfi(path)]
    if path.suffix != ".json":
        raise BenchError(f"{path}: ends in neither .tfi nor .json")
    document = read_json(path)
    if isinstance(document, dict) and "opacity" in document:
        return [load_transfer_function(path)]
    return read_presets(path)


def _grid(source: Any) -> tuple[tuple[float, ...], tuple[int, ...]]:
    """Return spacing and dims of an image."""
    extent = source.GetDataInformation().GetExtent()
    bounds = source.GetDataInformation().GetBounds()
    dims = tuple(extent[2 * i + 1] - extent[2 * i] + 1 for i in range(3))
    edges = (bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
    return tuple(edge / max(n - 1, 1) for edge, n in zip(edges, dims)), dims


def _active() -> tuple[Any, str, Any]:
    """Return the active display, the point array that it is coloured by, and the source."""
    source, view = simple.GetActiveSource(), simple.GetActiveView()
    display = simple.GetDisplayProperties(source, view) if source and view else None
    if display is None:
        raise BenchError("select a volume in the pipeline first, and show it")
    association, array = list(display.ColorArrayName)[:2]
    if association != "POINTS" or source.PointData[array] is None:
        raise BenchError("colour the volume by an array of its points first")
    return display, array, source
