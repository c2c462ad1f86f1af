"""Input that cannot be drawn or measured: one clear error, and ParaView goes on."""

from typing import Any

import numpy as np
from paraview import simple
from support import (
    ERRORS,
    LABEL,
    NOT_DRAWN,
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
    rmse,
    run_checks,
    show,
    wavelet,
)
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid


def view_of(image: Any) -> tuple[Any, Any, Any]:
    """Show a data object in a new view; return view, source and display."""
    view = new_view()
    source = producer(image)
    display = show(source, view)
    return view, source, display


def expect_refusal(view: Any, cause: str, what: str) -> None:
    """Check that nothing is drawn, and that one error since the last look says why."""
    picture = capture(view)
    capture(view)
    messages = ERRORS.take()
    ours = not_drawn(messages)
    print(f"  {what}: {ours[0].rpartition(NOT_DRAWN)[2] if ours else 'nothing said'}")
    check_empty(picture, what)
    assert len(ours) == 1, f"{what}: {len(ours)} errors: {ours}"
    assert cause in ours[0], f"{what}: {cause!r} is not in {ours[0]!r}"
    others = [message for message in messages if message not in ours]
    assert not others, f"{what}: further errors: {others}"


def expect_recovery(view: Any, source: Any, display: Any) -> None:
    """Check that good data in the same view are drawn, without an error."""
    replace_output(source, image_data(blob(), "good"))
    color_by(display, view, "good")
    look(view)
    check_not_empty(capture(view), "good data afterwards")
    messages = ERRORS.take()
    assert not messages, f"good data afterwards: {messages}"


def check_empty_image() -> None:
    view, source, display = view_of(vtkImageData())
    check_empty(capture(view), "an empty image")
    assert len(not_drawn(ERRORS.take())) <= 1
    expect_recovery(view, source, display)


def check_good_then_empty_image() -> None:
    view, source, display = view_of(image_data(blob(), "good"))
    color_by(display, view, "good")
    look(view)
    check_not_empty(capture(view), "good data")
    replace_output(source, vtkImageData())
    check_empty(capture(view), "an empty image after a good one")
    assert len(not_drawn(ERRORS.take())) <= 1
    expect_recovery(view, source, display)


def check_thin_image() -> None:
    view, source, display = view_of(image_data(blob()[:, :, :1], "thin"))
    color_by(display, view, "thin")
    look(view)
    expect_refusal(view, "one point thick", "a thin image")
    expect_recovery(view, source, display)


def check_single_point() -> None:
    view, source, display = view_of(image_data(blob()[:1, :1, :1], "point"))
    color_by(display, view, "point")
    expect_refusal(view, "one point thick", "a single point")
    display.ScalarOpacityUnitDistance = (
        1.0  # ParaView took 0 from the size of the point
    )
    expect_recovery(view, source, display)


def check_no_scalars() -> None:
    image = image_data(blob())
    image.GetPointData().RemoveArray(0)
    view, source, display = view_of(image)
    look(view)
    expect_refusal(view, "no scalars", "no scalars")
    expect_recovery(view, source, display)


def check_array_gone() -> None:
    view, source, display = view_of(image_data(blob(), "first"))
    color_by(display, view, "first")
    look(view)
    check_not_empty(capture(view), "good data")
    replace_output(source, image_data(blob(), "second"))
    expect_refusal(view, "first", "an array that is gone")
    expect_recovery(view, source, display)


def check_string_array() -> None:
    image = image_data(blob(6), "numbers")
    words = vtkStringArray()
    words.SetName("words")
    words.SetNumberOfValues(image.GetNumberOfPoints())
    for index in range(image.GetNumberOfPoints()):
        words.SetValue(index, "word")
    image.GetPointData().AddArray(words)
    view, source, display = view_of(image)
    look(view)
    display.ColorArrayName = ["POINTS", "words"]
    display.LookupTable = simple.GetColorTransferFunction("words")
    display.ScalarOpacityFunction = simple.GetOpacityTransferFunction("words")
    expect_refusal(view, "words", "a string array")
    expect_recovery(view, source, display)


def check_no_finite_value() -> None:
    for value in (np.nan, np.inf):
        image = image_data(np.full((6, 6, 6), value, np.float32), "values")
        view, source, display = view_of(image)
        simple.ColorBy(display, ("POINTS", "values"))
        display.SetScalarBarVisibility(view, False)
        look(view)
        expect_refusal(view, "no finite value", f"{value} everywhere")
        expect_recovery(view, source, display)
        simple.ResetSession()


def check_some_values_not_finite() -> None:
    side = 24
    clean = blob(side)
    bad = clean.copy()
    bad[3, 4, 5] = np.nan
    bad[4, 4, 5] = np.inf
    bad[3, 5, 5] = -np.inf
    view, source, display = view_of(image_data(clean))
    color_by(display, view, "values")
    simple.GetOpacityTransferFunction("values").Points = [0, 0, 0.5, 0, 1, 0.3, 0.5, 0]
    simple.GetColorTransferFunction("values").RGBPoints = [0, 0, 0, 1, 1, 1, 0, 0]
    look(view)
    before = capture(view)
    replace_output(source, image_data(bad))
    after = capture(view)
    check_not_empty(after, "NaN and infinity in the data")
    far = ~near_voxels(view, (2, 6, 3, 7, 4, 7), before.shape[:2])
    assert 0.3 < far.mean() < 1, f"{far.mean():.2f} of the pixels are far"
    changed = np.abs(after - before).max(axis=2)
    print(
        f"  far from the bad voxels: at most {changed[far].max()}, near: {changed.max()}"
    )
    assert changed[far].max() == 0, "pixels far from the bad voxels changed"
    expect_recovery(view, source, display)


def near_voxels(view: Any, bounds: tuple, shape: tuple[int, int]) -> np.ndarray:
    """Tell which pixels lie within three pixels of a box's rectangle on the screen."""
    renderer = view.GetRenderer()
    corners = []
    for x in bounds[0:2]:
        for y in bounds[2:4]:
            for z in bounds[4:6]:
                renderer.SetWorldPoint(x, y, z, 1)
                renderer.WorldToDisplay()
                corners.append(renderer.GetDisplayPoint()[:2])
    low = np.floor(np.min(corners, axis=0)).astype(int) - 3
    high = np.ceil(np.max(corners, axis=0)).astype(int) + 3
    near = np.zeros(shape, bool)
    near[max(low[1], 0) : high[1] + 1, max(low[0], 0) : high[0] + 1] = True
    return near[::-1]


def check_constant_scalars() -> None:
    view, source, display = view_of(image_data(np.full((8, 8, 8), 3.0), "constant"))
    color_by(display, view, "constant")
    simple.GetColorTransferFunction("constant").RGBPoints = [2, 1, 1, 1, 4, 1, 1, 1]
    opacity = simple.GetOpacityTransferFunction("constant")
    opacity.Points = [2, 0, 0.5, 0, 4, 0.4, 0.5, 0]
    look(view)
    picture = capture(view)
    check_not_empty(picture, "constant scalars")
    opacity.Points = [2, 0, 0.5, 0, 2.5, 0, 0.5, 0]
    assert capture(view)[..., 3].max() == 0, "opacity 0 is not transparent"
    expect_recovery(view, source, display)


def check_odd_opacity_functions() -> None:
    view, source, display = view_of(image_data(blob()))
    color_by(display, view, "values")
    look(view)
    good = capture(view)
    opacity = simple.GetOpacityTransferFunction("values")
    points = list(opacity.Points)
    for name, odd in (
        ("reversed", [1, 0.5, 0.5, 0, 0, 0.1, 0.5, 0]),
        ("one value", [0.5, 0.5, 0.5, 0, 0.5, 0.9, 0.5, 0]),
        ("beyond the data", [100, 0.2, 0.5, 0, 200, 0.3, 0.5, 0]),
        ("above one", [0, 0, 0.5, 0, 1, 7.0, 0.5, 0]),
        ("single point", [0.5, 0.3, 0.5, 0]),
    ):
        opacity.Points = odd
        picture = capture(view)
        assert np.isfinite(picture).all(), f"{name}: NaN in the picture"
        messages = ERRORS.take()
        print(
            f"  {name}: mean alpha {picture[..., 3].mean():.3f}, {len(messages)} errors"
        )
        assert len(messages) <= 1, f"{name}: {messages}"
    opacity.Points = []
    picture = capture(view)
    assert np.isfinite(picture).all(), "no points: NaN in the picture"
    assert len(not_drawn(ERRORS.take())) <= 1
    opacity.Points = points
    assert rmse(capture(view), good) == 0, "the good function gives another picture"
    expect_recovery(view, source, display)


def check_settings_out_of_range() -> None:
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    look(view)
    good = capture(view)
    for name, values, cause in (
        ("StepVoxels", (0.0, -1.0, 1e-9, float("nan"), float("inf")), "step"),
        (
            "TerminationThreshold",
            (-0.1, 1.0, 2.0, float("nan")),
            "termination threshold",
        ),
        ("ScalarOpacityUnitDistance", (0.0, -1.0), "unit distance"),
        ("JitterSeed", (-1, 16777216), "jitter seed"),
    ):
        usable = display.GetProperty(name).GetData()
        for value in values:
            setattr(display, name, value)
            expect_refusal(view, cause, f"{name} {value}")
            setattr(display, name, usable)
            assert rmse(capture(view), good) == 0, f"after {name} {value} it differs"
    display.StepVoxels = 1000.0
    assert np.isfinite(capture(view)).all(), "StepVoxels 1000: NaN in the picture"


def check_blend_mode_that_we_lack() -> None:
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    look(view)
    good = capture(view)
    display.TechniqueBlendMode = 4
    expect_refusal(view, "blend mode", "another blend mode")
    display.TechniqueBlendMode = 0
    assert rmse(capture(view), good) == 0, "afterwards it differs"


def check_several_blocks() -> None:
    view = new_view()
    display = show(simple.GroupDatasets(Input=[wavelet(4), wavelet(5)]), view)
    color_by(display, view, "RTData")
    look(view)
    expect_refusal(view, "block", "several blocks")


def check_rectilinear_grid() -> None:
    grid = vtkRectilinearGrid()
    grid.SetDimensions(4, 4, 4)
    for place in (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates):
        place(numpy_to_vtk(np.array([0.0, 1.0, 3.0, 7.0]), deep=True))
    array = numpy_to_vtk(np.arange(64.0), deep=True)
    array.SetName("values")
    grid.GetPointData().SetScalars(array)
    view, source, display = view_of(grid)
    color_by(display, view, "values")
    look(view)
    expect_refusal(view, "vtkRectilinearGrid", "a rectilinear grid")
    expect_recovery(view, source, display)


def check_grid_that_is_no_image() -> None:
    view = new_view()
    display = simple.Show(simple.Sphere(), view)
    assert LABEL not in display.GetProperty("Representation").Available


if __name__ == "__main__":
    run_checks(dict(globals()))
