"""The button "Estimate Error": its numbers are of the picture on the screen, or say they are not."""

import math
import shutil
import sys
from typing import Any

from parallel import MPI, run_client_of_server, start
from paraview import simple
from support import (
    LABEL,
    capture,
    color_by,
    load_plugin,
    look,
    new_view,
    run_checks,
    show,
    temporary_folder,
    wavelet,
)

NUMBERS = ("ErrorRmse", "LargestError", "ReferenceSeconds", "FrameMs")
ROWS = ("EstimateError", "ErrorText", *NUMBERS)
ONE_PROCESS = "not estimated: Estimate Error works on one process so far"


def drawn_wavelet() -> tuple[Any, Any]:
    """Return a view of a wavelet, and its display."""
    view = new_view()
    display = show(wavelet(6), view)
    color_by(display, view, "RTData")
    look(view)
    simple.Render(view)
    return view, display


def press(display: Any) -> None:
    """Press the button; in the panel that also renders."""
    display.SMProxy.InvokeCommand("EstimateError")


def text_of(display: Any) -> str:
    """Return the line of text."""
    return display.GetProperty("ErrorText").GetData() or ""


def numbers_of(display: Any) -> list[float]:
    """Return the four numbers, NaN where there are none."""
    return [display.GetProperty(name).GetData() for name in NUMBERS]


def estimate(display: Any, view: Any) -> list[float]:
    """Return the four numbers for the present picture."""
    press(display)
    simple.Render(view)
    numbers = numbers_of(display)
    print("  ", text_of(display), numbers)
    assert all(math.isfinite(n) and n > 0 for n in numbers), numbers
    assert text_of(display).startswith("RMSE "), text_of(display)
    assert "out of date" not in text_of(display), text_of(display)
    return numbers


def expect_out_of_date(display: Any, what: str) -> None:
    """Fail if numbers are shown or the text does not say that they are old."""
    assert all(
        math.isnan(n) for n in numbers_of(display)
    ), f"{what}: {numbers_of(display)}"
    assert text_of(display).endswith("out of date"), f"{what}: {text_of(display)!r}"


def check_rows_are_documented_and_shown() -> None:
    _, display = drawn_wavelet()
    for name in ROWS:
        row = display.GetProperty(name).SMProperty
        assert len(row.GetDocumentation().GetDescription().split()) > 8, name
        assert row.GetPanelVisibility() == "default", name
    assert (
        display.GetProperty("EstimateError").SMProperty.GetPanelWidget()
        == "command_button"
    )


def check_nothing_is_estimated_unasked() -> None:
    view, display = drawn_wavelet()
    simple.Render(view)
    assert text_of(display) == "" and all(map(math.isnan, numbers_of(display)))


def check_smaller_steps_have_smaller_errors() -> None:
    view, display = drawn_wavelet()
    display.StepVoxels = 1.0
    coarse = estimate(display, view)
    assert "at Midpoint, step 1;" in text_of(display), text_of(display)
    display.StepVoxels = 0.25
    simple.Render(view)
    expect_out_of_date(display, "another step")
    fine = estimate(display, view)
    assert "at Midpoint, step 0.25;" in text_of(display), text_of(display)
    assert fine[0] < 0.5 * coarse[0] and fine[1] < coarse[1], (coarse, fine)


def check_changes_put_it_out_of_date() -> None:
    view, display = drawn_wavelet()
    opacity = simple.GetOpacityTransferFunction("RTData")
    low, high = opacity.Points[0], opacity.Points[-4]
    for what, change in (
        ("camera", lambda: view.GetActiveCamera().Azimuth(4)),
        ("technique", lambda: display.SetRepresentationType("Volume Multi Pass")),
        (
            "opacity",
            lambda: setattr(opacity, "Points", [low, 0, 0.5, 0, high, 0.6, 0.5, 0]),
        ),
        ("view size", lambda: setattr(view, "ViewSize", [220, 180])),
        ("shading", lambda: setattr(display, "Shade", 1)),
    ):
        estimate(display, view)
        simple.Render(view)
        assert math.isfinite(
            numbers_of(display)[0]
        ), f"before {what}: {text_of(display)}"
        change()
        simple.Render(view)
        expect_out_of_date(display, what)


def check_it_is_out_of_date_before_the_next_picture() -> None:
    view, display = drawn_wavelet()
    estimate(display, view)
    view.GetActiveCamera().Azimuth(4)
    display.SMProxy.UpdatePropertyInformation()
    expect_out_of_date(display, "camera")


def check_it_agrees_with_two_pictures() -> None:
    view, display = drawn_wavelet()
    rmse, largest, *_ = estimate(display, view)
    ours = capture(view).astype(float)
    display.SetRepresentationType("Volume Reference")
    exact = capture(view).astype(float)
    covered = (ours[..., 3] > 0) | (exact[..., 3] > 0)
    difference = (ours - exact)[covered]
    expected = math.sqrt((difference**2).mean())
    assert abs(rmse - expected) < 1e-3 * expected, (rmse, expected)
    assert abs(largest - abs(difference).max()) < 1e-2 * largest


def check_refusals() -> None:
    view, display = drawn_wavelet()
    display.SetRepresentationType("Volume Reference")
    press(display)
    simple.Render(view)
    assert text_of(display) == "not estimated: this technique is the reference itself"
    display.SetRepresentationType("Surface")
    press(display)
    simple.Render(view)
    display.SetRepresentationType(LABEL)
    simple.Render(view)
    assert text_of(display) == "not estimated: the volume is not shown", text_of(
        display
    )


def check_states_do_not_ask_for_it() -> None:
    view, display = drawn_wavelet()
    estimate(display, view)
    with temporary_folder() as folder:
        state = str(folder / "state.pvsm")
        simple.SaveState(state)
        simple.ResetSession()
        simple.LoadState(state)
    simple.Render(simple.GetActiveViewOrCreate("RenderView"))
    loaded = [
        d for d in simple.GetRepresentations().values() if d.GetProperty("ErrorText")
    ]
    assert [text_of(d) for d in loaded] == [""], [text_of(d) for d in loaded]
    assert all(map(math.isnan, numbers_of(loaded[0]))), numbers_of(loaded[0])


def check_two_ranks_refuse() -> None:
    done = start([*MPI, shutil.which("pvbatch"), "--sym", __file__, "ranks"])
    assert done.stdout.count(ONE_PROCESS) == 2, done.stdout + done.stderr


def check_client_and_server_refuse() -> None:
    run_client_of_server(__file__)


def ask_server(port: int) -> None:
    """Ask for the error of what a server draws, and of what the client does."""
    simple.Connect("127.0.0.1", port)
    load_plugin(remote=True)
    load_plugin()
    view, display = drawn_wavelet()
    for threshold in (0, 1000):
        view.RemoteRenderThreshold = threshold
        press(display)
        simple.Render(view)
        assert text_of(display) == ONE_PROCESS, text_of(display)


def print_refusal() -> None:
    """Of each rank of a parallel run."""
    load_plugin()
    view, display = drawn_wavelet()
    press(display)
    simple.Render(view)
    print(text_of(display), flush=True)


if __name__ == "__main__":
    if sys.argv[1:] == ["ranks"]:
        print_refusal()
    elif sys.argv[1:2] == ["client"]:
        ask_server(int(sys.argv[2]))
    else:
        run_checks(dict(globals()))
