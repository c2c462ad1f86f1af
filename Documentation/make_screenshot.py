"""Runs inside ParaView, started by make_screenshot.sh: shows the MRI with a technique of ours.

Environment: VOLUMEBENCH_PLUGIN, the plugin's absolute path; VOLUMEBENCH_READY, a file to make
when the picture stands; VOLUMEBENCH_SOURCE, the repository; VOLUMEBENCH_VOLUME, a .nii file; VOLUMEBENCH_LABEL, the representation (default "Volume Single Pass").
"""

import json
import os
from pathlib import Path

from paraview import simple

LIBRARIES = Path("/usr/lib/x86_64-linux-gnu/paraview-5.11/plugins")
READER = LIBRARIES / "AnalyzeNIfTIReaderWriter" / "AnalyzeNIfTIReaderWriter.so"
FUNCTION = (
    Path(os.environ["VOLUMEBENCH_SOURCE"])
    / "Data/TransferFunctions/mri-translucent.json"
)
VOLUME = os.environ["VOLUMEBENCH_VOLUME"]
LABEL = os.environ.get("VOLUMEBENCH_LABEL", "Volume Single Pass")


def show_volume() -> None:
    names = vars(simple)
    for plugin in (str(READER), os.environ["VOLUMEBENCH_PLUGIN"]):
        simple.LoadPlugin(plugin, remote=False, ns=names)
    source = simple.OpenDataFile(VOLUME)
    simple.RenameSource(Path(VOLUME).stem, source)
    source.UpdatePipeline()
    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(source, view, "UniformGridRepresentation")
    display.SetRepresentationType(LABEL)
    array = source.PointData.GetArray(0)
    simple.ColorBy(display, ("POINTS", array.GetName()))
    set_functions(array.GetName(), array.GetRange(0))
    look(view)


def set_functions(name: str, limits: tuple[float, float]) -> None:
    function = json.loads(FUNCTION.read_text())
    low, width = limits[0], limits[1] - limits[0]
    colors = simple.GetColorTransferFunction(name)
    colors.ColorSpace = "RGB"
    colors.RGBPoints = [
        value for x, *rgb in function["color"] for value in (low + x * width, *rgb)
    ]
    simple.GetOpacityTransferFunction(name).Points = [
        value for x, a in function["opacity"] for value in (low + x * width, a, 0.5, 0)
    ]


def look(view) -> None:
    """Look at the face from the side, head up."""
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    focus = camera.GetFocalPoint()
    camera.SetPosition(focus[0] + 1, focus[1] + 1.2, focus[2] + 0.3)
    camera.SetViewUp(0, 0, 1)
    simple.ResetCamera(view)
    view.CameraFocalPoint = [focus[0], focus[1], focus[2] - 22]
    camera.Zoom(1.2)
    simple.Render(view)


show_volume()
Path(os.environ["VOLUMEBENCH_READY"]).touch()
