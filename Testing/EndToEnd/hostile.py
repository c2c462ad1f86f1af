"""The table of bad input as ParaView hands it on: for every technique and row one line or a picture.

After each row the same view must show the good volume again, to the last bit. What the engine sees by
itself is in Testing/Hostile.
"""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from paraview import simple
from support import (
    ERRORS,
    blob,
    capture,
    check_empty,
    check_not_empty,
    color_by,
    image_data,
    look,
    new_view,
    not_drawn,
    producer,
    replace_output,
    run_checks,
    show,
    technique_labels,
    temporary_folder,
)
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

OPACITY = [0, 0, 0.5, 0, 1, 0.4, 0.5, 0]
COLORS = [0, 0.1, 0.2, 0.9, 1, 0.9, 0.5, 0.1]


class Stage:
    """One view with one volume, which rows spoil."""

    def __init__(self, label: str, folder: Path) -> None:
        self.folder = folder
        self.label = label
        self.view = new_view((80, 80))
        self.source = producer(image_data(blob(), "values"))
        self.display = show(self.source, self.view, label)
        color_by(self.display, self.view, "values")
        self.opacity = simple.GetOpacityTransferFunction("values")
        self.color = simple.GetColorTransferFunction("values")
        self.usable = {
            name: self.display.GetProperty(name).GetData() for name in SETTINGS
        }
        self.files: list[Any] = []
        self.mend()
        self.good = capture(self.view)
        check_not_empty(self.good, label)

    def mend(self) -> None:
        """Undo whatever a row has done."""
        for source in self.files:
            simple.Delete(source)
        self.files = []
        for name, value in self.usable.items():
            setattr(self.display, name, value)
        self.opacity.Points = OPACITY
        self.color.UseLogScale = 0
        self.color.ColorSpace = "RGB"
        self.color.RGBPoints = COLORS
        self.display.Visibility = 1
        self.view.ViewSize = [80, 80]
        self.view.CameraParallelProjection = 0
        replace_output(self.source, image_data(blob(), "values"))
        look(self.view)

    def set(self, name: str, value: Any) -> None:
        setattr(self.display, name, value)

    def give(self, data: Any) -> None:
        replace_output(self.source, data)

    def open(self, make_reader: Callable[..., Any], path: Path) -> None:
        """Show a file in place of the volume."""
        self.display.Visibility = 0
        reader = make_reader(path)
        self.files.append(reader)
        try:
            display = simple.Show(reader, self.view)
            if "Representation" in display.ListProperties():
                display.SetRepresentationType(self.label)
        except RuntimeError as fault:  # ParaView knows no representation for no data
            print(f"    {fault}")


@dataclass(frozen=True)
class Row:
    name: str
    do: Callable[[Stage], None]
    words: str = ""  # in our one error
    drawn: bool = False  # otherwise the view is empty
    told: str = ""  # in an error of a reader


SETTINGS = (
    "StepVoxels",
    "TerminationThreshold",
    "ErrorTarget",
    "JitterSeed",
    "LightingDamping",
    "MacrocellVoxels",
    "ScalarOpacityUnitDistance",
    "TechniqueBlendMode",
    "WorkGroupShape",
    "Ambient",
    "SpecularPower",
    "Shade",
)


def with_setting(name: str, value: Any, words: str) -> Row:
    return Row(f"{name} = {value}", lambda stage: stage.set(name, value), words)


def with_data(name: str, make: Callable[[], Any], words: str, drawn=False) -> Row:
    return Row(name, lambda stage: stage.give(make()), words, drawn)


def rows_of_settings() -> list[Row]:
    nan = math.nan
    shading = [
        Row("ambient nan", lambda s: (s.set("Shade", 1), s.set("Ambient", nan)), "amb"),
        Row(
            "specular power -1",
            lambda s: (s.set("Shade", 1), s.set("SpecularPower", -1.0)),
            "the specular power is -1",
        ),
    ]
    return shading + [
        with_setting("StepVoxels", 0.0, "the step is 0 voxels"),
        with_setting("StepVoxels", nan, "the step is nan"),
        with_setting("StepVoxels", math.inf, "the step is inf"),
        with_setting("TerminationThreshold", 1.0, "the termination threshold is 1"),
        with_setting("TerminationThreshold", nan, "the termination threshold is nan"),
        with_setting("ErrorTarget", -0.5, "the error target is -0.5"),
        with_setting("ErrorTarget", nan, "the error target is nan"),
        with_setting("JitterSeed", -1, "the jitter seed is -1"),
        with_setting("LightingDamping", nan, "the lighting damping is nan"),
        with_setting("LightingDamping", -1.0, "the lighting damping is -1"),
        with_setting("MacrocellVoxels", -4, "an edge of -4"),
        with_setting("ScalarOpacityUnitDistance", 0.0, "unit distance is 0"),
        with_setting("ScalarOpacityUnitDistance", nan, "unit distance is nan"),
        with_setting("TechniqueBlendMode", 4, "the blend mode 4"),
        with_setting("WorkGroupShape", "0x0", "no work-group shape '0x0'"),
    ]


def broken_image(change: Callable[[vtkImageData], None]) -> vtkImageData:
    image = image_data(blob(8), "values")
    change(image)
    return image


def far_blocks(far: float) -> vtkMultiBlockDataSet:
    """Return two images, the second so many voxels away on all axes."""
    blocks = vtkMultiBlockDataSet()
    for number, origin in enumerate((0.0, far)):
        image = image_data(blob(8), "values")
        image.SetOrigin(origin, origin, origin)
        blocks.SetBlock(number, image)
    return blocks


def rows_of_data() -> list[Row]:
    nan = math.nan
    hole = blob(8)
    hole[:4] = nan
    return [
        with_data("thin", lambda: image_data(blob(8)[:, :1], "values"), "one point th"),
        with_data("no array", lambda: image_data(blob(8), "others"), "array 'values'"),
        with_data("all nan", lambda: image_data(blob(8) * nan, "values"), "no finite"),
        with_data("half nan", lambda: image_data(hole, "values"), "", True),
        with_data(
            "spacing 0", lambda: image_data(blob(8), "values", (1, 0, 1)), "of 0 on"
        ),
        # ParaView leaves out, without asking us, what has bounds that are not finite.
        with_data(
            "spacing nan", lambda: image_data(blob(8), "values", (1, nan, 1)), ""
        ),
        with_data(
            "origin nan", lambda: broken_image(lambda i: i.SetOrigin(nan, 0, 0)), ""
        ),
        with_data(
            "direction of zeros",
            lambda: broken_image(lambda i: i.SetDirectionMatrix([0] * 9)),
            "direction matrix",
        ),
        with_data("one block of none", vtkMultiBlockDataSet, "no block of the"),
        with_data("blocks far apart", lambda: far_blocks(1e13), "", True),
        with_data("no points", vtkImageData, "the image is empty"),
    ]


def rows_of_functions() -> list[Row]:
    def opacity(*points: float) -> Callable[[Stage], None]:
        return lambda stage: setattr(stage.opacity, "Points", list(points))

    def colors(*points: float) -> Callable[[Stage], None]:
        return lambda stage: setattr(stage.color, "RGBPoints", list(points))

    nan = math.nan
    return [
        Row("opacity none", opacity(), "the opacity function has no points"),
        Row(
            "opacity nan", opacity(0, nan, 0.5, 0, 1, 1, 0.5, 0), "the opacity function"
        ),
        Row("opacity at nan", opacity(nan, 0, 0.5, 0, 1, 1, 0.5, 0), "the opacity fu"),
        Row("opacity reversed", opacity(1, 0.5, 0.5, 0, 0, 0.1, 0.5, 0), drawn=True),
        Row("color nan", colors(0, nan, 0, 0, 1, 1, 1, 1), "the colour function"),
        Row("color 5", colors(0, 5, 0, 0, 1, 1, 1, 1), "not from 0 to 1: 5"),
        Row("color none", colors(), "the colour function has no points"),
    ]


def write_text(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def write_cut_image(folder: Path) -> Path:
    """Write a file of VTK's that ends in the midst of its values."""
    path = folder / "cut.vti"
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image_data(blob(8), "values"))
    writer.Write()
    written = path.read_bytes()
    path.write_bytes(written[: len(written) // 2])
    return path


def with_file(
    name: str, reader: str, write: Callable[[Path], Path], told: str = ""
) -> Row:
    def open_it(stage: Stage) -> None:
        maker = getattr(simple, reader)
        path = write(stage.folder)
        stage.open(lambda p: maker(FileName=str(p)), path)

    return Row(name, open_it, "the image ", told=told or name)


def rows_of_files() -> list[Row]:
    voreen = "ObjectFileName: gone.raw\nResolution: 4 4 4\nFormat: UCHAR\n"
    return [
        with_file("none.pvm", "PVMReader", lambda f: f / "none.pvm"),
        with_file("bad.pvm", "PVMReader", lambda f: write_text(f, "bad.pvm", "JPEG")),
        with_file(
            "cut.pvm",
            "PVMReader",
            lambda f: write_text(f, "cut.pvm", "PVM\n4 4 4\n1\nab"),
        ),
        with_file("cut.vti", "XMLImageDataReader", write_cut_image, "too short"),
        with_file(
            "gone.raw", "VoreenReader", lambda f: write_text(f, "gone.dat", voreen)
        ),
    ]


def rows_of_views() -> list[Row]:
    def camera(**values: Any) -> Callable[[Stage], None]:
        def place(stage: Stage) -> None:
            for name, value in values.items():
                setattr(stage.view, name, value)

        return place

    return [
        Row("view of one pixel", camera(ViewSize=[1, 1]), drawn=True),
        Row(
            "camera on its focus",
            camera(CameraPosition=[0] * 3, CameraFocalPoint=[0] * 3),
            "cam",
        ),
        Row("camera nowhere", camera(CameraPosition=[math.nan, 0, 0]), "the camera"),
        Row(
            "parallel scale 0",
            camera(CameraParallelProjection=1, CameraParallelScale=0.0),
            "the camera",
        ),
        Row("hidden", lambda stage: stage.set("Visibility", 0)),
    ]


def check_row(stage: Stage, row: Row) -> None:
    row.do(stage)
    picture = capture(stage.view)
    capture(stage.view)
    messages = ERRORS.take()
    ours = not_drawn(messages)
    if row.drawn:
        assert picture[..., 3].max() > 0 and np.isfinite(picture).all(), "not drawn"
    else:
        check_empty(picture, row.name)
    assert len(ours) == (1 if row.words else 0), f"{len(ours)} errors: {messages}"
    if row.words:
        assert row.words in ours[0], f"{row.words!r} is not in {ours[0]!r}"
        assert "\n" not in ours[0].partition("Volume not drawn: ")[2], ours[0]
    if row.told:
        assert any(row.told in message for message in messages), messages
    stage.mend()
    assert np.array_equal(capture(stage.view), stage.good), "afterwards it differs"
    again = ERRORS.take()
    assert not again, f"afterwards: {again}"


def check_table() -> None:
    rows = [
        *rows_of_settings(),
        *rows_of_data(),
        *rows_of_functions(),
        *rows_of_files(),
        *rows_of_views(),
    ]
    failed = []
    for label in technique_labels():
        began = time.monotonic()
        with temporary_folder() as folder:
            stage = Stage(label, folder)
            for row in rows:
                try:
                    check_row(stage, row)
                except AssertionError as fault:
                    failed.append(f"{label}: {row.name}: {fault}")
                    ERRORS.take()
                    simple.ResetSession()
                    stage = Stage(label, folder)
        print(
            f"  {label}: {len(rows)} rows, {time.monotonic() - began:.1f} s", flush=True
        )
        simple.ResetSession()
    assert not failed, "\n".join(failed)


if __name__ == "__main__":
    run_checks({"check_table": check_table})
