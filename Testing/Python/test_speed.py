"""Ratios at equal error against numbers worked out by hand: variants, bounds, intervals, skipping."""

import math
from dataclasses import replace

import pytest
from test_work_precision import OTHER, SCENE, row
from volumebench.findings import findings_of
from volumebench.results import Record
from volumebench.speed import (
    best_match,
    match_at,
    median_half_width,
    ratios,
    savings,
    sentence,
)
from volumebench.speed_tables import left_out_remarks, ratio_tables, saving_table
from volumebench.statistics import Spread
from volumebench.study import SPEED
from volumebench.work_precision import points_of

OFF = (("skipping", False),)


def midpoint() -> list[Record]:
    """10 ms at 1e-1 to 1000 ms at 1e-3: 100 ms at 1e-2."""
    return [
        row("single-pass", 10, 1e-1, step=2.0, samples=100),
        row("single-pass", 1000, 1e-3, step=0.5, samples=10_000),
    ]


def segment() -> list[Record]:
    """20 ms at 1e-1 to 80 ms at 1e-3: 40 ms at 1e-2, the faster of the two there."""
    rows = [(20, 1e-1, 2.0, 200), (80, 1e-3, 0.5, 800)]
    return [
        row("single-pass", ms, rmse, step=step, integrator="Segment", samples=samples)
        for ms, rmse, step, samples in rows
    ]


def paraview(ms=120.0, rmse=1e-2, **more) -> Record:
    return row("paraview-volume", ms, rmse, samples=4000, **more)


def test_each_variant_has_a_curve_of_its_own():
    """A front over all would go straight from 10 ms to 80 ms: 28 ms at 1e-2, which none takes."""
    match = best_match([*midpoint(), *segment()], 1e-2)
    assert match.ms == pytest.approx(40)
    assert match.samples == pytest.approx(400)
    assert match.record.integrator == "Segment" and not match.is_bound
    assert match.variant() == "Single Pass, Segment, step 0.5"


def test_the_ratio_is_paraviews_time_over_ours():
    (own,) = ratios([paraview(), *midpoint(), *segment()])
    assert own.rmse == 1e-2 and own.factor() == pytest.approx(3)
    (level,) = ratios([paraview(), *midpoint(), *segment()], 1e-3)
    assert level.rmse == 1e-3 and level.factor() == pytest.approx(120 / 80)


def test_the_level_never_lets_us_be_less_accurate_than_paraview():
    (item,) = ratios([paraview(rmse=1e-4), *segment()], 1e-3)
    assert item.rmse == 1e-4
    assert item.ours is None and item.factor() is None and item.interval() is None


def test_a_run_that_is_more_accurate_is_a_bound():
    (item,) = ratios([paraview(rmse=0.5), *segment()])
    assert item.ours.is_bound and item.factor() == pytest.approx(120 / 20)
    cells = dict(
        zip(
            (table := ratio_tables([paraview(rmse=0.5), *segment()])[0]).header,
            table.rows[0],
        )
    )
    assert cells["ratio"] == "at least 6.0"
    assert cells["our variant"].endswith("or finer")


def test_the_view_path_alone_counts():
    engine = [replace(item, path="engine") for item in segment()]
    (item,) = ratios([paraview(), *midpoint(), *engine])
    assert item.factor() == pytest.approx(120 / 100)


def test_runs_that_skip_nothing_are_controls():
    off = [row("single-pass", 1, 1e-2, integrator="Segment", settings=OFF)]
    (item,) = ratios([paraview(), *segment(), *off])
    assert item.factor() == pytest.approx(3)


def test_half_width_of_a_median():
    """1.57 * 2 / (10 * sqrt(16))."""
    times = Spread(10.0, 9.0, 11.0, 8.0, 12.0)
    assert median_half_width(times, 16) == pytest.approx(0.0785)
    assert median_half_width(Spread(10.0), 16) == 0.0
    assert median_half_width(times, None) == 0.0


def test_the_interval_joins_both_times_and_follows_the_share():
    """At 1e-2 we are half way: half of 0.157 and half of 0.0785; ParaView's is 0.0785."""
    quartiles = Spread(1.0, 0.9, 1.1, 0.8, 1.2)

    def noisy(record: Record, frames: int) -> Record:
        median = record.frame_ms.median
        scaled = Spread(*(median * value for value in vars(quartiles).values()))
        return replace(record, frame_ms=scaled, frames=frames)

    coarse, fine = segment()
    rows = [noisy(paraview(), 16), noisy(coarse, 4), noisy(fine, 16)]
    (item,) = ratios(rows)
    assert item.ours.half_width == pytest.approx((0.157 + 0.0785) / 2)
    width = math.exp(math.hypot(0.0785, item.ours.half_width))
    assert item.interval() == pytest.approx((3 / width, 3 * width))


def test_nothing_is_extrapolated_to_finer_errors():
    assert match_at(points_of(segment()), 9e-4) is None
    assert match_at([], 1e-2) is None


def test_the_sentence_tells_mean_range_and_stand_ins():
    other = [replace(item, transfer_function="spikes") for item in segment()]
    theirs = replace(paraview(480, scene=OTHER), stand_in_for="ct_head")
    text = sentence([paraview(), *segment(), theirs, *other])
    assert text.startswith(
        "At ParaView's own error, VolumeBench draws still pictures 6.0 (geometric mean; 3.0 to "
        "12.0) times as fast as ParaView's Volume in the same view (2 scenes, 64 x 64)"
    )
    assert "at an RMSE of 0.001" in text and "3.0 (geometric mean; 1.5 to 6.0)" in text
    assert "generated stand-ins in 1 of 2" in text


def test_the_sentence_says_where_the_error_was_not_reached():
    other = [paraview(scene=OTHER, rmse=1e-6), row("single-pass", 9, 1e-2, scene=OTHER)]
    text = sentence([paraview(), *segment(), *other])
    assert "(1 of 2 scenes, 64 x 64)" in text
    assert "No run of ours" in sentence([paraview(rmse=1e-9), *segment()])
    assert "No run of ours" in sentence([])


def test_a_saving_is_a_pair_that_differs_in_skipping_alone():
    on = row("single-pass", 10, 1e-2, samples=100)
    off = row("single-pass", 45, 1e-2, samples=900, settings=OFF)
    others = [
        row("single-pass", 1, 1e-2, step=2.0),
        row("compute", 2, 1e-2),
        row("single-pass", 3, 1e-2, path="engine"),
        row("single-pass", 4, 1e-2, settings=(("termination_threshold", 0.0),)),
    ]
    (pair,) = savings([on, off, *others])
    assert pair.skipping == on and pair.factor() == pytest.approx(4.5)
    assert saving_table([on, off]).rows[0][-1] == "4.50x"
    assert saving_table(others) is None


def test_tables_tell_stand_ins():
    theirs = replace(paraview(), stand_in_for="ct_head")
    table = ratio_tables([theirs, *segment()])[0]
    cells = dict(zip(table.header, table.rows[0]))
    assert cells["scene"].endswith("(stand-in)")
    assert (cells["ParaView's Msamples"], cells["our ms"]) == ("0.00", "40.0")


def test_what_is_left_out_is_told_once():
    rows = [replace(item, left_out=("lighting", "clipping")) for item in segment()]
    other = [replace(item, transfer_function="spikes") for item in rows]
    (text,) = left_out_remarks([paraview(), *rows, paraview(scene=OTHER), *other])
    assert "lighting, clipping (waves, fog; waves, spikes)" in text
    assert left_out_remarks([paraview(), *segment()]) == []


def test_the_findings_have_a_figure_with_bars(tmp_path, study):
    unreached = [paraview(scene=OTHER, rmse=1e-6), row("compute", 9, 1e-2, scene=OTHER)]
    speed = replace(study, report=SPEED)
    found = findings_of(speed, [paraview(), *segment(), *unreached], [], tmp_path)
    assert found.figures == (
        ("speed.png", "Frame-time ratio against ParaView's Volume"),
    )
    assert (tmp_path / "plots" / "speed.png").read_bytes().startswith(b"\x89PNG")
    assert found.text().startswith("At ParaView's own error")
    assert "not reached" in found.text()
    assert findings_of(speed, [], [], tmp_path).figures == ()
