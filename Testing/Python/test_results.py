"""results.json keeps its contract: all keys, null for absent, written whole or not at all."""

import csv
import json
import math
from dataclasses import replace

import pytest
from fakes import FakeSession
from volumebench.error import ImageError
from volumebench.errors import BenchError
from volumebench.json_file import make_writable_folder, write_atomically
from volumebench.statistics import Spread
from volumebench.results import (
    FrameLog,
    Context,
    as_csv,
    check_same_settings,
    read_results,
    record_of,
    times,
    values_of_row,
    write_results,
    write_settings,
)

RUN_KEYS = [
    *("study", "dataset", "dims", "scalar_type", "transfer_function", "technique"),
    *("integrator", "blend_mode", "step_voxels", "image_size", "view", "path"),
    *(
        "settings",
        "lighting",
        "stand_in_for",
        "features",
        "left_out",
        "status",
        "reason",
        "frames",
        "frame_ms",
        "gpu_ms",
    ),
    *(
        "fps",
        "frame_log",
        "setup_ms",
        "stages_ms",
        "samples_taken",
        "samples_skipped",
        "rays_terminated",
    ),
    *("bytes_on_device", "error"),
]


@pytest.fixture
def records(study):
    session = FakeSession(study)
    volume = session.open_volume(None)
    return session.run_engine(volume, None, study.runs()[:3], None)[0]


def test_keys_of_the_contract_in_order(tmp_path, records):
    write_results(tmp_path, Context(cores=2), records)
    document = json.loads((tmp_path / "results.json").read_text())
    assert list(document) == ["schema", "context", "runs"]
    row = document["runs"][0]
    assert list(row) == RUN_KEYS
    assert list(row["frame_ms"]) == ["median", "q1", "q3", "min", "max"]
    assert list(row["gpu_ms"]) == list(row["frame_ms"])
    assert list(row["setup_ms"]) == ["upload", "tables", "grid", "compile"]
    assert list(row["error"]) == [
        *("rmse", "linf", "p999", "psnr", "mean"),
        *("ssim", "delta_e_over_1_percent", "flip_mean", "flip_p99"),
        *("reference", "reference_uncertainty", "image_size"),
    ]
    assert row["image_size"] == [40, 30] and row["dims"] == [8, 8, 16]


def test_absent_is_null_never_zero(tmp_path, study):
    write_results(tmp_path, Context(), [record_of(study.runs()[0], None, None)])
    row = json.loads((tmp_path / "results.json").read_text())["runs"][0]
    assert row["error"]["rmse"] is None and row["frames"] is None
    assert row["frame_ms"]["median"] is None and row["features"] is None


def test_read_gives_back_what_was_written(tmp_path, records):
    context = Context(date="now", cores=2)
    write_results(tmp_path, context, records)
    assert read_results(tmp_path / "results.json") == (context, records)


def test_settings_and_stages_are_kept(tmp_path, study):
    run = replace(study.runs()[0], settings=(("slice_threads", 4),))
    stages = {"drawing": 12.5, "upload": None}
    error = ImageError(rmse=0.1, image_size=(20, 10))
    record = record_of(run, None, None, stages_ms=stages, error=error)
    write_results(tmp_path, Context(), [record])
    row = json.loads((tmp_path / "results.json").read_text())["runs"][0]
    assert row["settings"] == {"slice_threads": 4} and row["stages_ms"] == stages
    assert row["error"]["image_size"] == [20, 10]
    (again,) = read_results(tmp_path / "results.json")[1]
    assert again == record and again.run() == run
    (cells,) = csv.DictReader((tmp_path / "results.csv").read_text().splitlines())
    assert json.loads(cells["settings"]) == {"slice_threads": 4}
    assert json.loads(cells["stages_ms"]) == stages
    assert cells["error.image_size.w"] == "20"


def test_settings_and_blend_mode_tell_rows_apart(study):
    run = study.runs()[0]
    blended = replace(run, scene=replace(run.scene, blend_mode="Maximum"))
    varied = [replace(run, settings=(("slice_threads", n),)) for n in (1, 2)]
    records = [record_of(item, None, None) for item in (run, blended, *varied)]
    assert len({record.run().key() for record in records}) == 4
    assert records[1].blend_mode == "Maximum"


def test_rows_from_before_stages_and_settings_can_be_read(tmp_path, records):
    write_results(tmp_path, Context(), records)
    path = tmp_path / "results.json"
    document = json.loads(path.read_text())
    for row in document["runs"]:
        for key in ("settings", "stand_in_for", "stages_ms"):
            del row[key]
        del row["error"]["image_size"]
    path.write_text(json.dumps(document))
    assert read_results(path)[1] == records


def test_record_knows_its_run(study, records):
    assert [record.run() for record in records] == study.runs()[:3]


def test_times():
    log = FrameLog([0, 3, 6], [10.0, 20.0, 40.0], [None, 1.0, 2.0])
    values = times(log)
    assert values["frames"] == 3 and values["fps"] == 50 and values["frame_log"] == log
    nothing = {"frames": None, "frame_ms": Spread(), "fps": None, "frame_log": None}
    assert times(FrameLog()) == nothing


def test_csv_has_dotted_columns_and_empty_cells(records):
    rows = list(csv.DictReader(as_csv(records).splitlines()))
    assert rows[0]["image_size.w"] == "40" and rows[0]["dims"] == "8x8x16"
    assert float(rows[0]["frame_ms.median"]) > 0
    assert rows[0]["error.rmse"] == "" and rows[0]["gpu_ms.min"] == ""
    assert len(rows) == 3


def test_table_row_of_the_filter():
    row = {
        "technique": "single-pass",
        "features": "SKIPPING SHADE",
        "left_out": "",
        "status": "ok",
        "reason": "",
        "frames": 12,
        "frame_ms.median": 25.0,
        "frame_ms.q1": math.nan,
        "fps": 40.0,
        "setup_ms.upload": 3.5,
        "samples_taken": 1e6,
        "rays_terminated": 0.0,
        "stages_ms": '{"box faces": 0.5, "march": null}',
        "error.image_size.w": 20.0,
        "error.image_size.h": 10.0,
        "error.psnr": math.inf,
        "error.rmse": 0.0,
    }
    values = values_of_row(row)
    assert values["features"] == ("SKIPPING", "SHADE") and values["left_out"] == ()
    assert values["reason"] is None and values["status"] == "ok"
    assert values["frame_ms"].median == 25 and values["frame_ms"].q1 is None
    assert values["setup_ms"].upload == 3.5 and values["setup_ms"].grid is None
    assert values["samples_taken"] == 1000000
    assert isinstance(values["samples_taken"], int)
    assert values["samples_skipped"] is None and values["rays_terminated"] == 0
    assert values["stages_ms"] == {"box faces": 0.5, "march": None}
    assert values["error"].image_size == (20, 10)
    assert values["error"].psnr is None and values["error"].rmse == 0


def test_a_row_without_status_counts_as_failed():
    values = values_of_row({"technique": "single-pass", "stages_ms": ""})
    assert values["status"] == "failed"
    assert values["stages_ms"] is None and values["error"].image_size is None


def test_atomic_write_leaves_the_old_file_when_it_fails(tmp_path, records):
    write_results(tmp_path, Context(), records)
    before = (tmp_path / "results.json").read_text()
    broken = replace(records[0], fps=math.nan)
    with pytest.raises(ValueError):
        write_results(tmp_path, Context(), [broken])
    assert (tmp_path / "results.json").read_text() == before
    assert sorted(path.name for path in tmp_path.glob("*results*")) == [
        "results.csv",
        "results.json",
    ]


def test_unwritable_places_are_named(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(BenchError, match="file.*not writable"):
        make_writable_folder(tmp_path / "file")
    with pytest.raises(BenchError, match="out/x.json: cannot be written"):
        write_atomically(tmp_path / "out" / "x.json", "{}")


@pytest.mark.parametrize(
    "text, expected",
    [
        ("{", "line 1"),
        ('{"schema": 1, "context": {}, "runs": []}', "context"),
        ('{"schema": 9, "context": {}, "runs": []}', "schema"),
    ],
)
def test_foreign_results_are_refused(tmp_path, text, expected):
    path = tmp_path / "results.json"
    path.write_text(text)
    with pytest.raises(BenchError, match=expected):
        read_results(path)


def test_resume_refuses_other_settings(tmp_path, study):
    write_settings(tmp_path, study.settings())
    check_same_settings(tmp_path, study.settings())
    check_same_settings(tmp_path, study.only(["slices"]).settings())
    other = replace(study, termination_threshold=0.5)
    with pytest.raises(BenchError, match='"termination_threshold" was 0.001'):
        check_same_settings(tmp_path, other.settings())
    with pytest.raises(BenchError, match="settings.json is missing"):
        check_same_settings(tmp_path / "elsewhere", study.settings())
