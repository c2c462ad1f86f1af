"""A machine whose OpenCL has no driver: the plugin loads, one line says so, the rest draws.

Run with OCL_ICD_VENDORS naming an empty folder.
"""

from support import (
    ERRORS,
    NOT_DRAWN,
    capture,
    check_empty,
    check_not_empty,
    color_by,
    look,
    new_view,
    not_drawn,
    run_checks,
    show,
    wavelet,
)


def check_absence_is_said_once_and_the_rest_draws() -> None:
    view = new_view()
    display = show(wavelet(8), view)
    color_by(display, view, "RTData")
    look(view)
    display.SetRepresentationType("Volume OpenCL")
    check_empty(capture(view), "OpenCL without a driver")
    capture(view)
    messages = not_drawn(ERRORS.take())
    assert len(messages) == 1, messages
    print("  " + messages[0])
    assert "'opencl' cannot run here: OpenCL has no driver" in messages[0], messages[0]
    assert "\n" not in messages[0].rpartition(NOT_DRAWN)[2].strip(), messages[0]
    devices = list(display.GetProperty("OpenclDevice").Available)
    assert devices == ["Auto"], devices
    display.SetRepresentationType("Volume Single Pass")
    check_not_empty(capture(view), "another technique")


if __name__ == "__main__":
    run_checks(globals())
