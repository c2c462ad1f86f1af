"""Fronts, interpolation, speed-ups, orders and samples against numbers worked out by hand."""

import math
from dataclasses import replace

import pytest
from volumebench.error import ImageError
from volumebench.findings import sweep_findings
from volumebench.results import Record, record_of
from volumebench.statistics import spread
from volumebench.study import Run, Scene
from volumebench.work_precision import (
    Point,
    equal_errors,
    front_of,
    geometric_mean,
    is_doubtful,
    orders,
    points_of,
    sample_ratios,
    samples_verdict,
    sentence,
    time_at,
)
from volumebench.work_precision_tables import (
    doubt_sentence,
    order_table,
    sample_table,
    speed_up_table,
)

SCENE = Scene("waves", "fog", (64, 64))
OTHER = replace(SCENE, transfer_function="spikes")


def row(
    technique: str,
    ms: float,
    rmse: float | None,
    path: str = "view",
    step: float | None = 1.0,
    integrator: str | None = "Midpoint",
    samples: int | None = None,
    scene: Scene = SCENE,
    uncertainty: float | None = None,
    settings: tuple = (),
) -> Record:
    if technique in ("paraview-volume", "vtk-gpu"):
        step = integrator = None
    run = Run(
        *("sweep", scene, technique, integrator, step, "three-views", path, settings)
    )
    return record_of(
        run,
        (8, 8, 8),
        "uint16",
        frame_ms=spread([ms]),
        samples_taken=samples,
        error=ImageError(rmse=rmse, reference_uncertainty=uncertainty),
    )


def front(*pairs: tuple[float, float]) -> list[Point]:
    return [Point(ms, rmse, row("single-pass", ms, rmse)) for ms, rmse in pairs]


def test_front_keeps_what_nothing_beats():
    points = front((8, 1e-3), (1, 1e-1), (4, 1e-2), (5, 2e-2), (4, 5e-2), (9, 1e-3))
    kept = [(point.ms, point.rmse) for point in front_of(points)]
    assert kept == [(1, 1e-1), (4, 1e-2), (8, 1e-3)]


def test_time_is_interpolated_in_log_log():
    """From 10 ms at 1e-1 to 1000 ms at 1e-3: at 1e-2 it is 100 ms, not 505."""
    points = front((10, 1e-1), (1000, 1e-3))
    assert time_at(points, 1e-2) == pytest.approx(100)
    assert time_at(points, 1e-1) == 10 and time_at(points, 1e-3) == pytest.approx(1000)


def test_nothing_is_extrapolated():
    points = front((10, 1e-1), (1000, 1e-3))
    assert time_at(points, 2e-1) is None
    assert time_at(points, 9e-4) is None
    assert time_at([], 1e-2) is None
    assert time_at(points[:1], 1e-1) == 10, "one point is a front of its own error"
    assert time_at(points[:1], 1e-2) is None


def test_rows_without_time_or_error_are_no_points():
    failed = replace(row("single-pass", 1, 1e-2), status="failed")
    assert points_of([failed, row("single-pass", 1, None), row("compute", 1, 0)]) == []


def paraview_and_ours() -> list[Record]:
    return [
        row("paraview-volume", 80, 1e-2, samples=1000),
        row("single-pass", 10, 1e-1, step=2.0),
        row("single-pass", 40, 2.5e-3, step=1.0),
    ]


def test_speed_up_at_paraviews_own_error():
    """Ours at 1e-2: 10 ms * 4^(log 10 / log 40)."""
    (own,) = (
        item
        for item in equal_errors(paraview_and_ours(), "paraview-volume")
        if item.at_peers_error
    )
    ours = 10 * 4 ** (math.log(10) / math.log(40))
    assert own.ours_ms == pytest.approx(ours) and own.peer_ms == 80
    assert own.speed_up() == pytest.approx(80 / ours)
    assert not own.ours_is_bound


def test_paraview_has_one_point_and_is_not_extrapolated():
    table = speed_up_table(paraview_and_ours(), "paraview-volume")
    cells = dict(zip(table.header, table.rows[0]))
    assert cells["at 0.001"] == "not reached (ours)"
    assert cells["ParaView's error"] == "1.0e-02"


def test_our_fastest_run_stands_for_coarser_errors_but_not_the_peers():
    records = [
        row("single-pass", 10, 5e-3, path="engine"),
        row("vtk-gpu", 50, 1e-1, path="engine"),
        row("vtk-gpu", 200, 1e-3, path="engine"),
    ]
    at = {item.rmse: item for item in equal_errors(records, "vtk-gpu")}
    assert at[1e-2].ours_ms == 10 and at[1e-2].ours_is_bound
    assert at[1e-2].speed_up() == pytest.approx(100 / 10)
    assert at[1e-3].speed_up() is None
    peer_too_fine = [records[0], row("vtk-gpu", 50, 1e-3, path="engine")]
    assert equal_errors(peer_too_fine, "vtk-gpu")[0].speed_up() is None
    table = speed_up_table(records, "vtk-gpu")
    assert table.rows[0][1:3] == ("at least 10.0x", "not reached (ours)")


def test_paths_are_not_mixed():
    records = [*paraview_and_ours(), row("single-pass", 0.1, 1e-6, path="engine")]
    own = [item for item in equal_errors(records, "paraview-volume")][-1]
    assert own.ours_ms > 10


def test_sentence_tells_mean_and_range():
    other = [replace(item, transfer_function="spikes") for item in paraview_and_ours()]
    other[0] = row("paraview-volume", 320, 1e-2, scene=OTHER)
    text = sentence([*paraview_and_ours(), *other])
    first = 80 / (10 * 4 ** (math.log(10) / math.log(40)))
    assert f"{2 * first:.1f} times as fast as ParaView's Volume" in text
    assert f"over 2 scenes; {first:.1f} to {4 * first:.1f} times" in text
    assert text.count(".") == text.rstrip(".").count(".") + 1


def test_sentence_names_scenes_that_are_lacking():
    coarse = [
        row("paraview-volume", 80, 1e-4, scene=OTHER),
        row("single-pass", 1, 1e-1, scene=OTHER),
    ]
    assert "in 1 more its error was not reached" in sentence(
        [*paraview_and_ours(), *coarse]
    )
    assert sentence(coarse).startswith("No technique was measured")


def sweep(order: float, integrator: str, **given) -> list[Record]:
    return [
        row(
            *(
                "single-pass",
                10 / step,
                1e-2 * step**order,
                "engine",
                step,
                integrator,
            ),
            **given,
        )
        for step in (4.0, 1.0, 0.5, 0.25)
    ]


def test_order_is_the_slope_over_small_steps():
    records = sweep(2, "Midpoint") + sweep(1, "Left") + sweep(1.5, "Segment")
    records[0] = row("single-pass", 1, 0.2, "engine", 4.0)  # no trend beyond one voxel
    found = {item.integrator: item for item in orders(records)}
    assert found["Midpoint"].order == pytest.approx(2)
    assert found["Left"].order == pytest.approx(1)
    assert found["Segment"].order == pytest.approx(1.5)
    assert [name for name, item in found.items() if item.is_low()] == ["Segment"]
    rows = {cells[2]: cells for cells in order_table(records).rows}
    assert "stop early" in rows["Segment"][3] and rows["Midpoint"][3] == ""


def test_order_is_that_of_rays_that_never_stop():
    never = sweep(1.4, "Midpoint", settings=(("termination_threshold", 0),))
    (found,) = orders(sweep(0.1, "Midpoint") + never)
    assert found.order == pytest.approx(1.4) and not found.stopping
    assert "kinks" in order_table(never).rows[0][3]
    flat = sweep(0.2, "Segment", settings=(("termination_threshold", 0),))
    assert "hardly matters" in order_table(flat).rows[0][3]
    other = sweep(2, "Midpoint", settings=(("table_size", 64),))
    assert orders(other) == []


def test_each_technique_has_an_order_of_its_own():
    records = sweep(2, "Midpoint")
    for record in sweep(1, "Midpoint"):
        records.append(replace(record, technique="compute"))
    found = {item.technique: item.order for item in orders(records)}
    assert found == {"single-pass": pytest.approx(2), "compute": pytest.approx(1)}


def test_orders_need_errors_that_can_be_trusted():
    """Half of the errors are within 10 times the uncertainty: two points are no trend."""
    records = sweep(2, "Midpoint", uncertainty=2e-4)
    assert [is_doubtful(item) for item in records] == [False, False, False, True]
    assert orders(records) == [], "1 and 0.5 are left"
    assert "1 of 4 points are grey" in doubt_sentence(records)
    assert doubt_sentence(sweep(2, "Midpoint", uncertainty=1e-6)) is None


def test_samples_at_paraviews_error_are_measured_points():
    records = [
        row("paraview-volume", 80, 1e-2, samples=1000),
        row("single-pass", 10, 2e-2, "engine", 2.0, samples=100),
        row("single-pass", 10, 9e-3, "engine", 1.0, "Segment", samples=250),
        row("single-pass", 10, 8e-3, "engine", 1.0, samples=300),
        row("single-pass", 10, 1e-3, "engine", 1.0, "PreIntegrated", samples=10),
        row("compute", 10, 1e-3, "engine", 1.0, samples=10),
    ]
    (found,) = sample_ratios(records)
    assert found.ratio() == 0.25 and found.ours.integrator == "Segment"
    doubtful = replace(
        records[2], error=ImageError(rmse=9e-3, reference_uncertainty=2e-3)
    )
    (other,) = sample_ratios([*records[:2], doubtful, *records[3:]])
    assert other.ratio() == 0.3, "its error might exceed ParaView's"
    assert sample_table(records).rows[0][-1] == "0.25"


def test_verdict_holds_every_scene_against_the_bar():
    def ratios(*samples: int | None):
        records = []
        for index, count in enumerate(samples):
            scene = replace(SCENE, transfer_function=f"f{index}")
            records.append(row("paraview-volume", 80, 1e-2, samples=1000, scene=scene))
            if count:
                ours = row(
                    "single-pass", 10, 5e-3, "engine", samples=count, scene=scene
                )
                records.append(ours)
        return sample_ratios(records)

    assert "0.22" in samples_verdict(ratios(500, 100))
    assert samples_verdict(ratios(500, 100)).endswith("in the mean is met.")
    assert samples_verdict(ratios(501, 100)).endswith("not met.")
    assert samples_verdict(ratios(400, 400)).endswith("not met.")
    assert samples_verdict(ratios(100, None)).endswith("not met.")
    assert "No run of ours" in samples_verdict(ratios(None))
    assert samples_verdict([]) is None


def test_geometric_mean():
    assert geometric_mean([1, 100]) == pytest.approx(10)


def test_text_has_the_sentence_first():
    text = sweep_findings(paraview_and_ours()).text()
    assert text.startswith("At equal error")
    assert "Samples at ParaView's own error" in text
