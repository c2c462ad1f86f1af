"""The first study of the documentation is true: its file, its size, its errors and its answer."""

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
from test_runner import run_study
from volumebench.__main__ import main, write_views
from volumebench.study_file import find_study, load_study

PAGE = Path(__file__).resolve().parents[2] / "Documentation" / "first-study.md"


@pytest.fixture
def page():
    return PAGE.read_text(encoding="utf-8")


def test_the_page_shows_the_study_that_is_there(page):
    shown = re.search(r"```json\n(.*?)```", page, re.S).group(1)
    assert shown == find_study("tutorial").read_text(encoding="utf-8")


def test_it_has_as_many_runs_as_the_page_says(page):
    study = load_study(find_study("tutorial"))
    factors = (
        *(len(study.datasets), len(study.transfer_functions["ball"])),
        *(len(study.techniques), len(study.step_voxels)),
    )
    assert factors == (3, 2, 2, 3)
    assert len(study.runs()) == 36 and "= 36 runs" in page


def test_its_error_reads_as_the_page_says(page, tmp_path, capsys):
    document = json.loads(find_study("tutorial").read_text(encoding="utf-8"))
    document["techniques"] = ["slicing"]
    file = tmp_path / "tutorial.json"
    file.write_text(json.dumps(document))
    assert main([str(file)]) == 2
    message = capsys.readouterr().err.replace(f"{tmp_path}/", "")
    promised = re.search(r"error: tutorial.json.*?multi-pass, ", page).group(0)
    assert message.startswith(promised)


def test_its_report_can_be_written(tmp_path):
    study = load_study(find_study("tutorial"))
    small = [replace(item, dims=(8, 8, 8)) for item in study.datasets]
    study = replace(study, datasets=tuple(small))
    runner, _ = run_study(study, tmp_path)
    assert len(runner.records) == 36
    write_views(study, tmp_path, runner, runner.records)
    html = (tmp_path / "report.html").read_text()
    assert html.count("<h2>") > 6 and (tmp_path / "results.csv").is_file()
