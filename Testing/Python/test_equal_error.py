"""Techniques beside single pass at equal error, against numbers worked out by hand."""

from dataclasses import replace

import pytest
from test_work_precision import OTHER, SCENE, row
from volumebench.equal_error import equal_error_table, pairs, sentence
from volumebench.findings import findings_of
from volumebench.statistics import Spread
from volumebench.study import EQUAL_ERROR


def curve(technique, runs, **more):
    """Rows of a technique: milliseconds and RMSE of each, at halved steps."""
    return [
        row(technique, ms, rmse, step=4 / 2**i, **more)
        for i, (ms, rmse) in enumerate(runs)
    ]


def single():
    """100 ms at 1e-2, 1000 ms at 1e-3, straight between."""
    return curve("single-pass", [(10, 1e-1), (1000, 1e-3), (10_000, 1e-4)])


def test_times_are_read_at_the_errors_that_both_reach():
    other = curve("opencl", [(10, 1e-1), (20, 1e-2), (500, 1e-3)])
    found = {pair.rmse: pair for pair in pairs([*single(), *other])}
    assert set(found) == {1e-2, 3e-3, 1e-3}  # the other ends there
    assert found[1e-2].factor() == pytest.approx(5)
    assert found[1e-3].factor() == pytest.approx(2)
    assert not any(pair.other.is_bound for pair in found.values())


def test_what_single_pass_was_not_measured_beyond_is_left_out():
    """Its fastest run is more accurate than 1e-2: what a coarser one would take is not known."""
    base = curve("single-pass", [(10, 2e-3), (100, 1e-4)])
    found = pairs([*base, *curve("opencl", [(1, 1e-1), (50, 1e-4)])])
    assert {pair.rmse for pair in found} == {1e-3, 3e-4, 1e-4}


def test_a_technique_that_is_more_accurate_at_once_is_at_least_so_fast():
    base = curve("single-pass", [(10, 1e-1), (1000, 1e-3)])
    found = pairs([*base, *curve("opencl", [(5, 2e-3), (50, 1e-3)])])
    first = found[0]
    assert first.rmse == 1e-2 and first.other.is_bound
    assert first.factor() == pytest.approx(20)
    table = equal_error_table([*base, *curve("opencl", [(5, 2e-3), (50, 1e-3)])])
    assert [cells[7] for cells in table.rows][0] == "at least 20.00x"
    slow, *_ = pairs([*base, *curve("opencl", [(500, 2e-3)])])
    assert slow.factor() < 1 and slow.is_faster() is None  # at least so fast, maybe faster


def test_scenes_and_paths_are_kept_apart():
    other = curve("opencl", [(10, 1e-1), (20, 1e-2)], scene=OTHER)
    assert pairs([*single(), *other]) == []
    here = curve("opencl", [(10, 1e-1), (20, 1e-2)], scene=SCENE)
    assert len(pairs([*single(), *here])) == 1
    assert pairs([*single(), *[replace(item, path="engine") for item in here]]) == []


def test_the_interval_decides():
    def noisy(rows, spread):
        return [
            replace(
                item,
                frames=9,
                frame_ms=Spread(
                    median=item.frame_ms.median,
                    q1=item.frame_ms.median * (1 - spread),
                    q3=item.frame_ms.median * (1 + spread),
                ),
            )
            for item in rows
        ]

    other = curve("opencl", [(10, 1e-1), (80, 1e-2)])
    (calm,) = pairs([*noisy(single(), 0.01), *noisy(other, 0.01)])
    assert calm.factor() == pytest.approx(1.25) and calm.is_faster() is True
    (busy,) = pairs([*noisy(single(), 0.5), *noisy(other, 0.5)])
    assert busy.is_faster() is None
    slow = curve("opencl", [(50, 1e-1), (200, 1e-2)])
    (lost,) = pairs([*noisy(single(), 0.01), *noisy(slow, 0.01)])
    assert lost.is_faster() is False


def test_the_sentence_counts_what_is_faster():
    rows = [*single(), *curve("opencl", [(10, 1e-1), (20, 1e-2), (2000, 1e-3)])]
    text = sentence(rows)
    assert "OpenCL has" in text and "frame rate of Single Pass" in text
    assert "3 errors in 1 scene;" in text and "0.50 times to 5.00 times" not in text
    assert "0.50 to 5.00 times" in text
    assert "slower at 1," in text
    assert sentence(single()).startswith("No technique reached")


def test_a_study_of_that_kind_opens_with_it(study, tmp_path):
    rows = [*single(), *curve("opencl", [(10, 1e-1), (20, 1e-2)])]
    study = replace(study, report=EQUAL_ERROR)
    findings = findings_of(study, rows, [], tmp_path)
    assert findings.sentence == sentence(rows)
    assert findings.tables[0] == equal_error_table(rows)
