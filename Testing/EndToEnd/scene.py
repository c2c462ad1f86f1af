"""What stands round the volume: geometry, cameras, transforms, cropping, several views."""

from pathlib import Path

import numpy as np
from paraview import simple
from support import (
    ERRORS,
    LABEL,
    SIZE,
    blob,
    capture,
    check_close,
    check_differs,
    check_empty,
    check_not_empty,
    color_by,
    image_data,
    look,
    new_view,
    not_drawn,
    producer,
    read_png,
    replace_output,
    rmse,
    run_checks,
    set_functions,
    show,
    temporary_folder,
    wavelet,
)

SAME_AS_VOLUME = 0.02


def shown_wavelet(label: str = LABEL):
    """Return a view of the wavelet, and its display."""
    view = new_view()
    display = show(wavelet(), view, label)
    color_by(display, view, "RTData")
    look(view)
    return view, display


def compare_with_volume(
    view, display, what: str, bound: float = SAME_AS_VOLUME
) -> np.ndarray:
    """Check our picture against that of ParaView's "Volume", and return ours."""
    ours = capture(view)
    display.SetRepresentationType("Volume")
    volume = capture(view)
    display.SetRepresentationType(LABEL)
    check_close(ours, volume, bound, what)
    return ours


def check_opaque_geometry() -> None:
    view, display = shown_wavelet()
    alone = capture(view)
    sphere = simple.Sphere(Radius=5, ThetaResolution=40, PhiResolution=40)
    surface = simple.Show(sphere, view)
    surface.ColorArrayName = [None, ""]
    surface.DiffuseColor = [0.2, 1.0, 0.2]
    simple.GetOpacityTransferFunction("RTData").Points = [
        value
        for x, a in [(37, 0.0), (150, 0.02), (277, 0.3)]
        for value in (x, a, 0.5, 0)
    ]
    inside = compare_with_volume(view, display, "sphere inside")
    check_differs(inside, alone, "the sphere")

    display.Visibility = 0
    check_differs(inside, capture(view), "the volume before the sphere")
    display.Visibility = 1

    # A sphere before the volume hides it, one behind it changes nothing that the volume covers.
    camera = view.GetActiveCamera()
    towards = np.subtract(camera.GetPosition(), camera.GetFocalPoint())
    towards /= np.linalg.norm(towards)
    sphere.Center = list(25 * towards)
    check_differs(
        compare_with_volume(view, display, "sphere in front"), inside, "its place"
    )
    front = capture(view)
    display.Visibility = 0
    only_sphere = capture(view)
    display.Visibility = 1
    middle = tuple(side // 2 for side in SIZE)
    assert np.array_equal(
        front[middle], only_sphere[middle]
    ), "the volume shows through"
    sphere.Center = list(-25 * towards)
    compare_with_volume(view, display, "sphere behind")


def check_translucent_geometry() -> None:
    view, display = shown_wavelet()
    with temporary_folder() as folder:
        alone = screenshot(view, folder)
        surface = simple.Show(simple.Sphere(Radius=12), view)
        surface.ColorArrayName = [None, ""]
        surface.Opacity = 0.3
        ours = screenshot(view, folder)
        check_differs(ours, alone, "the sphere")
        display.SetRepresentationType("Volume")
        check_close(ours, screenshot(view, folder), 0.05, "translucent sphere")


def screenshot(view, folder: Path, size=SIZE) -> np.ndarray:
    """Return the picture of ParaView's own passes: peeling, tiles and all."""
    path = folder / "screenshot.png"
    simple.SaveScreenshot(str(path), view, ImageResolution=list(size))
    return read_png(path)


def check_screenshot_larger_than_the_view() -> None:
    view, display = shown_wavelet()
    with temporary_folder() as folder:
        ours = screenshot(view, folder, (510, 390))
        display.SetRepresentationType("Volume")
        check_close(
            ours, screenshot(view, folder, (510, 390)), SAME_AS_VOLUME, "510 x 390"
        )


def check_camera_inside() -> None:
    view, display = shown_wavelet()
    view.CameraPosition = [1, 2, 3]
    view.CameraFocalPoint = [10, 4, -2]
    view.CameraViewUp = [0, 1, 0]
    simple.Render(view)
    view.GetRenderer().ResetCameraClippingRange()
    picture = compare_with_volume(view, display, "camera inside", 0.03)
    assert picture[..., 3].min() > 0, "a pixel is empty although the camera is inside"


def check_parallel_projection() -> None:
    view, display = shown_wavelet()
    perspective = capture(view)
    view.CameraParallelProjection = 1
    check_differs(
        compare_with_volume(view, display, "parallel"), perspective, "projection"
    )


def check_transforms() -> None:
    view, display = shown_wavelet()
    before = capture(view)
    for name, value in (
        ("Position", [4.0, -3.0, 2.0]),
        ("Scale", [1.0, 0.5, 1.7]),
        ("Orientation", [20.0, 30.0, 40.0]),
        ("Origin", [5.0, 0.0, 2.0]),
    ):
        setattr(display, name, value)
        picture = compare_with_volume(view, display, name)
        check_differs(picture, before, name)
        before = picture


def check_anisotropic_spacing() -> None:
    view = new_view()
    image = image_data(blob(24), spacing=(1.0, 0.4, 2.5))
    image.SetOrigin(3.0, -7.0, 11.0)
    image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
    display = show(producer(image), view)
    color_by(display, view, "values")
    look(view)
    compare_with_volume(view, display, "spacing, origin and direction")


def check_uniform_scale() -> None:
    view, display = shown_wavelet()
    simple.ResetCamera(view)
    whole = capture(view)
    display.Scale = [3.0, 3.0, 3.0]
    simple.ResetCamera(view)
    large = compare_with_volume(view, display, "three times as large")
    # Opacity counts the data's own length, so the larger actor looks the same from further away.
    check_close(large, whole, 1e-4, "as large as it was")


def check_cropping() -> None:
    view, display = shown_wavelet()
    whole = capture(view)
    display.UseCropping = 1
    check_close(capture(view), whole, 1e-6, "a crop box round everything")
    display.CroppingOrigin = [2.0, -3.0, 1.0]
    display.CroppingScale = [0.4, 0.5, 0.6]
    # ParaView's own is that far from its own picture of the same part of the data.
    cropped = compare_with_volume(view, display, "cropped", 0.05)
    check_differs(cropped, whole, "cropping")
    display.UseCropping = 0
    assert (
        rmse(capture(view), whole) == 0
    ), "without cropping the picture is another one"

    part = simple.ExtractSubset(Input=simple.GetActiveSource())
    part.VOI = [-2, 6, -8, 2, -5, 7]
    display.Visibility = 0
    functions = [display.LookupTable, display.ScalarOpacityFunction]
    points = [list(functions[0].RGBPoints), list(functions[1].Points)]
    of_part = show(part, view)
    color_by(of_part, view, "RTData")
    of_part.ScalarOpacityUnitDistance = display.ScalarOpacityUnitDistance
    functions[0].RGBPoints, functions[1].Points = points
    check_close(cropped, capture(view), 1e-5, "cropped and the same part of the data")


def check_two_views() -> None:
    source = wavelet()
    sizes = [(200, 200), (150, 90)]
    views = [new_view(size) for size in sizes]
    displays = [show(source, view) for view in views]
    for view, display in zip(views, displays):
        color_by(display, view, "RTData")
    look(views[0])
    look(views[1], azimuth=120)
    first = [capture(view) for view in views]
    for view, display, before, size in zip(views, displays, first, sizes):
        assert before.shape[:2] == size[::-1], f"{before.shape} instead of {size}"
        assert np.array_equal(
            capture(view), before
        ), "drawn again, the picture is another one"
        compare_with_volume(view, display, f"view of {size[0]} x {size[1]}")
    displays[0].StepVoxels = 2
    check_differs(capture(views[0]), first[0], "StepVoxels in the first view")
    assert np.array_equal(
        capture(views[1]), first[1]
    ), "it changed in the other view too"


def check_view_closed_and_opened() -> None:
    view, _ = shown_wavelet()
    before = capture(view)
    simple.Delete(view)
    del view
    source = simple.GetActiveSource()
    again = new_view()
    color_by(show(source, again), again, "RTData")
    look(again)
    assert np.array_equal(capture(again), before), "the new view shows another picture"


def check_deleted_while_shown() -> None:
    view, display = shown_wavelet()
    check_not_empty(capture(view), "before")
    simple.Delete(display)
    del display
    check_empty(capture(view), "after the display was deleted")
    source = simple.GetActiveSource()
    color_by(show(source, view), view, "RTData")
    check_not_empty(capture(view), "shown again")
    simple.Delete(source)
    check_empty(capture(view), "after the source was deleted")


def check_resized() -> None:
    view, display = shown_wavelet()
    before = capture(view)
    for size in ((80, 200), (201, 133), (1, 1), SIZE):
        view.ViewSize = list(size)
        picture = capture(view)
        assert picture.shape[:2] == size[::-1], f"{picture.shape} instead of {size}"
    assert np.array_equal(
        picture, before
    ), "back at its size, the picture is another one"
    view.ViewSize = [201, 133]
    compare_with_volume(view, display, "201 x 133")


def check_new_data() -> None:
    view = new_view()
    source = producer(image_data(blob(24)))
    display = show(source, view)
    color_by(display, view, "values")
    look(view)
    before = capture(view)
    replace_output(source, image_data(np.ascontiguousarray(blob(24)[::-1])))
    check_differs(
        compare_with_volume(view, display, "new values"), before, "the values"
    )
    replace_output(source, image_data(blob(12), spacing=(2, 2, 2)))
    compare_with_volume(view, display, "new dimensions")


def check_scalar_types() -> None:
    hill = blob(24)
    pictures = {}
    for kind in ("f8", "f4", "u1", "i1", "u2", "i2", "u4", "i4", "i8", "u8"):
        low, high = (-1e9, 1e9) if kind[0] == "f" else _limits(kind)
        view = new_view()
        display = show(
            producer(image_data((low + hill * (high - low)).astype(kind))), view
        )
        color_by(display, view, "values")
        look(view)
        pictures[kind] = capture(view)
        check_close(pictures[kind], pictures["f8"], 0.005, f"{kind} and f8")
        simple.ResetSession()


def _limits(kind: str) -> tuple[float, float]:
    info = np.iinfo(kind)
    return max(info.min, -1e9), min(info.max, 1e9)


def check_shading() -> None:
    view = new_view()
    display = show(producer(image_data(blob(32, 6))), view)
    color_by(display, view, "values")
    set_functions(
        "values",
        [0, 0.2, 0.4, 1, 1, 1, 0.8, 0.2],
        [(0, 0), (0.3, 0), (0.5, 0.4), (1, 0.8)],
    )
    look(view)
    flat = capture(view)
    display.Shade = 1
    shaded = compare_with_volume(view, display, "shaded", 0.1)
    check_differs(shaded, flat, "Shade", 0.01)
    display.Shade = 0
    assert np.array_equal(
        capture(view), flat
    ), "without Shade the picture is another one"


def check_picking_and_selection() -> None:
    view, _ = shown_wavelet()
    before = capture(view)
    simple.SelectSurfacePoints(Rectangle=[0, 0, 199, 199], View=view)
    simple.ClearSelection()
    assert np.array_equal(capture(view), before), "selecting changed the picture"
    assert not not_drawn(ERRORS.messages)
    ERRORS.take()


def check_interactive_render() -> None:
    view, _ = shown_wavelet()
    before = capture(view)
    view.SMProxy.InteractiveRender()
    view.SMProxy.StillRender()
    assert np.array_equal(capture(view), before), "the still picture is another one"


if __name__ == "__main__":
    run_checks(dict(globals()))
