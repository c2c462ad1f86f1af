"""The report of a paper's study in a browser: no fault, every picture, nothing over the edge."""

from types import SimpleNamespace

import numpy as np
import pytest
from browser import CHROMIUM, screenshot, watched
from matplotlib.image import imread
from test_paper import made_up_rows
from volumebench.__main__ import write_views
from volumebench.gallery import write_gallery
from volumebench.kept_pictures import Pictures
from volumebench.results import Context
from volumebench.study_file import find_study, load_study

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    """The report of misaki-2017's quick cut, with made-up rows and pictures."""
    folder = tmp_path_factory.mktemp("report")
    study = load_study(find_study("misaki-2017")).quick()
    rows = made_up_rows(study)
    truth = np.zeros((8, 8, 4), np.float32)
    runs = [row.run() for row in rows if row.frame_log]
    for scene in dict.fromkeys(run.scene for run in runs):
        inside = [run for run in runs if run.scene == scene]
        drawn = {run.technique: (run, truth + 0.1) for run in inside}
        pictures = Pictures([truth], by_technique=drawn)
        write_gallery(folder, scene, pictures, rows)
    runner = SimpleNamespace(start_rows=[], context=Context(cores=2), notes=[])
    write_views(study, folder, runner, rows)
    return folder / "report.html"


def test_it_opens_without_a_fault(report, tmp_path):
    seen = watched(report, tmp_path)
    assert seen["errors"] == [] and seen["requests"] == []
    assert seen["images"] > 12 and seen["broken"] == []
    assert seen["wide"] <= 0, "tables scroll within the page"


def test_its_conclusions_come_first_and_its_kernels_are_told(report):
    html = report.read_text()
    verdicts = html.index('<span class="mark')
    assert html.index('<p class="lead">') < verdicts < html.index('<img class="plot"')
    assert "the peer's" not in html.partition("How to read this")[0]
    assert "nan" not in html.partition("<script>")[0].replace("Nanometre", "").split()


def test_its_picture_has_text_and_figures(report, tmp_path):
    pixels = imread(screenshot(report, tmp_path))[:, :, :3]
    assert pixels.shape[0] == 2000 and np.ptp(pixels) > 0.8
    painted = (pixels < 0.5).any(axis=(1, 2))
    halves = painted[:1000].mean(), painted[1000:].mean()
    assert min(halves) > 0.2, "neither half is blank"
