"""What every end-to-end test shares: plugin, views, float pictures, caught errors, a small runner."""

import functools
import itertools
import os
import re
import shutil
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from lost_memory import report_lost_memory
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader

PLUGIN = os.environ["VOLUMEBENCH_PLUGIN"]
LABEL = os.environ.get("VOLUMEBENCH_LABEL", "Volume Single Pass")
SIZE = (200, 200)
SKIPPED = 77  # what CTest takes for a skipped test
REPRESENTATION = "UniformGridRepresentation"
NOT_DRAWN = "Volume not drawn"
TECHNIQUE_LIST = Path(__file__).resolve().parents[2] / "Plugin" / "Techniques.cmake"


class ErrorLog:
    """Keeps VTK's error messages while it is open, and keeps them off the terminal."""

    def __init__(self) -> None:
        self.messages: list[str] = []

    def __enter__(self) -> "ErrorLog":
        def keep(_caller: Any, _event: str, message: str = "") -> None:
            self.messages.append(message.strip())

        keep.CallDataType = VTK_STRING
        self._window = vtkOutputWindow.GetInstance()
        self._tag = self._window.AddObserver("ErrorEvent", keep)
        return self

    def __exit__(self, *_: Any) -> None:
        self._window.RemoveObserver(self._tag)

    def take(self) -> list[str]:
        """Return the messages so far and forget them."""
        taken = list(self.messages)
        self.messages.clear()
        return taken


ERRORS = ErrorLog()


def technique_labels() -> list[str]:
    """Return the labels of all our representations that this build has and this machine can run."""
    return [label for label in _listed_labels() if not why_not_here(label)]


def _listed_labels() -> dict[str, bool]:
    """Return the labels in Plugin/Techniques.cmake, and whether they are in some builds only."""
    text = TECHNIQUE_LIST.read_text(encoding="utf-8")
    rows = r'^\s*volumebench_technique\([^)]*\bLABEL\s+"([^"]+)"([^)]*)\)'
    return {
        label: "REQUIRES" in rest
        for label, rest in re.findall(rows, text, re.MULTILINE)
    }


@functools.cache
def why_not_here(label: str) -> str:
    """Return why a technique on a device of its own cannot run here; empty when it can."""
    if not _listed_labels().get(label, False):
        return ""
    view = simple.CreateRenderView()
    with ErrorLog() as log:
        display = simple.Show(simple.Wavelet(), view, REPRESENTATION)
        if label not in display.GetProperty("Representation").Available:
            return f"{label} is not in this build"
        display.SetRepresentationType(label)
        simple.Render(view)
        said = [text for text in log.take() if "cannot run here" in text]
    simple.Delete(view)
    return said[0] if said else ""


def labels_named_by(display: Any, name: str) -> set[str]:
    """Return the representations that alone show the row of a property; empty when all do."""
    hints = display.GetProperty(name).SMProperty.GetHints()
    return {label for label in _decorated_with(hints) if label.startswith("Volume")}


def _decorated_with(element: Any) -> list[str]:
    values = []
    for index in range(element.GetNumberOfNestedElements() if element else 0):
        nested = element.GetNestedElement(index)
        values += [nested.GetAttribute("value") or ""] + _decorated_with(nested)
    return values


def load_plugin(remote: bool = False) -> None:
    """Load the plugin under test into this process or into the server."""
    simple.LoadPlugin(PLUGIN, remote=remote, ns=vars(simple))


def new_view(size: Sequence[int] = SIZE) -> Any:
    """Return a black view of exactly this size, with nothing in it but what is shown."""
    view = simple.CreateRenderView()
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0, 0, 0]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.UseFXAA = 0
    view.ViewSize = list(size)
    return view


def show(source: Any, view: Any, label: str = LABEL) -> Any:
    """Show a source in the view with the representation of this label."""
    display = simple.Show(source, view, REPRESENTATION)
    display.SetRepresentationType(label)
    return display


def color_by(display: Any, view: Any, array: Any, association: str = "POINTS") -> None:
    """Colour by an array, or by (array, component), without a scalar bar."""
    given = (array,) if isinstance(array, str) else tuple(array)
    simple.ColorBy(display, (association, *given))
    display.RescaleTransferFunctionToDataRange(False)
    display.SetScalarBarVisibility(view, False)


def look(view: Any, azimuth: float = 30, elevation: float = 20) -> None:
    """Let the camera face all that is shown, from a direction along no axis."""
    camera = view.GetActiveCamera()
    camera.SetPosition(0, 0, 1)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 1, 0)
    simple.ResetCamera(view)
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    simple.ResetCamera(view)


def capture(view: Any, count_samples: bool = False) -> np.ndarray:
    """Render the view and return it as premultiplied float RGBA, row 0 on top.

    Or return how many samples VTK's mapper takes, in red.
    """
    simple.Render(view)
    proxy = servermanager.misc.VolumeBenchmarkViewCapture()
    proxy.View = view
    proxy.CountSamples = int(count_samples)
    with temporary_folder() as folder:
        path = folder / "capture.rgba32f"
        proxy.FileName = str(path)
        proxy.UpdateVTKObjects()
        proxy.SMProxy.InvokeCommand("Capture")
        width, height = view.GetRenderWindow().GetSize()
        values = np.fromfile(path, "<f4")
    assert values.size == width * height * 4, f"{values.size} values captured"
    return values.reshape(height, width, 4)[::-1].copy()


def read_png(path: Path) -> np.ndarray:
    """Return a picture's RGB values in 0..1, row 0 on top."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1, :, :3] / 255.0


def rmse(first: np.ndarray, second: np.ndarray) -> float:
    """Return the root mean square difference of two pictures' colours."""
    assert first.shape == second.shape, f"sizes differ: {first.shape}, {second.shape}"
    difference = first[..., :3].astype(float) - second[..., :3].astype(float)
    return float(np.sqrt(np.mean(difference**2)))


def check_close(first: np.ndarray, second: np.ndarray, bound: float, what: str) -> None:
    """Fail unless two pictures, of which neither is empty, differ by at most `bound`."""
    check_not_empty(first, what)
    check_not_empty(second, what)
    error = rmse(first, second)
    print(f"  {what}: RMSE {error:.5f} (at most {bound})")
    assert error <= bound, f"{what}: RMSE {error:.5f} is more than {bound}"


def check_differs(
    first: np.ndarray, second: np.ndarray, what: str, bound: float = 1e-3
) -> None:
    """Fail if two pictures are the same to within `bound`."""
    error = rmse(first, second)
    assert error > bound, f"{what}: the picture did not change (RMSE {error:.2g})"


def check_not_empty(picture: np.ndarray, what: str) -> None:
    """Fail if a picture is black all over or holds a value that is not finite."""
    assert np.isfinite(picture).all(), f"{what}: the picture holds NaN or infinity"
    assert picture[..., :3].max() > 0.02, f"{what}: the picture is empty"


def check_empty(picture: np.ndarray, what: str) -> None:
    """Fail if anything was drawn."""
    assert picture.max() == 0, f"{what}: something was drawn"


def not_drawn(messages: Sequence[str]) -> list[str]:
    """Return our own messages among VTK's."""
    return [message for message in messages if NOT_DRAWN in message]


def wavelet(half: int = 10) -> Any:
    """Return ParaView's analytic source: float point data RTData."""
    return simple.Wavelet(WholeExtent=[-half, half] * 3)


def eighths(source: Any, half: int = 10) -> list[Any]:
    """Return the eight parts of a wavelet, which share their faces; the lower four first."""
    sides = ((-half, 0), (0, half))
    parts = []
    for z, y, x in itertools.product(sides, sides, sides):
        part = simple.ExtractSubset(Input=source)
        part.VOI = [*x, *y, *z]
        parts.append(part)
    return parts


def image_data(
    values: np.ndarray,
    name: str = "values",
    spacing: Sequence[float] = (1, 1, 1),
    cells: bool = False,
) -> vtkImageData:
    """Return an image with one array; the axes of `values` are x, y, z and maybe components."""
    image = vtkImageData()
    grow = 1 if cells else 0
    image.SetDimensions(*(int(side) + grow for side in values.shape[:3]))
    image.SetSpacing(*spacing)
    components = values.shape[3] if values.ndim == 4 else 1
    flat = values.reshape(*values.shape[:3], components).transpose(2, 1, 0, 3)
    array = numpy_to_vtk(np.ascontiguousarray(flat).reshape(-1, components), deep=True)
    array.SetName(name)
    attributes = image.GetCellData() if cells else image.GetPointData()
    attributes.SetScalars(array)
    return image


def blob(side: int = 24, sharpness: float = 4.0) -> np.ndarray:
    """Return a smooth, off-centre hill of floats in 0..1 on a cube of points."""
    axis = np.linspace(-1, 1, side)
    x, y, z = np.meshgrid(axis, axis, axis, indexing="ij")
    squares = (x - 0.2) ** 2 + (y + 0.1) ** 2 + 1.5 * z**2
    return np.exp(-sharpness * squares).astype(np.float32)


def producer(image: Any) -> Any:
    """Return a pipeline source that gives this data object."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image)
    source.UpdatePipeline()
    return source


def replace_output(source: Any, image: Any) -> None:
    """Let a source made by `producer` give another data object."""
    source.GetClientSideObject().SetOutput(image)
    source.MarkModified(source)
    source.UpdatePipeline()


def set_functions(
    array: str, colors: Sequence[float], opacity: Sequence[tuple[float, float]]
) -> None:
    """Give the transfer functions of an array their points."""
    color = simple.GetColorTransferFunction(array)
    color.ColorSpace = "RGB"
    color.RGBPoints = list(colors)
    function = simple.GetOpacityTransferFunction(array)
    function.Points = [value for x, a in opacity for value in (x, a, 0.5, 0.0)]


@contextmanager
def temporary_folder() -> Iterator[Path]:
    """Give a folder that is gone afterwards."""
    folder = Path(tempfile.mkdtemp(prefix="volumebench-"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def run_checks(names: dict[str, Any]) -> None:
    """Run every `check_...` function of a script, each in a fresh session; exit 1 on a failure."""
    checks: list[Callable[[], None]] = [
        value
        for name, value in names.items()
        if name.startswith("check_") and value.__module__ == "__main__"
    ]
    only = sys.argv[1:]
    failed: list[str] = []
    ran = 0
    load_plugin()
    reasons = {label: why_not_here(label) for label in _listed_labels()}
    reason = reasons.get(LABEL, "")
    if reason and "MISSING" not in names:
        print(f"NOT RUN: {reason}", flush=True)
        os._exit(SKIPPED)
    for check in checks:
        if only and check.__name__ not in only:
            continue
        ran += 1
        print(check.__name__, flush=True)
        if not _passes(check):
            failed.append(check.__name__)
    print(f"{ran - len(failed)} of {ran} checks passed", flush=True)
    if failed or not ran:
        print("FAILED: " + " ".join(failed), flush=True)
    else:
        print("PASSED", flush=True)
    sys.stdout.flush()
    report_lost_memory()
    # Leaving through the interpreter would run ParaView's own teardown, which is not under test.
    os._exit(1 if failed or not ran else 0)


def _passes(check: Callable[[], None]) -> bool:
    simple.ResetSession()
    with ERRORS:
        try:
            check()
            unclaimed = ERRORS.take()
            assert not unclaimed, "errors were reported: " + "\n".join(unclaimed)
        except (
            Exception
        ):  # a test may fail in any way, and the next one shall still run
            traceback.print_exc(file=sys.stdout)
            for message in ERRORS.take():
                print("  reported:", message)
            return False
    return True
