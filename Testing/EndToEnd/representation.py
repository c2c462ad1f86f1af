"""Choosing our representation, and what a user then does to the picture."""

import numpy as np
from paraview import simple
from support import (
    LABEL,
    blob,
    capture,
    check_close,
    check_differs,
    check_not_empty,
    color_by,
    image_data,
    labels_named_by,
    look,
    new_view,
    producer,
    rmse,
    run_checks,
    set_functions,
    show,
    wavelet,
)

SAME_AS_VOLUME = 0.02
USER_COLORS = [37.0, 0.1, 0.2, 0.9, 150.0, 0.9, 0.8, 0.2, 277.0, 1.0, 0.3, 0.1]
USER_OPACITY = [(37, 0.0), (100, 0.0), (130, 0.3), (160, 0.02), (220, 0.4), (277, 0.0)]


def check_label_is_listed() -> None:
    display = simple.Show(wavelet(4), new_view(), "UniformGridRepresentation")
    assert LABEL in display.GetProperty("Representation").Available


def check_same_picture_as_volume_by_default() -> None:
    view = new_view()
    display = show(wavelet(), view, "Volume")
    color_by(display, view, "RTData")
    look(view)
    volume = capture(view)
    display.SetRepresentationType(LABEL)
    check_close(capture(view), volume, SAME_AS_VOLUME, "default transfer function")


def check_same_picture_as_volume_with_own_functions() -> None:
    view = new_view()
    display = show(wavelet(), view, "Volume")
    color_by(display, view, "RTData")
    set_functions("RTData", USER_COLORS, USER_OPACITY)
    look(view)
    volume = capture(view)
    display.SetRepresentationType(LABEL)
    check_close(capture(view), volume, SAME_AS_VOLUME, "own transfer function")


def check_switching_there_and_back() -> None:
    view = new_view()
    display = show(wavelet(), view, "Volume")
    color_by(display, view, "RTData")
    look(view)
    volume = capture(view)
    pictures = {}
    for label in (LABEL, "Surface", LABEL, "Outline", "Slice", "Volume", LABEL):
        display.SetRepresentationType(label)
        picture = capture(view)
        if label in pictures:
            assert (
                rmse(picture, pictures[label]) == 0
            ), f"{label} differs after a switch"
        pictures[label] = picture
    assert rmse(pictures["Volume"], volume) == 0, "Volume differs after a switch"
    check_differs(pictures["Surface"], pictures[LABEL], "Surface and ours")


def check_transfer_function_edits_take_effect() -> None:
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    look(view)
    before = capture(view)
    simple.GetColorTransferFunction("RTData").RGBPoints = USER_COLORS
    colored = capture(view)
    check_differs(before, colored, "an edit of the colour map")
    opacity = simple.GetOpacityTransferFunction("RTData")
    points = list(opacity.Points)
    opacity.Points = [37, 0.0, 0.5, 0.0, 277, 0.1, 0.5, 0.0]
    check_differs(colored, capture(view), "an edit of the opacity function")
    opacity.Points = points
    assert rmse(colored, capture(view)) == 0, "undoing the edit gave another picture"
    simple.GetColorTransferFunction("RTData").ApplyPreset("Viridis (matplotlib)", True)
    check_differs(colored, capture(view), "a preset")


def check_opacity_unit_distance_takes_effect() -> None:
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    look(view)
    before = capture(view)
    display.ScalarOpacityUnitDistance = 5 * display.ScalarOpacityUnitDistance
    after = capture(view)
    check_differs(before, after, "ScalarOpacityUnitDistance")
    display.SetRepresentationType("Volume")
    check_close(after, capture(view), SAME_AS_VOLUME, "longer unit distance")


def check_scalar_bar() -> None:
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    look(view)
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction("RTData"), view)
    simple.Render(view)
    assert bar.Title == "RTData", f"the scalar bar's title is {bar.Title!r}"
    assert bar.Visibility, "the scalar bar is not visible"
    assert display.ColorArrayName.GetArrayName() == "RTData"


def check_no_array_chosen() -> None:
    view = new_view()
    source = wavelet()
    display = show(source, view)
    simple.ColorBy(display, None)
    look(view)
    check_not_empty(capture(view), "no array chosen")


def check_no_array_chosen_of_a_producer() -> None:
    view = new_view()
    show(producer(image_data(blob())), view)
    look(view)
    check_not_empty(capture(view), "no array chosen")


def check_cell_data() -> None:
    view = new_view()
    cells = simple.PointDatatoCellData(Input=wavelet())
    display = show(cells, view, "Volume")
    color_by(display, view, "RTData", "CELLS")
    look(view)
    volume = capture(view)
    display.SetRepresentationType(LABEL)
    check_close(capture(view), volume, SAME_AS_VOLUME, "cell data")


def check_vector_array() -> None:
    hill = blob()
    vectors = np.stack([hill, hill[::-1] * 2, hill[:, ::-1] * 3], axis=3)
    view = new_view()
    display = show(producer(image_data(vectors, "vectors")), view)
    look(view)
    color_by(display, view, "vectors")
    magnitude = capture(view)
    check_not_empty(magnitude, "magnitude")
    pictures = []
    for component in "XYZ":
        color_by(display, view, ("vectors", component))
        pictures.append(capture(view))
        check_not_empty(pictures[-1], f"component {component}")
        check_differs(pictures[-1], magnitude, f"component {component}")
    check_differs(pictures[0], pictures[1], "component Y instead of X")

    alone = simple.Calculator(Input=producer(image_data(vectors, "vectors")))
    alone.ResultArrayName = "y"
    alone.Function = "vectors_Y"
    other = new_view()
    scalar = show(alone, other)
    color_by(scalar, other, "y")
    look(other)
    check_close(pictures[1], capture(other), 1e-5, "component Y and the same scalar")


def check_settings_take_effect() -> None:
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    set_functions("RTData", USER_COLORS, USER_OPACITY)
    look(view)
    before = capture(view)
    exact = LABEL == "Volume Reference"
    display.StepVoxels = 2
    if exact:
        assert (
            rmse(before, capture(view)) == 0
        ), "the exact picture depends on StepVoxels"
    else:
        check_differs(before, capture(view), "StepVoxels")
    display.StepVoxels = 0.5
    assert rmse(before, capture(view)) == 0, "StepVoxels back gave another picture"
    display.Integrator = "Left"
    if exact:
        assert (
            rmse(before, capture(view)) == 0
        ), "the exact picture depends on Integrator"
    else:
        check_differs(before, capture(view), "Integrator", 1e-4)
    display.Integrator = "Midpoint"
    if LABEL in labels_named_by(display, "TerminationThreshold"):
        threshold = display.TerminationThreshold
        display.TerminationThreshold = 0.3
        check_differs(before, capture(view), "TerminationThreshold")
        display.TerminationThreshold = threshold

    display.Jitter = 1
    if exact:
        assert rmse(before, capture(view)) == 0, "the exact picture depends on Jitter"
    else:
        jittered = capture(view)
        check_differs(before, jittered, "Jitter", 1e-4)
        display.JitterSeed = 1
        check_differs(jittered, capture(view), "JitterSeed", 1e-4)
        display.JitterSeed = 0
        assert rmse(jittered, capture(view)) == 0, "a seed gave two pictures"
    display.Jitter = 0
    assert rmse(before, capture(view)) == 0, "Jitter off gave another picture"

    assert display.RaySetUp == "Rasterised"
    display.RaySetUp = "Box"
    difference = np.abs(capture(view) - before).max(axis=2)
    changed = np.count_nonzero(difference > 1e-5)
    print(f"  RaySetUp changes {changed} pixels by more than 1e-5")
    assert changed <= 0.002 * difference.size, f"RaySetUp changes {changed} pixels"
    assert difference.max() < 0.05, f"RaySetUp changes a pixel by {difference.max()}"


def check_nearest_interpolation() -> None:
    view = new_view()
    display = show(wavelet(4), view, "Volume")
    color_by(display, view, "RTData")
    display.InterpolationType = "Nearest"
    look(view)
    volume = capture(view)
    display.SetRepresentationType(LABEL)
    check_close(capture(view), volume, SAME_AS_VOLUME, "nearest interpolation")


if __name__ == "__main__":
    run_checks(dict(globals()))
