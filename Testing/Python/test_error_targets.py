"""Error targets against numbers worked out by hand: what is kept, and what a fixed step takes."""

import pytest
from test_work_precision import OTHER, row
from volumebench.error_targets import kept_targets, target_table
from volumebench.results import Record
from volumebench.speed import best_match


def targeted(target: float, ms: float, rmse: float, **more) -> Record:
    return row("single-pass", ms, rmse, settings=(("error_target", target),), **more)


def fixed() -> list[Record]:
    """10 ms at 1e-1 to 1000 ms at 1e-3: 100 ms and 1000 samples at 1e-2."""
    return [
        row("single-pass", 10, 1e-1, step=2.0, samples=100),
        row("single-pass", 1000, 1e-3, step=0.5, samples=10_000),
    ]


def test_a_fixed_step_is_asked_for_the_error_that_came_of_the_target():
    (kept,) = kept_targets([*fixed(), targeted(2e-2, 50, 1e-2)])
    assert kept.share() == pytest.approx(0.5)
    assert kept.fixed.ms == pytest.approx(100)
    assert kept.fixed.samples == pytest.approx(1000)


def test_only_runs_that_differ_by_their_steps_are_compared():
    others = [
        row("single-pass", 1, 1e-1, step=2.0, integrator="Segment"),
        row("compute", 1, 1e-1, step=2.0),
        row("single-pass", 1, 1e-1, step=2.0, path="engine"),
        row("single-pass", 1, 1e-1, step=2.0, settings=(("jitter", 1),)),
        row("single-pass", 1, 1e-1, step=2.0, scene=OTHER),
    ]
    (kept,) = kept_targets([*others, *fixed(), targeted(2e-2, 50, 1e-2)])
    assert kept.fixed.ms == pytest.approx(100)


def test_no_fixed_step_is_named_beyond_those_that_were_measured():
    coarse, fine = kept_targets(
        [*fixed(), targeted(0.5, 5, 0.2), targeted(1e-4, 9000, 1e-5)]
    )
    assert coarse.fixed is None and fine.fixed is None


def test_the_table_marks_what_is_not_kept():
    table = target_table([*fixed(), targeted(2e-2, 50, 1e-2), targeted(5e-3, 50, 1e-2)])
    assert [line[5] for line in table.rows] == ["0.50", "2.00 (not kept)"]
    assert table.rows[0][7] == "100.0"
    assert target_table(fixed()) is None


def test_targets_are_points_of_one_curve():
    rows = [targeted(1e-1, 10, 1e-1), targeted(1e-3, 40, 1e-3)]
    assert best_match([*fixed(), *rows], 1e-2).ms == pytest.approx(20)
