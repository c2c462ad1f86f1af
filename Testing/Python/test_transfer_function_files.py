"""Voreen's and ParaView's transfer functions: round trips, jumps, thresholds, and faults in one line."""

import json
import os
from dataclasses import replace
from pathlib import Path

import pytest
from volumebench.control_points import JUMP_WIDTH, ascending, value_at
from volumebench.errors import StudyError
from volumebench.macros import MACROS, write_macros
from volumebench.macros import main as macros_main
from volumebench.paraview_presets import read_preset, read_presets, write_presets
from volumebench.transfer_functions import TRANSFER_FUNCTION_FOLDER
from volumebench.transfer_functions import TransferFunction, load_transfer_function
from volumebench.transfer_functions import save_transfer_function
from volumebench.voreen_functions import read_tfi, write_tfi

ROOT = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("VOLUMEBENCH_DATA", ROOT.parent / "shared" / "data")) / "tf"
PRESETS = DATA / "paraview_color_presets.json"


def key(place, left, right=None, split=None) -> str:
    """Return a key of a .tfi file; colours are (r, g, b, a)."""
    colors = [("colorL", left)] + ([("colorR", right)] if right else [])
    items = "".join(
        f'<{name} r="{c[0]}" g="{c[1]}" b="{c[2]}" a="{c[3]}"/>' for name, c in colors
    )
    split = ("true" if right else "false") if split is None else split
    return f'<key><intensity value="{place}"/><split value="{split}"/>{items}</key>'


def tfi(keys: str, more: str = "") -> str:
    return (
        '<?xml version="1.0" ?><VoreenData version="1"><TransFuncIntensity>'
        f"{more}<Keys>{keys}</Keys></TransFuncIntensity></VoreenData>"
    )


RAMP = key(0, (0, 0, 255, 0)) + key(1, (255, 0, 0, 255))


@pytest.fixture
def read(tmp_path):
    def read_text(text: str, **options) -> TransferFunction:
        path = tmp_path / "f.tfi"
        path.write_text(text, encoding="utf-8")
        return read_tfi(path, **options)

    return read_text


def test_tfi_keys_are_points(read):
    function = read(tfi(key(0.5, (51, 0, 102, 153)) + RAMP))
    assert function.opacity == ((0, 0), (0.5, 0.6), (1, 1))
    assert function.color == ((0, 0, 0, 1), (0.5, 0.2, 0, 0.4), (1, 1, 0, 0))
    assert function.domain == "normalized" and function.name == "f"
    assert function.unit_distance_edges == 1 / 200


def test_a_split_key_is_a_jump(read):
    keys = key(0, (0, 0, 0, 0)) + key(0.5, (0, 0, 0, 51), (255, 0, 0, 255))
    function = read(tfi(keys))
    assert function.opacity == ((0, 0), (0.5 - JUMP_WIDTH, 0.2), (0.5, 1))
    assert value_at(function.opacity, 0.4999)[0] == pytest.approx(0.2, abs=1e-3)
    assert value_at(function.opacity, 0.5) == (1,)
    at_the_ends = read(
        tfi(key(0, (9, 9, 9, 9), (0, 0, 0, 255)) + key(1, (0, 0, 0, 51), (0, 0, 0, 0)))
    )
    assert at_the_ends.opacity == ((0, 1), (1 - JUMP_WIDTH, 0.2), (1, 0))


def test_two_keys_at_one_place_are_a_jump(read):
    keys = key(0.5, (0, 0, 0, 51)) + key(0.5, (0, 0, 0, 255)) + key(1, (0, 0, 0, 0))
    assert read(tfi(keys)).opacity[:2] == ((0.5 - JUMP_WIDTH, 0.2), (0.5, 1))


def test_a_single_key_is_a_constant(read):
    assert read(tfi(key(0.3, (0, 0, 0, 51)))).opacity == ((0, 0.2), (1, 0.2))


def test_alpha_modes(read):
    for text, expected in (
        ('<alphaMode value="0"/>', 0),
        ('<alphaMode value="1"/>', None),
        ('<alphaMode value="2"/>', 1),
        ('<ignoreAlpha value="true"/>', 1),
        ('<ignoreAlpha value="false"/>', None),
    ):
        opacity = read(tfi(RAMP, text)).opacity
        constant = ((0, expected), (1, expected))
        assert opacity == (((0, 0), (1, 1)) if expected is None else constant)


def test_nothing_is_seen_outside_of_the_threshold(read):
    opacity = read(tfi(RAMP, '<threshold x="0.25" y="0.75"/>')).opacity
    for x, alpha in ((0.1, 0), (0.2499, 0), (0.2501, 0.2501), (0.5, 0.5)):
        assert value_at(opacity, x)[0] == pytest.approx(alpha, abs=1e-6)
    for x, alpha in ((0.7499, 0.7499), (0.7501, 0), (1, 0)):
        assert value_at(opacity, x)[0] == pytest.approx(alpha, abs=1e-6)
    below = read(tfi(RAMP, '<threshold x="0" y="0.5"/>')).opacity
    assert value_at(below, 0)[0] == 0 and value_at(below, 0.6)[0] == 0
    assert value_at(below, 0.4)[0] == pytest.approx(0.4, abs=1e-5)


def test_the_domain_is_a_share_of_the_full_scale(read):
    """As in Voreen's walnut, whose 16-bit values use a third of their range."""
    text = tfi(RAMP, '<domain x="0.25" y="0.5"/>')
    assert read(text).domain == "normalized"
    function = read(text, full_scale=65536)
    assert function.domain == "value"
    assert function.opacity == ((16384, 0), (32768, 1))


def same(first: TransferFunction, second: TransferFunction) -> bool:
    return (first.opacity, first.color) == (second.opacity, second.color)


@pytest.mark.parametrize(
    "keys",
    [
        RAMP,
        key(0.25, (1, 2, 3, 4)) + key(0.5, (5, 6, 7, 8), (255, 254, 253, 252)),
        key(0, (0, 0, 0, 0)) + key(1, (10, 10, 10, 10), (20, 20, 20, 20)),
    ],
)
def test_tfi_round_trip(read, tmp_path, keys):
    first = read(tfi(keys))
    write_tfi(first, tmp_path / "again.tfi")
    assert same(read_tfi(tmp_path / "again.tfi"), first)


def test_functions_of_ours_survive_tfi(tmp_path):
    """Alpha and colours are rounded to 255ths; places stay, and so does a scale of values."""
    for path in sorted(TRANSFER_FUNCTION_FOLDER.glob("*.json")):
        function = load_transfer_function(path)
        scale = None if function.domain == "normalized" else 65535.0
        write_tfi(function, tmp_path / "f.tfi", scale)
        again = read_tfi(tmp_path / "f.tfi", scale)
        for x in {point[0] for point in (*function.opacity, *function.color)}:
            for ours, theirs in (
                (function.opacity, again.opacity),
                (function.color, again.color),
            ):
                expected = pytest.approx(value_at(ours, x), abs=0.51 / 255)
                assert value_at(theirs, x) == expected, path.name


def test_values_need_a_full_scale(tmp_path):
    function = TransferFunction(
        "f", "", "value", ((0, 0), (9, 1)), ((0, 0, 0, 0), (9, 1, 1, 1)), 1.0
    )
    with pytest.raises(StudyError, match="f.tfi: f is over scalar values"):
        write_tfi(function, tmp_path / "f.tfi")


@pytest.mark.skipif(not DATA.is_dir(), reason=f"{DATA} is not there")
@pytest.mark.parametrize("path", sorted(DATA.glob("*.tfi")), ids=lambda path: path.name)
def test_tfi_files_of_others_survive(path, tmp_path):
    first = read_tfi(path)
    count = path.read_text().count("<key ")
    assert len(first.color) == count == len(first.opacity)
    write_tfi(first, tmp_path / "again.tfi")
    assert same(read_tfi(tmp_path / "again.tfi"), first)
    write_presets([first], tmp_path / "preset.json")
    preset = read_preset(tmp_path / "preset.json")
    low, high = first.color[0][0], first.color[-1][0]
    for ours, theirs in ((first.color, preset.color), (first.opacity, preset.opacity)):
        for point in ours:
            place = (point[0] - low) / (high - low)
            assert value_at(theirs, place) == pytest.approx(point[1:])
    save_transfer_function(first, tmp_path / "own.json")
    assert same(load_transfer_function(tmp_path / "own.json"), first)


@pytest.mark.parametrize(
    "text, expected",
    [
        ("", "not valid XML"),
        ("<VoreenData/>", "holds no Keys"),
        (tfi(""), "Keys has no key"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><a/>', "declares entities"),
        (tfi("<key/>"), "key 1: intensity is missing"),
        (tfi(key(1.5, (0, 0, 0, 0))), "key 1: intensity 1.5 is not from 0 to 1"),
        (tfi(key("x", (0, 0, 0, 0))), 'key 1: intensity: value "x" is no number'),
        (tfi(key("nan", (0, 0, 0, 0))), '"nan" is no number'),
        (tfi(RAMP + key(0, (0, 256, 0, 0))), "key 3: colorL: 256 is not from 0 to 255"),
        (tfi(key(0, (0, 0, 0, 0), split="true")), "key 1: colorR is missing"),
        (tfi(key(0, (0, 0, 0, 0), split="maybe")), 'split "maybe" is neither'),
        (tfi(RAMP, '<domain x="1" y="0"/>'), "domain from 1 to 0 does not ascend"),
        (tfi(RAMP, '<threshold x="0" y="2"/>'), "threshold from 0 to 2 leaves 0 to 1"),
        (tfi(RAMP, '<gammaValue value="2"/>'), "gammaValue is not 1"),
        (tfi(RAMP, '<alphaMode value="3"/>'), 'alphaMode "3" is not 0, 1 or 2'),
    ],
)
def test_faults_of_tfi_files(read, text, expected):
    with pytest.raises(StudyError) as caught:
        read(text)
    assert expected in str(caught.value) and "f.tfi: " in str(caught.value)
    assert "\n" not in str(caught.value)


def preset(**changes) -> dict:
    given = {
        "Name": "glow",
        "ColorSpace": "RGB",
        "RGBPoints": [10, 0, 0, 0, 15, 1, 0, 0, 20, 1, 1, 1],
        "Points": [10, 0, 0.5, 0, 17.5, 0.25, 0.5, 0, 20, 1, 0.5, 0],
    } | changes
    return {name: value for name, value in given.items() if value is not None}


def test_presets_are_stretched_to_one(write_json):
    function = read_preset(write_json([preset()], "p.json"))
    assert function.name == "glow" and function.unit_distance_voxels == 1
    assert function.color == ((0, 0, 0, 0), (0.5, 1, 0, 0), (1, 1, 1, 1))
    assert function.opacity == ((0, 0), (0.75, 0.25), (1, 1))


def test_a_preset_without_opacities_is_a_ramp(write_json):
    function = read_preset(write_json(preset(Points=None), "p.json"))
    assert function.opacity == ((0, 0), (1, 1))


def test_one_of_several_presets_is_named(write_json):
    path = write_json([preset(), preset(Name="dim")], "p.json")
    assert [function.name for function in read_presets(path)] == ["glow", "dim"]
    assert read_preset(path, "dim").name == "dim"
    with pytest.raises(StudyError, match="2 presets; say which: glow, dim"):
        read_preset(path)
    with pytest.raises(StudyError, match='no preset "bright", but glow, dim'):
        read_preset(path, "bright")


def test_presets_round_trip(tmp_path):
    functions = [
        load_transfer_function(path)
        for path in sorted(TRANSFER_FUNCTION_FOLDER.glob("*.json"))
    ]
    functions = [item for item in functions if item.domain == "normalized"]
    spanning = [item for item in functions if item.color[0][0] == 0]
    spanning = [item for item in spanning if item.color[-1][0] == 1]
    assert len(spanning) > 4
    write_presets(spanning, tmp_path / "p.json")
    for ours, theirs in zip(spanning, read_presets(tmp_path / "p.json"), strict=True):
        assert same(ours, theirs) and ours.name == theirs.name


def test_other_color_spaces_are_sampled(write_json):
    core = pytest.importorskip("vtkmodules.vtkRenderingCore")
    points = [0, 0.2, 0.3, 0.8, 1, 0.7, 0.1, 0.1]
    white = {}
    for space in ("Diverging", "Lab", "HSV"):
        item = preset(ColorSpace=space, RGBPoints=points, Points=None)
        function = read_preset(write_json(item, "p.json"))
        expected = core.vtkColorTransferFunction()
        getattr(expected, f"SetColorSpaceTo{space}")()
        expected.AddRGBPoint(*points[:4])
        expected.AddRGBPoint(*points[4:])
        for i in range(101):
            color = value_at(function.color, i / 100)
            assert color == pytest.approx(expected.GetColor(i / 100), abs=2e-3)
        white[space] = min(value_at(function.color, 0.5))
    assert white["Diverging"] > 0.8 > white["Lab"]


def test_bent_opacities_are_sampled(write_json):
    data = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    points = [0, 0, 0.25, 0.4, 1, 1, 0.5, 0]
    item = preset(Points=points, RGBPoints=[0, 0, 0, 0, 1, 1, 1, 1])
    function = read_preset(write_json(item, "p.json"))
    expected = data.vtkPiecewiseFunction()
    expected.AddPoint(*points[:4])
    expected.AddPoint(*points[4:])
    for i in range(101):
        alpha = value_at(function.opacity, i / 100)[0]
        assert alpha == pytest.approx(expected.GetValue(i / 100), abs=2e-3)
    assert value_at(function.opacity, 0.25)[0] > 0.4


@pytest.mark.skipif(not PRESETS.is_file(), reason=f"{PRESETS} is not there")
def test_presets_of_paraview_survive(tmp_path):
    pytest.importorskip("vtkmodules.vtkRenderingCore")
    functions = read_presets(PRESETS)
    assert len(functions) == 6
    write_presets(functions, tmp_path / "again.json")
    for first, second in zip(functions, read_presets(tmp_path / "again.json")):
        assert same(first, second) and first.name == second.name


@pytest.mark.parametrize(
    "document, expected",
    [
        ("[", "not valid JSON"),
        ([], "holds no preset"),
        ([7], "preset 1 is no object"),
        (preset(Name=None), "Name is missing"),
        (preset(RGBPoints=None), "RGBPoints is no list of 4 n numbers"),
        (preset(RGBPoints=[0, 0, 0, 0]), "RGBPoints is no list of 4 n numbers"),
        (preset(RGBPoints=None, IndexedColors=[1, 1, 1]), "colours for categories"),
        (preset(RGBPoints=[0, 0, 0, 0, 1, 0, 0, "x"]), "RGBPoints: 'x' is no number"),
        (preset(RGBPoints=[0, 0, 0, 0, 1, 0, 0, 7]), "RGBPoints: 7 is not from 0 to 1"),
        (preset(RGBPoints=[1, 0, 0, 0, 0, 0, 0, 1]), "RGBPoints: x 0 descends"),
        (preset(RGBPoints=[1, 0, 0, 0, 1, 0, 0, 1], Points=None), "have one x"),
        (preset(Points=[0, 0, 2, 0, 1, 1, 0.5, 0]), "Points: 2 is not from 0 to 1"),
        (preset(ColorSpace="Step"), "ColorSpace 'Step' cannot be read"),
        (preset(ColorSpace=["RGB"]), "cannot be read; known are RGB"),
        ('{"Name": "a", "Name": "b"}', 'key "Name" appears twice'),
        ("1" * 5000, "not valid JSON"),
    ],
)
def test_faults_of_presets(write_json, document, expected):
    path = write_json(document, "p.json")
    with pytest.raises(StudyError) as caught:
        read_presets(path)
    assert expected in str(caught.value) and "p.json: " in str(caught.value)
    assert "\n" not in str(caught.value)


def test_missing_files_are_named(tmp_path):
    for read_file in (read_tfi, read_presets):
        with pytest.raises(StudyError, match="none: cannot be read"):
            read_file(tmp_path / "none")


@pytest.mark.parametrize("unit", ["voxels", "edges"])
def test_our_own_files_round_trip(tmp_path, unit):
    function = TransferFunction(
        "f", "what", "normalized", ((0, 0), (1, 1)), ((0, 0, 0, 0), (1, 1, 1, 1)), 2.0
    )
    if unit == "edges":
        function = replace(function, unit_distance_voxels=None, unit_distance_edges=0.5)
    save_transfer_function(function, tmp_path / "f.json")
    assert load_transfer_function(tmp_path / "f.json") == function


def test_jumps_between_close_points_stay_in_order():
    close = 0.5 + JUMP_WIDTH / 4
    points = ascending([(0.5, (0,), (0.1,)), (close, (0.2,), (0.3,)), (1, (1,), (1,))])
    places = [point[0] for point in points]
    assert places == sorted(set(places)) and len(points) == 5


def test_macros_are_written_with_their_paths(tmp_path, capsys):
    folder = tmp_path / "Macros"
    paths = write_macros(folder)
    assert sorted(path.stem for path in paths) == sorted(MACROS)
    for path in paths:
        text = path.read_text()
        compile(text, str(path), "exec")
        assert repr(str(ROOT / "Python")) in text
        assert repr(str(tmp_path / "TransferFunctions")) in text
    assert (tmp_path / "TransferFunctions").is_dir()
    (tmp_path / "file").write_text("")
    assert macros_main([str(tmp_path / "file" / "sub")]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_json_of_presets_is_what_paraview_writes(tmp_path):
    """ParaView takes a list of objects with these keys."""
    function = read_preset_text(tmp_path)
    write_presets([function], tmp_path / "p.json")
    (item,) = json.loads((tmp_path / "p.json").read_text())
    assert item["RGBPoints"][:4] == [0, 0, 0, 1]
    assert item["Points"] == [0, 0, 0.5, 0, 1, 1, 0.5, 0]
    assert item["Name"] == "f" and item["ColorSpace"] == "RGB"


def read_preset_text(tmp_path) -> TransferFunction:
    (tmp_path / "f.tfi").write_text(tfi(RAMP))
    return read_tfi(tmp_path / "f.tfi")
