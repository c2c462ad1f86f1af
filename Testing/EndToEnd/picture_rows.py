"""The read-only rows on the last picture: its time, what it used and what it left out, and why."""

import math
import re
import sys
from typing import Any

import numpy as np
from paraview import simple
from parallel import run_client_of_server
from support import (
    ERRORS,
    SIZE,
    capture,
    check_differs,
    color_by,
    load_plugin,
    look,
    new_view,
    not_drawn,
    run_checks,
    set_functions,
    show,
    technique_labels,
    temporary_folder,
    wavelet,
)

SAMPLES = ("SamplesTaken", "SamplesPerRay")
ROWS = {
    "LastFrameMs": "default",
    "UsedText": "advanced",
    "LeftOutText": "default",
    "ExpectedError": "advanced",
    "SamplesText": "default",
}
HAZE = [(37.0, 0.0), (277.0, 0.01)]
WALL = [(37.0, 0.0), (200.0, 0.0), (277.0, 0.9)]
COLORS = [37.0, 0.1, 0.2, 0.9, 277.0, 1.0, 0.3, 0.1]


def drawn_wavelet(opacity: list[tuple[float, float]]) -> tuple[Any, Any]:
    """Return a view of a wavelet with this opacity, and its display."""
    view = new_view()
    display = show(wavelet(10), view)
    color_by(display, view, "RTData")
    set_functions("RTData", COLORS, opacity)
    look(view)
    simple.Render(view)
    return view, display


def text_of(display: Any, name: str) -> str:
    """Return a row of text."""
    return display.GetProperty(name).GetData() or ""


def used(display: Any) -> list[str]:
    """Return what the last picture used."""
    return text_of(display, "UsedText").split(", ")


def reasons(display: Any) -> dict[str, str]:
    """Return what the last picture left out, and why."""
    return dict(re.findall(r"(.+) \((.+)\)", text_of(display, "LeftOutText")))


def frame_ms(display: Any) -> float:
    """Return the time of the last frame."""
    return display.GetProperty("LastFrameMs").GetData()


def expect_left_out(display: Any, label: str, why: str) -> None:
    """Fail unless a feature is left out for this reason."""
    assert label not in used(display), f"{label} is used"
    actual = reasons(display).get(label)
    assert actual == why, f"{label} is left out because {actual!r}, not {why!r}"


def expect_used(display: Any, label: str) -> None:
    """Fail unless a feature is used."""
    assert label in used(display), f"{label}: {text_of(display, 'LeftOutText')}"
    assert label not in reasons(display), f"{label} is left out too"


def expect_nothing(display: Any, what: str) -> None:
    """Fail if a row speaks of a picture."""
    texts = [text_of(display, name) for name in ("UsedText", "LeftOutText")]
    assert texts == ["", ""], f"{what}: {texts}"
    assert math.isnan(frame_ms(display)), f"{what}: {frame_ms(display)} ms"


def check_rows_are_documented_and_shown() -> None:
    _, display = drawn_wavelet(HAZE)
    for name, shown in ROWS.items():
        row = display.GetProperty(name).SMProperty
        assert len(row.GetDocumentation().GetDescription().split()) > 8, name
        assert row.GetPanelVisibility() == shown, name


def check_every_feature_is_used_or_left_out() -> None:
    view, display = drawn_wavelet(HAZE)
    for label in technique_labels():
        display.SetRepresentationType(label)
        simple.Render(view)
        all_labels = sorted(used(display) + list(reasons(display)))
        print(f"  {label}: {text_of(display, 'UsedText')}")
        assert len(all_labels) == len(set(all_labels)) > 20, all_labels
        assert 0 < frame_ms(display) < 60e3, frame_ms(display)


def check_rows_follow_the_picture() -> None:
    view, display = drawn_wavelet(HAZE)
    for label, why in (
        ("shading", "off"),
        ("clip planes", "none"),
        ("opaque geometry", "none"),
        ("early ray termination", "no ray is deep enough to stop early"),
    ):
        expect_left_out(display, label, why)
    display.Shade = 1
    simple.Show(simple.Sphere(Radius=2), view)
    set_functions("RTData", COLORS, WALL)
    simple.Render(view)
    for label in ("shading", "opaque geometry", "early ray termination"):
        expect_used(display, label)
    expect_used(display, "empty space skipping")
    display.Skipping = 0
    display.TerminationThreshold = 0.0
    simple.Render(view)
    expect_left_out(display, "empty space skipping", "off")
    expect_left_out(display, "early ray termination", "off")
    display.TechniqueBlendMode = "Average"
    simple.Render(view)
    expect_left_out(display, "shading", "no effect in this blend mode")
    expect_used(display, "blend mode Average")


def check_slices_say_what_they_cannot_do() -> None:
    view, display = drawn_wavelet(WALL)
    display.SetRepresentationType("Volume Slices")
    simple.Render(view)
    expect_left_out(display, "early ray termination", "not in this technique")


def check_nothing_is_said_of_no_picture() -> None:
    view, display = drawn_wavelet(HAZE)
    display.Visibility = 0
    simple.Render(view)
    expect_nothing(display, "hidden")
    display.Visibility = 1
    simple.Render(view)
    expect_left_out(display, "shading", "off")
    display.ScalarOpacityUnitDistance = -1.0
    simple.Render(view)
    assert not_drawn(ERRORS.take())
    expect_nothing(display, "failed")
    display.ScalarOpacityUnitDistance = 1.0
    display.SetRepresentationType("Surface")
    simple.Render(view)
    display.SMProxy.UpdatePropertyInformation()
    expect_nothing(display, "drawn as a surface")


def check_samples_are_shown_with_their_scale() -> None:
    view, display = drawn_wavelet(WALL)
    picture = capture(view)
    assert math.isnan(scale_of(display))
    display.Show = "Samples per Pixel"
    samples = capture(view)
    check_differs(picture, samples, "Samples per Pixel")
    # Half a voxel along the diagonal of 20 voxels an axis.
    assert scale_of(display) == math.ceil(40 * math.sqrt(3)), scale_of(display)
    expect_used(display, "samples as colours")
    with temporary_folder() as folder:
        state = str(folder / "state.pvsm")
        simple.SaveState(state)
        simple.ResetSession()
        simple.LoadState(state)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(SIZE)
    assert np.array_equal(capture(view), samples), "reopened, the view is another one"
    display = next(
        d for d in simple.GetRepresentations().values() if d.GetProperty("Show")
    )
    assert display.Show == "Samples per Pixel", display.Show
    display.Show = "Picture"
    assert np.array_equal(capture(view), picture), "the picture did not come back"
    expect_left_out(display, "samples as colours", "the picture is drawn")
    display.Show = "Samples per Pixel"
    display.SetRepresentationType("Volume Reference")
    simple.Render(view)
    messages = not_drawn(ERRORS.take())
    assert len(messages) == 1 and "takes no samples" in messages[0], messages


def counted(display: Any, view: Any) -> tuple[float, float, str]:
    """Press Count Samples; return samples, samples per ray and the row's text."""
    display.SMProxy.InvokeCommand("CountSamples")
    simple.Render(view)
    return samples_of(display)


def samples_of(display: Any) -> tuple[float, float, str]:
    numbers = (display.GetProperty(name).GetData() for name in SAMPLES)
    return *numbers, text_of(display, "SamplesText")


def check_samples_are_counted_when_asked_for() -> None:
    view, display = drawn_wavelet(WALL)
    for label in technique_labels():
        display.SetRepresentationType(label)
        simple.Render(view)
        expect_left_out(display, "sample count", "the picture is drawn")
        taken, per_ray, text = counted(display, view)
        pixels = capture(view, count_samples=True)
        assert taken == pixels[..., 0].sum() > 0, (label, taken, pixels[..., 0].sum())
        rays = np.count_nonzero(pixels[..., 0] + pixels[..., 1])
        assert math.isclose(per_ray, taken / rays), (label, per_ray, taken / rays)
        assert f" {per_ray:.4g} per ray; " in text, f"{label}: {text}"
        expect_left_out(display, "sample count", "the picture is drawn")
    view.GetActiveCamera().Azimuth(4)
    simple.Render(view)
    *numbers, old = samples_of(display)
    assert all(map(math.isnan, numbers)) and old == f"{text}: out of date", old
    display.SetRepresentationType("Surface")
    *numbers, refusal = counted(display, view)
    assert all(map(math.isnan, numbers)), numbers
    assert refusal == "not counted: the volume is not shown", refusal


def scale_of(display: Any) -> float:
    """Return how many samples are yellow."""
    return display.GetProperty("FullScaleSamples").GetData()


def check_client_and_server() -> None:
    run_client_of_server(__file__)


def ask_server(port: int) -> None:
    """Read the rows of what a server draws."""
    simple.Connect("127.0.0.1", port)
    load_plugin(remote=True)
    load_plugin()
    view, display = drawn_wavelet(HAZE)
    for shade in (0, 1):
        display.Shade = shade
        simple.Render(view)
        assert view.GetClientSideObject().GetUseDistributedRenderingForRender()
        assert ("shading" in used(display)) == bool(shade), used(display)
        assert (reasons(display).get("shading") == "off") == (not shade)
        assert frame_ms(display) > 0, frame_ms(display)
        display.SMProxy.UpdatePropertyInformation()
        assert frame_ms(display) > 0, "reading all rows lost this one"
    display.Shade, display.ErrorTarget = 0, 0.01
    simple.Render(view)
    expected = display.GetProperty("ExpectedError").GetData()
    assert 0 < expected <= 0.01, expected
    taken, per_ray, text = counted(display, view)
    assert taken > 1e4 and 1 < per_ray < 100 and "million" in text, (taken, text)


if __name__ == "__main__":
    if sys.argv[1:2] == ["client"]:
        ask_server(int(sys.argv[2]))
    else:
        run_checks(dict(globals()))
