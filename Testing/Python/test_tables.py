"""Tables and notes say what the rows hold: samples, threads, stages, and what is slow and why."""

from dataclasses import replace

import pytest
from volumebench.error import ImageError
from volumebench.notes import all_notes, slow_rows
from volumebench.report import write_report
from volumebench.results import Context, record_of
from volumebench.statistics import spread
from volumebench.study import Run, Scene
from volumebench.summary import sampling_text, shared_settings, shared_text
from volumebench.tables import (
    as_text,
    feature_table,
    setting_tables,
    slow_table,
    stage_table,
    technique_table,
    text_tables,
)

SCENE = Scene("mri", "mri-translucent", (500, 500))
STAGES = {"tessellation": 5.0, "drawing": 40.0, "display": 5.0}


def row(technique, frame_ms, samples=None, stages=None, settings=(), **changes):
    step = None if technique == "vtk-gpu" else 1.0
    integrator = None if technique == "vtk-gpu" else "Midpoint"
    run = Run(
        "small", SCENE, technique, integrator, step, "orbit-y", "engine", settings
    )
    return record_of(
        run,
        (8, 8, 8),
        "uint8",
        frames=1,
        frame_ms=spread([frame_ms]),
        gpu_ms=spread([frame_ms - 1]),
        fps=1000 / frame_ms,
        samples_taken=samples,
        stages_ms=stages,
        error=ImageError(rmse=0.01, image_size=(250, 250)),
        **changes,
    )


def threaded(count, frame_ms, **values):
    return row(
        "slices-threaded", frame_ms, settings=(("slice_threads", count),), **values
    )


def text_tables_of_first(record):
    return as_text(technique_table([record], SCENE))


@pytest.fixture
def records():
    return [
        row("single-pass", 20.0, 4_000_000),
        row("multi-pass", 30.0, 4_000_000, {"box faces": 3.0, "march": 27.0}),
        row("slices", 50.0, 8_000_000, STAGES),
        threaded(4, 45.0, samples=8_000_000, stages=STAGES),
        threaded(1, 60.0, samples=8_000_000, stages=STAGES | {"upload": 1.0}),
        row("vtk-gpu", 90.0),
    ]


def test_technique_table_shows_samples_and_their_rate(records):
    table = technique_table(records, SCENE)
    assert "errors measured on 250 x 250" in table.title
    cells = {line[1]: dict(zip(table.header, line)) for line in table.rows}
    ours = cells["Single Pass"]
    assert (ours["Msamples"], ours["Msamples/s"]) == ("4.00", "200")
    assert (ours["GPU ms"], ours["FPS"]) == ("19.0", "50.0")
    assert cells["VTK GPU mapper"]["Msamples"] == "-"


def test_single_pass_is_not_slower_than_itself_with_other_settings():
    fast = row("single-pass", 10.0)
    slow = row("single-pass", 30.0, settings=(("termination_threshold", 0),))
    assert slow_table([fast, slow]) is None
    assert slow_table([slow, fast]) is None


def test_settings_that_vary_have_a_table(records):
    (table,) = setting_tables(records)
    assert "Slices Threaded by slice threads" in table.title
    assert table.header == (
        *("slice threads", "FPS", "ms", "RMSE"),
        *("tessellation ms", "drawing ms", "display ms", "upload ms"),
    )
    assert table.rows[0] == (
        "4",
        "22.2",
        "45.0",
        "1.00e-02",
        "5.00",
        "40.00",
        "5.00",
        "-",
    )
    assert table.rows[1][0] == "1" and table.rows[1][-1] == "1.00"


def test_as_many_threads_as_pay_are_called_auto(records):
    (table,) = setting_tables([threaded(0, 40.0), *records])
    assert table.rows[0][0] == "auto"
    assert "slice threads auto" in text_tables_of_first(threaded(0, 40.0))


def test_a_setting_with_one_value_has_no_column(records):
    fixed = (("slice_target", "RGBA8"),)
    rows = [
        replace(item, settings=item.settings | dict(fixed)) for item in records[3:5]
    ]
    (table,) = setting_tables(rows)
    assert "slice target" not in table.header and table.words == 1


def test_steps_and_settings_share_a_table():
    rows = [
        replace(threaded(count, 40.0 / step), step_voxels=step)
        for step in (2.0, 0.5)
        for count in (1, 4)
    ]
    (table,) = setting_tables(rows)
    assert table.header[:2] == ("step", "slice threads") and table.words == 2
    assert [line[:2] for line in table.rows] == [
        *(("2", "1"), ("2", "4"), ("0.5", "1"), ("0.5", "4"))
    ]
    assert not setting_tables(rows[::2]), "the step alone needs no table"


def test_what_all_rows_share_is_told_once(records):
    rows = [replace(item, settings={"skipping": False}) for item in records[:2]]
    rows.append(replace(records[3], settings={"skipping": False, "slice_threads": 4}))
    rows.append(records[-1])
    assert shared_settings(rows) == {"skipping", "integrator"}, "peers have none"
    assert shared_text(rows) == "Midpoint, skipping off"
    shared = shared_settings(rows)
    assert sampling_text(rows[0], shared) == "step 1"
    assert sampling_text(rows[2], shared) == "step 1, slice threads 4"
    rows[0] = replace(rows[0], settings={"skipping": True})
    assert shared_settings(rows) == {"integrator"} and shared_text([]) == ""


def test_what_was_left_out_is_told_by_technique(records):
    plain = [
        replace(item, features=("midpoint",), left_out=("clip",)) for item in records
    ]
    rows = [replace(plain[0], left_out=("clip", "crop")), *plain[1:3]]
    table = feature_table([*rows, records[-1]])
    assert table.rows == (
        ("Single Pass", "midpoint", "clip, crop"),
        ("Multi Pass, Slices", "midpoint", "clip"),
    )
    assert feature_table(records) is None


def test_one_row_of_settings_needs_no_table(records):
    assert not setting_tables(records[:4])


def test_stages_are_told_with_their_shares(records):
    table = stage_table(records)
    by_technique = {line[2]: line[-1] for line in table.rows}
    assert (
        by_technique["Multi Pass"] == "box faces 3.00 ms (10 %), march 27.00 ms (90 %)"
    )
    assert len(table.rows) == 3, "the first settings of a technique, not all"
    assert stage_table(records[:1]) is None


def test_columns_of_text_are_aligned(records):
    lines = as_text(technique_table(records, SCENE)).splitlines()[1:]
    ends = {line.rindex("e-02") for line in lines[1:]}
    assert len(ends) == 1


def test_slow_techniques_are_listed_with_the_cause(records):
    """Slices: 50 / 20 = 2.5 times, twice the samples, so 1.25 for each."""
    table = slow_table(records)
    first, second = (dict(zip(table.header, line)) for line in table.rows)
    assert (first["technique"], first["time"]) == ("Slices", "2.5x")
    assert (first["samples"], first["time of a sample"]) == ("2.00x", "1.2x")
    assert "drawing 40.00 ms (80 %)" in first["stages"]
    assert "slice threads 4" in second["sampling"]


def test_a_slow_technique_has_one_note(records, study):
    other = Scene("mri", "mri-opaque", (500, 500))
    elsewhere = [
        replace(item, transfer_function=other.transfer_function) for item in records
    ]
    elsewhere[2] = replace(elsewhere[2], frame_ms=spread([80.0]))
    notes = all_notes(study, records + elsewhere)
    assert len(notes) == 2
    assert notes[0] == (
        "Slices takes 2.5 to 4.0 times as long as Single Pass in 2 of 2 scenes. It takes 2.00 "
        "times as many samples, and each of them takes 1.2 to 2.0 times as long. Of its stages, "
        "drawing takes 80 % of the time."
    )


def test_equal_counts_are_told_as_such(records, study):
    (note,) = all_notes(study, [records[0], row("compute", 50.0, 4_000_000)])
    assert "It takes just as many samples, and each of them takes 2.5 times" in note


def test_a_slow_technique_without_counts_says_so(records, study):
    base = replace(records[0], samples_taken=None)
    rows = [base, row("compute", 41.0)]
    (note,) = all_notes(study, rows)
    assert "no stages" in note and "not counted" in note
    assert slow_table(rows).rows[0][-2:] == ("-", "-")


def test_nothing_is_slow_without_single_pass_or_below_twice(records):
    assert not slow_rows(records[1:])
    assert not slow_rows([records[0], row("compute", 39.0)])
    assert not slow_rows([records[0], replace(row("compute", 90.0), status="failed")])


def test_report_and_terminal_hold_the_notes_of_study_and_results(
    records, study, tmp_path
):
    noted = replace(study, notes=("Measured by <hand>.",))
    assert all_notes(noted, records)[0] == "Measured by <hand>."
    text = text_tables(noted, records)
    assert (
        "note: Measured by <hand>." in text and "Slices takes 2.5 times as long" in text
    )
    write_report(tmp_path, noted, Context(), records, [])
    html = (tmp_path / "report.html").read_text()
    for expected in ("Measured by &lt;hand&gt;.", "2.5 times as long", "Msamples/s"):
        assert expected in html
    assert "slice threads" in html and "box faces 3.00 ms (10 %)" in html
