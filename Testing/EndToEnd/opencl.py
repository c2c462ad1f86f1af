"""Volume OpenCL: the devices in its panel, and what is said of one that there is not."""

from paraview import simple
from support import (
    ERRORS,
    capture,
    check_empty,
    check_not_empty,
    color_by,
    look,
    new_view,
    not_drawn,
    rmse,
    run_checks,
    show,
    wavelet,
)

LABEL = "Volume OpenCL"


def drawn_wavelet() -> tuple:
    """Return a view of a wavelet and its display."""
    view = new_view()
    display = show(wavelet(8), view)
    color_by(display, view, "RTData")
    look(view)
    return view, display


def check_devices_are_listed_once_opencl_draws() -> None:
    view, display = drawn_wavelet()
    display.SetRepresentationType("Volume Single Pass")
    simple.Render(view)
    devices = list(display.GetProperty("OpenclDevice").Available)
    assert devices == ["Auto"], devices
    display.SetRepresentationType(LABEL)
    check_not_empty(capture(view), LABEL)
    devices = list(display.GetProperty("OpenclDevice").Available)
    print("  " + ", ".join(devices))
    assert devices[0] == "Auto" and len(devices) > 1, devices


def check_device_and_storage_draw_the_picture() -> None:
    view, display = drawn_wavelet()
    display.SetRepresentationType("Volume Single Pass")
    expected = capture(view)
    display.SetRepresentationType(LABEL)
    capture(view)
    for device in list(display.GetProperty("OpenclDevice").Available):
        display.OpenclDevice = device
        for storage in ("Images", "Buffers", "Auto"):
            display.OpenclStorage = storage
            error = rmse(capture(view), expected)
            assert error <= 1e-4, f"{device}, {storage}: RMSE {error:.2g}"


def check_unknown_device_is_named() -> None:
    view, display = drawn_wavelet()
    display.SetRepresentationType(LABEL)
    display.OpenclDevice = "Acme: Abacus"
    check_empty(capture(view), "an unknown device")
    messages = not_drawn(ERRORS.take())
    assert len(messages) == 1, messages
    assert "'Acme: Abacus'; known are Auto, '" in messages[0], messages[0]
    display.OpenclDevice = "Auto"
    check_not_empty(capture(view), "the device of the machine")


if __name__ == "__main__":
    run_checks(globals())
