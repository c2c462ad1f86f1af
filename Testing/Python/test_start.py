"""First pictures and edits: turns, what is timed, faults, the file, and the tables made of it."""

import io
from dataclasses import replace

import pytest
from fakes import FakeSession, FakeStage
from volumebench.progress import Progress
from volumebench.results import SetUpTimes
from volumebench.runner import Runner, find_inputs, prepare_folder
from volumebench.speed_tables import edit_table, first_table, start_remarks
from volumebench.start import (
    StartRow,
    edited,
    measure_start,
    read_start,
    write_start,
)
from volumebench.statistics import spread
from volumebench.study import Dataset, Start, Timing
from volumebench.transfer_functions import TransferFunction

FUNCTION = TransferFunction(
    "ramp", "", "value", ((0, 0), (1, 0.5)), ((0, 0, 0, 0), (1, 1, 1, 1)), 1.0
)


class Stages:
    """Opens stages and keeps them."""

    def __init__(self, broken=None) -> None:
        self.opened: list[FakeStage] = []
        self.broken = broken

    def __call__(self) -> FakeStage:
        self.opened.append(FakeStage(broken=self.broken))
        return self.opened[-1]


@pytest.fixture
def starting(study):
    techniques = ("single-pass", "multi-pass", "paraview-volume")
    small = Dataset("shell", (4, 4, 4), share=0.5)
    start = Start((small,), "ramp", techniques, (40, 30), 0.5, 3, 4)
    return replace(study, start=start)


def measured(study, stages):
    found = measure_start(stages, FUNCTION, study, lambda share: None)
    return {values["technique"]: values for values in found}


def test_each_repeat_has_a_new_view_and_an_order_of_its_own(starting):
    stages = Stages()
    measured(starting, stages)
    assert len(stages.opened) == 9 and all(stage.closed for stage in stages.opened)
    shown = [stage.shown[0].technique for stage in stages.opened]
    turns = [tuple(shown[place : place + 3]) for place in (0, 3, 6)]
    assert all(len(set(turn)) == 3 for turn in turns) and len(set(turns)) > 1
    assert all(len(stage.shown) == 1 for stage in stages.opened)


def test_a_repeat_draws_first_still_and_edited_pictures(starting):
    """1 + 3 + 4 pictures, of which those after edits alternate between two functions."""
    stages = Stages()
    found = measured(starting, stages)
    for stage in stages.opened:
        assert len(stage.rendered) == 8
        assert stage.functions == [edited(FUNCTION), FUNCTION] * 2
        assert len({position for _, position, _ in stage.rendered}) == 1
        assert not any(interactive for _, _, interactive in stage.rendered)
    ours, theirs = found["single-pass"], found["paraview-volume"]
    assert ours["setup_ms"].upload == 3.0 and ours["bytes_on_device"] == 4096
    assert theirs["setup_ms"].upload is None and theirs["bytes_on_device"] is None
    assert ours["first_ms"].min > ours["show_ms"].min > 0


def test_the_first_picture_includes_the_display(starting, monkeypatch):
    """With a clock that moves by 1 s at each look, every piece of work takes 1000 ms."""
    ticks = iter(range(10**6))
    monkeypatch.setattr("volumebench.start.time.perf_counter", lambda: next(ticks))
    found = measured(starting, Stages())["single-pass"]
    medians = [found[name].median for name in ("show_ms", "first_ms", "still_ms")]
    assert medians == [1000, 2000, 1000]
    assert found["edit_ms"].median == 2000, "giving the function is part of an edit"


def run_with_start(study, folder, resume=False):
    """Measure a study with a start and return its session and its rows in the file."""
    earlier = prepare_folder(study, folder, resume)
    inputs = find_inputs(study, None, folder / "volumes")
    runner = Runner(study, inputs, folder, earlier)
    session = FakeSession(study)
    assert runner.is_complete() == resume
    runner.measure(session, Progress(1, io.StringIO()))
    return session, read_start(folder)


def test_a_start_is_measured_once_and_kept_on_resume(starting, tmp_path):
    study = replace(starting, timing=Timing(1, 4, 1.0, 60.0), paths=("view",))
    session, rows = run_with_start(study, tmp_path)
    assert session.starts == 1 and len(rows) == 3
    again, kept = run_with_start(study, tmp_path, resume=True)
    assert again.starts == 0 and kept == rows


def test_a_new_run_forgets_the_start_of_an_earlier_one(starting, tmp_path):
    write_start(tmp_path, starting.start, rows())
    prepare_folder(replace(starting, start=None), tmp_path, resume=False)
    assert read_start(tmp_path) == []


def test_ours_take_the_step_of_the_start(starting):
    stages = Stages()
    measured(starting, stages)
    steps = {
        stage.shown[0].technique: stage.shown[0].step_voxels for stage in stages.opened
    }
    assert steps == {"single-pass": 0.5, "multi-pass": 0.5, "paraview-volume": None}


def test_a_fault_ends_one_technique_only(starting):
    stages = Stages(broken="multi-pass")
    found = measured(starting, stages)
    assert found["multi-pass"]["status"] == "failed"
    assert "the driver is gone" in found["multi-pass"]["reason"]
    assert found["single-pass"]["first_ms"].median > 0
    tried = [
        stage for stage in stages.opened if stage.shown[0].technique == "multi-pass"
    ]
    assert len(tried) == 1, "a technique that failed is not tried again"
    assert all(stage.closed for stage in stages.opened)


def test_an_edit_lowers_every_opacity():
    assert edited(FUNCTION).opacity == ((0, 0), (1, pytest.approx(0.45)))


def rows() -> list[StartRow]:
    facts = ("shell", (8, 8, 8), "uint16")
    ours = StartRow(
        *(*facts, "single-pass"),
        show_ms=spread([20.0]),
        first_ms=spread([100.0]),
        still_ms=spread([40.0]),
        edit_ms=spread([50.0]),
        setup_ms=SetUpTimes(30.0, 4.0, None, 12.0),
        edit_setup_ms=SetUpTimes(30.0, 4.0, 1.0, 12.0),
        bytes_on_device=1536,
        volume_bytes=1024,
    )
    theirs = StartRow(
        *(*facts, "paraview-volume"),
        first_ms=spread([250.0]),
        still_ms=spread([90.0]),
        edit_ms=spread([100.0]),
        volume_bytes=1024,
    )
    failed = StartRow(*(*facts, "compute"), status="failed", reason="no such thing")
    return [ours, theirs, failed]


def test_tables_compare_with_paraview():
    table = first_table(rows())
    ours = dict(zip(table.header, table.rows[0]))
    assert ours["ParaView's over ours"] == "2.50"
    assert ours["over the volume's bytes"] == "1.50"
    assert ours["of it the display, ms"] == "20"
    assert ours["grid ms"] == "-" and ours["upload ms"] == "30.0"
    assert table.rows[2][2] == "no such thing"
    edits = edit_table(rows())
    cells = dict(zip(edits.header, edits.rows[0]))
    assert cells["set-up share"] == "10.0 %", "4 + 1 of 50 ms"
    assert cells["ParaView's over ours"] == "2.00"
    assert len(edits.rows) == 2, "what failed has no edits"
    assert first_table([]) is None and edit_table([]) is None


def test_remarks_compare_with_paraview():
    first, edit = start_remarks(rows())
    assert "first picture of a volume in memory comes 2.5 times as fast" in first
    assert "after an edit of the transfer function comes 2.0 times as fast" in edit
    assert start_remarks([]) == []


def test_the_file_holds_every_row(tmp_path):
    start = Start((Dataset("shell"),), "ramp", ("single-pass",), (40, 30))
    write_start(tmp_path, start, rows())
    assert read_start(tmp_path) == rows()
    assert read_start(tmp_path / "elsewhere") == []


def test_errors_of_the_stage_are_faults(starting):
    class Complaining(FakeStage):
        def take_errors(self):
            return "out of memory"

    found = measure_start(Complaining, FUNCTION, starting, lambda share: None)
    assert {values["reason"] for values in found} == {"out of memory"}
