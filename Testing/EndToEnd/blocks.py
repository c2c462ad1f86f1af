"""Data in several blocks: the picture of the whole, and one clear line for what cannot be drawn."""

from typing import Any

import numpy as np
from paraview import simple
from support import (
    ERRORS,
    LABEL,
    blob,
    capture,
    check_close,
    check_empty,
    color_by,
    eighths,
    image_data,
    look,
    new_view,
    not_drawn,
    producer,
    rmse,
    run_checks,
    set_functions,
    show,
    technique_labels,
    wavelet,
)
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSet, vtkUnstructuredGrid

COLORS = [37.0, 0.1, 0.2, 0.9, 150.0, 0.9, 0.8, 0.2, 277.0, 1.0, 0.3, 0.1]
OPACITY = [(37, 0.0), (130, 0.2), (160, 0.02), (277, 0.5)]
# A seam cuts one step of a ray in two. With steps of a tenth of a voxel, what that moves is small
# against the step of an 8-bit picture, 0.004.
STEP_VOXELS = 0.1
SAME_PICTURE = 2e-4


def picture_of(source: Any, label: str = LABEL) -> np.ndarray:
    """Return the picture of a source in a view of its own."""
    view = new_view()
    display = show(source, view, label)
    color_by(display, view, "RTData")
    set_functions("RTData", COLORS, OPACITY)
    display.ScalarOpacityUnitDistance = 1.0
    display.StepVoxels = STEP_VOXELS
    look(view)
    picture = capture(view)
    simple.Delete(view)
    return picture


def partitioned(sources: list[Any]) -> Any:
    """Return the data of sources as one partitioned data set."""
    data = vtkPartitionedDataSet()
    for number, source in enumerate(sources):
        source.UpdatePipeline()
        data.SetPartition(number, source.GetClientSideObject().GetOutputDataObject(0))
    return producer(data)


def check_eight_blocks_equal_the_whole() -> None:
    whole = wavelet()
    parts = eighths(whole)
    for label in technique_labels():
        expected = picture_of(whole, label)
        for name, source in (
            ("multi-block", simple.GroupDatasets(Input=parts[::-1])),
            ("partitioned", partitioned(parts)),
        ):
            actual = picture_of(source, label)
            check_close(actual, expected, SAME_PICTURE, f"{label}, {name}")


def check_paraview_offers_our_types_for_blocks() -> None:
    view = new_view()
    for source in (
        simple.GroupDatasets(Input=eighths(wavelet())),
        partitioned(eighths(wavelet())),
    ):
        display = simple.Show(source, view)
        assert set(technique_labels()) <= set(
            display.GetProperty("Representation").Available
        )


def check_no_array_chosen() -> None:
    view = new_view()
    display = show(simple.GroupDatasets(Input=eighths(wavelet())), view)
    simple.ColorBy(display, None)
    look(view)
    blocks = capture(view)
    whole = show(wavelet(), view)
    simple.ColorBy(whole, None)
    display.Visibility = 0
    check_close(capture(view), blocks, 2e-3, "no array chosen")


def check_cropping() -> None:
    pictures = []
    for source in (wavelet(), simple.GroupDatasets(Input=eighths(wavelet()))):
        view = new_view()
        display = show(source, view)
        color_by(display, view, "RTData")
        set_functions("RTData", COLORS, OPACITY)
        display.ScalarOpacityUnitDistance = 1.0
        display.StepVoxels = STEP_VOXELS
        display.UseCropping = 1
        display.CroppingOrigin = [2.0, -3.0, 1.0]
        display.CroppingScale = [0.4, 0.5, 0.6]
        look(view)
        pictures.append(capture(view))
    check_close(*pictures, SAME_PICTURE, "cropped")


def check_array_that_one_block_lacks() -> None:
    good = image_data(blob(), "values")
    other = image_data(blob(), "others")
    other.SetOrigin(23, 0, 0)
    data = vtkPartitionedDataSet()
    data.SetPartition(0, good)
    data.SetPartition(1, other)
    refuse(data, "in block 2, the image has no array 'values'")


def check_block_that_is_no_image() -> None:
    grid = vtkUnstructuredGrid()
    points = simple.Sphere()
    points.UpdatePipeline()
    grid.SetPoints(points.GetClientSideObject().GetOutputDataObject(0).GetPoints())
    data = vtkPartitionedDataSet()
    data.SetPartition(0, image_data(blob(), "values"))
    data.SetPartition(1, grid)
    refuse(data, "a vtkUnstructuredGrid in block 2 cannot be drawn")


def refuse(data: Any, cause: str) -> None:
    """Check that nothing is drawn of the data, and that one error says why."""
    view = new_view()
    display = show(producer(data), view)
    color_by(display, view, "values")
    look(view)
    check_empty(capture(view), cause)
    capture(view)
    messages = ERRORS.take()
    assert len(not_drawn(messages)) == 1, messages
    assert cause in not_drawn(messages)[0], messages


def check_switching_between_block_and_blocks() -> None:
    view = new_view()
    source = simple.GroupDatasets(Input=eighths(wavelet()))
    display = show(source, view)
    color_by(display, view, "RTData")
    look(view)
    first = capture(view)
    for label in ("Volume", *technique_labels(), "Outline", "Surface", LABEL):
        display.SetRepresentationType(label)
        simple.Render(view)
    assert rmse(capture(view), first) == 0, "after switching the picture is another one"


if __name__ == "__main__":
    run_checks(dict(globals()))
