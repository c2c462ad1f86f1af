"""Transfer functions of other programs in ParaView: loaded by path, and exchanged by the macros."""

import sys
from pathlib import Path

from paraview import simple
from support import (
    ERRORS,
    capture,
    check_close,
    check_differs,
    check_not_empty,
    color_by,
    look,
    new_view,
    run_checks,
    show,
    temporary_folder,
    wavelet,
)

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Python"))

from volumebench.control_points import value_at  # noqa: E402
from volumebench.errors import BenchError  # noqa: E402
from volumebench.macros import write_macros  # noqa: E402
from volumebench.paraview_functions import get_function  # noqa: E402
from volumebench.paraview_functions import import_presets  # noqa: E402
from volumebench.paraview_functions import load_for_active_volume  # noqa: E402
from volumebench.transfer_functions import load_transfer_function  # noqa: E402
from volumebench.voreen_functions import read_tfi  # noqa: E402

TFI = """<VoreenData version="1"><TransFuncIntensity><Keys>
<key><intensity value="0.25"/><split value="true"/><colorL r="0" g="0" b="0" a="0"/>
<colorR r="255" g="51" b="0" a="51"/></key>
<key><intensity value="1"/><split value="false"/><colorL r="0" g="255" b="0" a="102"/></key>
</Keys></TransFuncIntensity></VoreenData>
"""


def shown_wavelet() -> tuple:
    """Return a view with a wavelet as the active source, and its range."""
    view = new_view()
    source = wavelet()
    display = show(source, view)
    color_by(display, view, "RTData")
    look(view)
    simple.SetActiveSource(source)
    simple.SetActiveView(view)
    return view, display, source.PointData["RTData"].GetRange(0)


def run_macro(path: Path) -> None:
    """Run a macro as ParaView does."""
    exec(compile(path.read_text(), str(path), "exec"), {"__file__": str(path)})


def expect_function(low: float, high: float) -> None:
    """Check that the active volume is shown through the function of TFI."""
    function = get_function("RTData", "shown", 1)
    for share, alpha in ((0.1, 0), (0.2499, 0), (0.2501, 0.2), (0.625, 0.3), (1, 0.4)):
        found = value_at(function.opacity, low + share * (high - low))[0]
        assert abs(found - alpha) < 1e-3, f"{share}: {found}, not {alpha}"
    red, green, blue = value_at(function.color, low + 0.625 * (high - low))
    assert abs(red - 0.5) + abs(green - 0.6) + abs(blue) < 1e-3, (red, green, blue)


def check_a_file_is_loaded_by_its_path() -> None:
    view, display, (low, high) = shown_wavelet()
    before = capture(view)
    with temporary_folder() as folder:
        path = folder / "green.tfi"
        path.write_text(TFI)
        assert load_for_active_volume(path).startswith("green: RTData from")
        expect_function(low, high)
        # A 200th of the mean edge of 20.
        assert abs(display.ScalarOpacityUnitDistance - 0.1) < 1e-9
        check_differs(capture(view), before, "another function")


def check_macros_exchange_functions() -> None:
    view, display, (low, high) = shown_wavelet()
    with temporary_folder() as folder:
        macros = {path.stem: path for path in write_macros(folder / "Macros")}
        functions = folder / "TransferFunctions"
        (functions / "green.tfi").write_text(TFI)
        (functions / "broken.tfi").write_text("<VoreenData/>")
        for _ in range(2):  # the second time replaces the first
            run_macro(macros["import_transfer_functions"])
            (told,) = [text for text in ERRORS.take() if text.strip()]
            assert "broken.tfi: holds no Keys" in told, told
        simple.GetColorTransferFunction("RTData").ApplyPreset("green", True)
        simple.GetOpacityTransferFunction("RTData").ApplyPreset("green", True)
        color = simple.GetColorTransferFunction("RTData")
        assert list(color.RGBPoints)[1:4] == [0, 0, 0], list(color.RGBPoints)
        load_for_active_volume(functions / "green.tfi")
        expect_function(low, high)
        picture = capture(view)
        check_not_empty(picture, "the function")
        run_macro(macros["export_transfer_function"])
        names = sorted(path.name for path in functions.iterdir())
        written = ["RTData.json", "RTData.preset.json", "RTData.tfi"]
        assert names == [*written, "broken.tfi", "green.tfi"], names
        assert import_presets(functions) == ["RTData", "green"], "each name once"
        assert len(ERRORS.take()) > 0
        first = load_transfer_function(functions / "RTData.json")
        assert first.domain == "value"
        again = read_tfi(functions / "RTData.tfi", high)
        for x in (low + 0.5 * (high - low), low + 0.9 * (high - low)):
            ours, theirs = value_at(first.opacity, x), value_at(again.opacity, x)
            assert abs(ours[0] - theirs[0]) < 0.6 / 255, (ours, theirs)
        load_for_active_volume(functions / "RTData.json")
        check_close(capture(view), picture, 1e-3, "our own file")


def check_colors_are_exported_as_they_are_shown() -> None:
    """ParaView's own colour map is no straight line in RGB."""
    _, display, (low, high) = shown_wavelet()
    colors = simple.GetColorTransferFunction("RTData")
    assert colors.ColorSpace == "Diverging", colors.ColorSpace
    found = get_function("RTData", "shown", 1).color
    colors.Discretize = 0
    table = colors.GetClientSideObject()
    for share in (0.1, 0.25, 0.75, 0.95):
        x = low + share * (high - low)
        expected = [0.0, 0.0, 0.0]
        table.GetColor(x, expected)
        for ours, theirs in zip(value_at(found, x), expected):
            assert abs(ours - theirs) < 2e-3, (share, value_at(found, x), expected)
    colors.UseLogScale = 1
    try:
        get_function("RTData", "shown", 1)
    except BenchError as fault:
        assert "logarithmic" in str(fault)
    else:
        raise AssertionError("a logarithmic colour map was taken for a plain one")


def check_without_a_volume_one_line_tells_what_to_do() -> None:
    new_view()
    simple.SetActiveSource(None)
    try:
        load_for_active_volume(Path("/nowhere.tfi"))
    except BenchError as fault:
        assert "select a volume" in str(fault)
    else:
        raise AssertionError("a function was loaded for nothing")


run_checks(globals())
