"""Conclusions of papers on made-up rows whose truth is known, and the five studies themselves."""

import json
import zlib
from dataclasses import replace

import numpy as np
import pytest
from test_compare import noisy_log
from volumebench.__main__ import main
from volumebench.error import ImageError
from volumebench.errors import StudyError
from volumebench.paper import fastest, matches, verdict_of
from volumebench.paper_panels import curves_of, edge_of, fps_of_frames
from volumebench.paper_panels import places_of_crossing
from volumebench.paper_plot import spread_over_volumes
from volumebench.paper_tables import paper_sentence, published_tables
from volumebench.paper import Verdict, verdicts
from volumebench.results import FrameLog, record_of, times
from volumebench.study import Run, Scene
from volumebench.study_file import find_study, load_study
from volumebench.findings import findings_of, write_tables

PAPERS = ("nikolov-2015", "sans-2016", "misaki-2017", "volt", "maas-2015")
STEPS = (1.0, 2.0, 4.0, 8.0)


def made_up(technique, step, ms, rmse=None, noise=0.02, status="ok", **scene):
    settings = scene.pop("settings", {})
    place = Scene(scene.pop("dataset", "ball"), "tf", (64, 64), **scene)
    run = Run("s", place, technique, "Midpoint", step, "orbit-y", "engine")
    seed = zlib.crc32(repr((technique, step, ms, scene, settings)).encode())
    values = times(noisy_log(ms, seed, noise=noise)) if status == "ok" else {}
    error = ImageError(rmse=rmse, reference_uncertainty=1e-6)
    row = record_of(run, (8, 8, 8), "uint8", status=status, error=error, **values)
    return replace(row, settings=settings)


def curves(noise=0.02):
    """Single pass takes 32 / step, multi pass 4 + 16 / step: they cross at a step of 4."""
    rows = [made_up("single-pass", step, 32 / step, noise=noise) for step in STEPS]
    return rows + [
        made_up("multi-pass", step, 4 + 16 / step, noise=noise) for step in STEPS
    ]


def judged(rows, **conclusion):
    default = {"text": "t", "published": "p", "kind": "ratio"}
    default |= {"over": {"technique": "multi-pass"}}
    default |= {"under": {"technique": "single-pass"}}
    return verdict_of(default | conclusion, rows)


@pytest.mark.parametrize(
    "bounds, word",
    [
        ({"at_least": 0.9}, "does not hold"),
        ({"at_most": 0.9}, "holds"),
        ({"at_least": 0.5, "at_most": 0.7}, "holds"),
        ({"at_least": 0.8, "at_most": 0.9}, "does not hold"),
    ],
)
def test_a_ratio_is_held_against_its_bounds(bounds, word):
    """At step 1 multi pass takes 20 against 32: 0.625."""
    found = judged(curves(), where={"step_voxels": 1}, **bounds)
    assert found.word == word and found.measured.startswith("0.6")


def test_noise_leaves_a_ratio_undecided():
    found = judged(curves(noise=1.5), where={"step_voxels": 2}, at_least=0.75)
    assert found.word == "undecided"


def test_what_must_hold_of_each_pair_is_not_saved_by_the_mean():
    assert judged(curves(), at_most=1.05).word == "holds", "of the mean"
    assert judged(curves(), at_most=1.05, each=True).word == "does not hold"


def test_of_several_variants_the_fastest_counts():
    slow, fast = (
        made_up("multi-pass", 1.0, ms, settings={"work_group_shape": shape})
        for shape, ms in (("4x4", 40), ("8x8", 16))
    )
    for order in ((slow, fast), (fast, slow)):
        found = judged([*order, made_up("single-pass", 1.0, 32)], at_most=0.6)
        assert found.word == "holds" and "1 pair" in found.measured


def test_a_change_is_that_of_the_ratio():
    """From 1.5 at step 8 to 0.625 at step 1."""
    ends = {"from": {"step_voxels": 8}, "to": {"step_voxels": 1}}
    found = judged(curves(), kind="change", at_most=1, **ends)
    _, before, _, after, *_ = found.measured.replace(":", "").split()
    assert float(before) == pytest.approx(1.5, rel=0.05)
    assert float(after) == pytest.approx(0.625, rel=0.05)
    assert found.word == "holds"
    assert judged(curves(), kind="change", at_least=1, **ends).word == "does not hold"


def test_a_crossover_is_found_between_steps():
    found = judged(curves(), kind="crossover", at_least=3.0, at_most=5.5)
    assert found.word == "holds", found.measured
    far = judged(curves(), kind="crossover", at_least=0.5, at_most=1.5)
    assert far.word == "does not hold"
    apart = [row for row in curves() if row.step_voxels < 4]
    assert judged(apart, kind="crossover", at_least=1, at_most=8).word != "holds"


def test_a_crossover_the_other_way_round_is_none():
    """Multi pass is faster below a step of 4: that single pass were so is wrong."""
    ends = {"over": {"technique": "single-pass"}, "under": {"technique": "multi-pass"}}
    found = judged(curves(), kind="crossover", at_least=3.0, at_most=5.5, **ends)
    assert found.word == "does not hold", found.measured


def test_a_difference_is_in_milliseconds():
    rows = [made_up("multi-pass", 1.0, 11.0), made_up("single-pass", 1.0, 10.0)]
    assert judged(rows, kind="difference", at_most=5).word == "holds"
    assert judged(rows, kind="difference", at_most=0.5).word == "does not hold"


def test_errors_are_compared_with_the_uncertainty_of_references():
    rows = [made_up("multi-pass", 1.0, 9, 0.02), made_up("single-pass", 1.0, 10, 0.01)]
    assert judged(rows, measure="error", at_least=1.5).word == "holds"
    assert judged(rows, measure="error", at_most=1).word == "does not hold"
    vague = ImageError(rmse=0.02, reference_uncertainty=0.015)
    assert (
        judged(
            [replace(rows[0], error=vague), rows[1]], measure="error", at_least=1
        ).word
        == "undecided"
    )


def test_pairs_of_too_few_frames_do_not_hide_the_others():
    """Their noise is not known: they are told, and leave the mean to the others."""
    short = made_up("multi-pass", 2.0, 1.0)
    log = FrameLog([0, 1], [1.0, 1.0], [None, None])
    short = replace(short, **times(log))
    rows = [row for row in curves() if row.step_voxels == 1]
    rows += [short, made_up("single-pass", 2.0, 16)]
    found = judged(rows, at_least=0.5, at_most=0.7)
    assert found.word == "holds" and "1 more with too few frames" in found.measured
    assert judged(rows, at_least=0.01, at_most=0.7, each=True).word == "undecided"
    assert judged(rows[2:], at_most=0.7).word == "undecided"


def test_what_was_not_run_says_why():
    rows = [
        *curves(),
        replace(made_up("cuda", 1.0, 1, status="unsupported"), reason="no GPU"),
    ]
    found = judged(rows, over={"technique": "cuda"}, at_least=1)
    assert (found.word, found.measured) == ("not run", "no GPU")
    text = {
        "text": "t",
        "published": "p",
        "kind": "unmeasured",
        "reason": "no profiler",
    }
    assert verdict_of(text, rows).word == "not run"


def test_rows_are_picked_by_stand_in_and_settings():
    row = made_up("compute", 1.0, 5, settings={"work_group_shape": "8x8"})
    row = replace(row, stand_in_for="knee")
    assert matches(row, {"dataset": "knee"}) and matches(row, {"dataset": "ball"})
    assert matches(row, {"settings": {"work_group_shape": "8x8"}})
    assert not matches(row, {"settings": {"work_group_shape": "4x4"}})
    quicker = made_up("compute", 1.0, 3, settings={"work_group_shape": "4x4"})
    assert fastest([row, quicker], {"technique": "compute"}) == quicker
    assert fastest([row], {"image_size": [1, 1]}) is None


def test_rates_of_frames_are_by_median():
    log = FrameLog([4, 0, 4, 4], [10.0, 20.0, 1000.0, 10.0], [None] * 4)
    assert fps_of_frames(log) == ([0, 4], [50.0, 100.0])


@pytest.fixture(params=PAPERS)
def paper_study(request):
    return load_study(find_study(request.param))


def made_up_rows(study):
    """All runs of a study; of what needs a device there is none."""
    rows = []
    for place, run in enumerate(study.runs()):
        if run.technique in ("cuda", "opencl"):
            row = record_of(run, None, None, status="unsupported", reason="no device")
        else:
            log = noisy_log(5 + place % 7, place, frames=study.camera.frames, rounds=1)
            error = ImageError(rmse=0.01 + place / 1000, reference_uncertainty=1e-6)
            row = record_of(run, (8, 8, 8), "uint8", error=error, **times(log))
        rows.append(row)
    return rows


def test_each_study_of_a_paper_reports(paper_study, tmp_path, monkeypatch):
    monkeypatch.setattr("volumebench.paper_plot.MOST_PANELS", 1)  # saves time
    study = paper_study.quick()
    rows = made_up_rows(study)
    found = verdicts(study.paper, rows)
    assert len(found) == len(study.paper["conclusions"]) >= 8
    assert {verdict.word for verdict in found} <= {
        *("holds", "does not hold", "undecided", "not run"),
    }
    (tmp_path / "plots").mkdir()
    findings = findings_of(study, rows, [], tmp_path)
    assert findings.sentence.startswith(f"Of {len(found)} conclusions of")
    write_tables(tmp_path, findings)
    text = (tmp_path / "tables" / "conclusions.csv").read_text()
    assert text.count("\n") > len(found)
    kinds = {name.split("-")[1].split(".")[0] for name, _ in findings.figures}
    assert kinds == set(study.paper["figures"])
    assert all((tmp_path / "plots" / name).is_file() for name, _ in findings.figures)


def test_quick_keeps_the_extremes_of_every_factor(paper_study):
    """Volumes and pictures may be smaller: a quick cut must end within minutes."""
    quick = paper_study.quick()

    def values(study, get):
        return {get(run) for run in study.runs()}

    for get in (
        lambda run: run.technique,
        lambda run: run.scene.blend_mode,
        lambda run: run.scene.lighting,
        lambda run: dict(run.settings).get("ray_set_up"),
        lambda run: dict(run.settings).get("voxel_order"),
    ):
        assert values(quick, get) == values(paper_study, get)
    for name in ("slice_threads", "termination_threshold"):
        full = values(paper_study, lambda run: dict(run.settings).get(name, 0))
        cut = values(quick, lambda run: dict(run.settings).get(name, 0))
        assert (min(cut), max(cut)) == (min(full), max(full))
    full, cut = (
        values(item, lambda run: run.step_voxels) for item in (paper_study, quick)
    )
    assert (min(cut), max(cut)) == (min(full), max(full))


def test_published_values_stand_beside_ours_and_their_errors(paper_study):
    for table in published_tables(paper_study.paper, made_up_rows(paper_study)):
        assert all(len(row) == len(table.header) for row in table.rows)
        assert sum(count for _, count in table.groups) == len(table.header)
        ours, errors = (
            [cell for row in table.rows for cell in row[first::3]] for first in (2, 3)
        )
        assert "left out" not in ours
        assert "not run" not in ours or paper_study.name != "maas-2015"
        assert [cell == "-" for cell in errors] == [cell == "not run" for cell in ours]


def test_a_quick_cut_tells_what_it_leaves_out_of_a_table():
    study = load_study(find_study("maas-2015")).quick()
    table = published_tables(study.paper, made_up_rows(study))[0]
    found = {row[0]: row[2] for row in table.rows}
    assert found["step 0.002"] == "left out" and float(found["step 0.001"]) > 0


def test_smaller_pictures_of_a_quick_cut_answer_for_those_of_the_paper():
    """A title such as "GLSL 1920" is the paper's; the note tells the size that is drawn."""
    full = load_study(find_study("nikolov-2015"))
    quick = full.quick()
    assert quick.image_sizes != full.image_sizes
    assert "in place of 500 x 500, 1920 x 1200" in quick.notes[-1]
    rows = made_up_rows(quick)
    for table in published_tables(quick.paper, rows)[:2]:
        cells = {cell for row in table.rows for cell in row[2::3]}
        assert "left out" not in cells
    large = [row for row in rows if row.image_size == quick.image_sizes[1]]
    (row, *_) = published_tables(quick.paper, large)[0].rows
    assert row[2] == "left out" and float(row[5]) > 0


def test_figures_show_scenes_of_every_volume():
    scenes = [Scene(volume, f"tf{i}", (8, 8)) for volume in "abc" for i in range(4)]
    shown = spread_over_volumes(scenes, 5)
    assert [scene.dataset for scene in shown] == ["a", "a", "b", "b", "c"]
    assert shown == [scene for scene in scenes if scene in shown]
    assert spread_over_volumes(scenes, 99) == scenes


def test_curves_that_cross_are_marked_where_they_do():
    """Without termination they cross at a step of 4; with it they do not."""
    off = [replace(row, settings={"termination_threshold": 0}) for row in curves(0)]
    on = [replace(row, settings={"termination_threshold": 0.1}) for row in curves(0)]
    on = [row for row in on if row.step_voxels < 4]
    (place,) = places_of_crossing(curves_of(off + on))
    at_4 = next(row.frame_ms.median for row in off if row.step_voxels == 4)
    assert place == pytest.approx((4, at_4), rel=0.02)


def test_a_frame_that_took_far_longer_does_not_stretch_the_axis():
    usual = [10.0, 11.0, 12.0, 13.0]
    assert edge_of([usual, [5.0]]) == pytest.approx(1.05 * 13), "all are seen"
    assert edge_of([[*usual, 9000.0]]) < 50


def test_sentence_counts_in_words():
    paper = {"title": "T", "hardware": "H"}
    words = ["holds", "does not hold", "not run", "not run"]
    found = [Verdict("", "", "", word) for word in words]
    assert paper_sentence(paper, found) == (
        "Of 4 conclusions of T (H), tested on this machine: 1 holds, 1 does not hold, "
        "2 were not run."
    )


@pytest.mark.parametrize(
    "change, expected",
    [
        ({"kind": "ratio", "over": {"technique": "compute"}}, '"under"'),
        ({"at_least": None}, 'needs "at_least" or "at_most"'),
        ({"under": {"technique": "slices"}}, "no run of the study is technique slices"),
        ({"where": {"datset": "x"}}, "datset"),
        ({"kind": "guess"}, "ratio, change"),
    ],
)
def test_faults_of_a_paper_are_named(study_file, write_json, change, expected):
    conclusion = {
        "text": "t",
        "published": "p",
        "kind": "ratio",
        "over": {"step_voxels": 1},
        "under": {"step_voxels": 2},
        "at_least": 1,
    }
    if "over" in change and "under" not in change:
        del conclusion["under"]
    conclusion |= change
    conclusion = {key: value for key, value in conclusion.items() if value is not None}
    document = json.loads(study_file.read_text())
    document["paper"] = {"title": "T", "hardware": "H", "conclusions": [conclusion]}
    path = write_json(document, "faulty.json")
    with pytest.raises(StudyError) as fault:
        load_study(path)
    assert expected in str(fault.value) and "conclusions[0]" in str(fault.value)


def test_a_table_needs_a_value_for_each_column(study_file, write_json):
    document = json.loads(study_file.read_text())
    select = {"technique": "single-pass"}
    table = {
        "title": "T",
        "unit": "ms",
        "columns": [{"title": "a", "select": select}],
        "rows": [{"title": "r", "select": {}, "published": [1, 2]}],
    }
    conclusion = {"text": "t", "published": "p", "kind": "unmeasured", "reason": "r"}
    document["paper"] = {
        "title": "T",
        "hardware": "H",
        "tables": [table],
        "conclusions": [conclusion],
    }
    with pytest.raises(StudyError, match="2 values for 1 columns"):
        load_study(write_json(document, "faulty.json"))
