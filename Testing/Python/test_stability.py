"""Stability studies: reading, what rows become, the heat map's page, figure and command line."""

import json
import math
import re

import pytest
from volumebench.__main__ import main
from volumebench.errors import StudyError
from volumebench.results import Context
from volumebench.stability import (
    FAIL,
    NOT_APPLICABLE,
    PASS,
    outcome_of,
    summary_lines,
    write_outcome,
)
from volumebench.stability_colors import BLANK, color_of
from volumebench.stability_plot import write_stability_plot
from volumebench.stability_report import cell_text, write_stability_report
from volumebench.stability_study import StabilityStudy, load_stability_study
from volumebench.study_file import STUDY_FOLDER

NAN = float("nan")


def table_row(case, technique, integrator, status, error=NAN, limit=NAN, meant=0.0):
    return {
        "case": float(case),
        "title": f"Case <{case}>",
        "expectation": "alpha; 1e-3",
        "case_limit": 1e-3,
        "technique": technique,
        "integrator": integrator,
        "meant": meant,
        "status": status,
        "error": error,
        "limit": limit,
        "reason": f"Measured in case {case} & told.",
    }


@pytest.fixture
def outcome():
    return outcome_of(
        [
            table_row(1, "single-pass", "Midpoint", PASS, 1e-5, 1e-3, 1.0),
            table_row(1, "single-pass", "Left", FAIL, 1e-1, 1e-3),
            table_row(1, "vtk-gpu", "", NOT_APPLICABLE),
            table_row(33, "single-pass", "Midpoint", FAIL, 2e-3, 1e-3, 1.0),
            table_row(33, "single-pass", "Left", PASS, 0.0, 1e-3),
            table_row(33, "vtk-gpu", "", FAIL, NAN, 1e-3),
        ]
    )


@pytest.fixture
def stability_file(write_json):
    def write(**values):
        document = {"schema": 1, "kind": "stability", "name": "small"} | values
        return write_json(document, "small.json")

    return write


def test_the_study_of_the_package():
    study = load_stability_study(STUDY_FOLDER / "stability.json")
    assert study.cases == () and study.techniques == () and not study.short
    assert study.quick().short
    assert study.quick().integrators == ("Midpoint", "Segment")


def test_quick_and_techniques_of_the_command_line(stability_file):
    study = load_stability_study(stability_file(cases=[1, 8], quick={"cases": [8]}))
    assert study.cases == (1, 8)
    assert study.quick().cases == (8,)
    only = study.only(["slices", "vtk-gpu"])
    assert only.techniques == ("slices", "vtk-gpu")
    assert only.quick().techniques == ("slices", "vtk-gpu") and only.quick().cases == (
        8,
    )


@pytest.mark.parametrize(
    "values, expected",
    [
        ({"cases": [0]}, "cases"),
        ({"cases": []}, "cases"),
        ({"integrators": ["Simpson"]}, "integrators"),
        ({"techniques": ["warp"]}, "warp"),
        ({"techniques": ["paraview-volume"]}, "views only"),
        ({"quick": {"techniques": ["warp"]}}, "warp"),
        ({"datasets": []}, "datasets"),
    ],
)
def test_faults_name_file_and_key(stability_file, values, expected):
    with pytest.raises(StudyError, match=expected) as fault:
        load_stability_study(stability_file(**values))
    assert "small.json" in str(fault.value)


def test_rows_become_cases_and_columns(outcome):
    assert [case.number for case in outcome.cases] == [1, 33]
    assert outcome.columns() == [
        ("single-pass", "Midpoint"),
        ("single-pass", "Left"),
        ("vtk-gpu", None),
    ]
    assert outcome.row(33, ("vtk-gpu", None)).error is None
    assert outcome.row(2, ("vtk-gpu", None)) is None
    assert [row.case for row in outcome.defects()] == [33]


def test_ratio_of_each_kind_of_row(outcome):
    ratios = [row.ratio_log10() for row in outcome.rows]
    assert ratios[0] == pytest.approx(-2)
    assert ratios[1] == pytest.approx(2)
    assert ratios[2] is None
    assert ratios[4] == -math.inf
    assert ratios[5] == math.inf  # an error that is no number


def test_cells_tell_mark_number_and_control(outcome):
    texts = [cell_text(row) for row in outcome.rows]
    assert texts == ["✓ -2.0", "(✗) +2.0", "(–)", "✗ +0.3", "(✓) -∞", "(✗) NaN"]


def test_colors_part_at_the_limit():
    def red_minus_blue(ratio):
        text = color_of(ratio)
        return int(text[1:3], 16) - int(text[5:7], 16)

    assert red_minus_blue(-0.01) < 0 < red_minus_blue(0.01)
    assert red_minus_blue(0.0) < 0
    assert red_minus_blue(-3) < red_minus_blue(-1)
    assert red_minus_blue(3) > red_minus_blue(1)
    assert color_of(math.inf) == color_of(4) and color_of(-math.inf) == color_of(-4)
    assert color_of(None) == BLANK


def test_file_holds_null_for_what_is_no_number(outcome, tmp_path):
    write_outcome(tmp_path, Context(cores=2), outcome)
    document = json.loads((tmp_path / "stability.json").read_text())
    assert document["schema"] == 1 and document["context"]["cores"] == 2
    assert document["cases"][1] == {
        "number": 33,
        "title": "Case <33>",
        "expectation": "alpha; 1e-3",
        "limit": 1e-3,
    }
    assert document["rows"][5]["error"] is None
    assert document["rows"][5]["integrator"] is None
    assert document["rows"][0]["meant"] is True


def test_page_is_self_contained_and_escaped(outcome, tmp_path):
    write_stability_report(tmp_path, StabilityStudy("small"), Context(), outcome)
    html = (tmp_path / "stability.html").read_text()
    assert not re.findall(r'(?:src|href)="', html)
    assert "<33>" not in html and "Case &lt;33&gt;" in html
    assert "1 of 2 cells that a case is meant for pass" in html
    assert html.count('class="meant defect"') == 1
    assert html.count('class="control"') == 4
    assert 'title="single-pass Left: fail. Measured in case 1 &amp; told."' in html
    assert "33 * Case" in html and "1 * Case" not in html


def test_figure_is_written(outcome, tmp_path):
    write_stability_plot(tmp_path, outcome)
    assert (tmp_path / "plots/stability.png").read_bytes().startswith(b"\x89PNG")


def test_summary_counts_and_names_defects(outcome):
    lines = summary_lines(outcome)
    assert len(lines) == 4
    assert "1 pass, 1 fail" in lines[0] and lines[0].endswith("meant for, 1 pass")
    assert "meant" not in lines[1]
    assert lines[3].startswith("fails case 33 (Case <33>): single-pass Midpoint")


@pytest.mark.parametrize(
    "arguments, expected",
    [
        (["stability", "--resume"], "--resume"),
        (["stability", "--techniques", "warp"], "warp"),
        (["stability", "--techniques", ","], "no run is left"),
    ],
)
def test_bad_command_lines_are_one_line(arguments, expected, capsys):
    assert main(arguments) == 2
    message = capsys.readouterr().err
    assert message.startswith("error: ") and message.count("\n") == 1
    assert expected in message
