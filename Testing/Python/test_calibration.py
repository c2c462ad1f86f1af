"""Calibrations: read strictly, kept in results.json, shown as a share of each row's ceiling."""

import json
from dataclasses import replace

import pytest
from fakes import FakeSession
from volumebench.calibration import (
    ceiling_of,
    ceiling_table,
    load_calibration,
    native_ceiling_of,
    profile_table,
    sample_ceiling_of,
    with_calibration,
)
from volumebench.errors import BenchError
from volumebench.progress import Progress
from volumebench.results import (
    Context,
    FrameLog,
    read_results,
    record_of,
    times,
    write_results,
)
from volumebench.runner import Runner, find_inputs, prepare_folder
from volumebench.study import Timing

MACHINE = {"host": "node", "cpu": "a processor", "gl_renderer": "a device"}


def rate(median):
    return {name: median for name in ("median", "q1", "q3", "min", "max")}


def fetches(path, kind, format_name, entries, per_second):
    row = {"path": path, "kind": kind, "format": format_name, "order": "axis"}
    return row | {"entries": entries, "fetches": 1e6, "per_second": rate(per_second)}


@pytest.fixture
def calibration_document():
    context = dict.fromkeys(
        ("date", "cores", "gl_version", "vtk", "plugin", "build_type")
    )
    return {
        "schema": 1,
        "kind": "calibration",
        "sample": "one trilinear fetch of one value",
        "context": context
        | MACHINE
        | {"date": "2026-11-22", "opencl_device": "a platform: a device"},
        "cpu_kernel": "AVX2",
        "cpu_pair_kernel": "AVX2",
        "opencl_device_type": "cpu",
        "fetches": [
            fetches("gl-fragment", "trilinear", "R16", 16, 4e9),
            fetches("gl-fragment", "trilinear", "R16", 256, 1e9),
            fetches("gl-fragment", "trilinear", "R32F", 16, 2e9),
            fetches("gl-fragment", "texel", "R8", 16, 9e9),
            fetches("gl-fragment", "table", "RGBA32F", 1024, 12e9),
            fetches("gl-compute", "trilinear", "R16", 16, 5e9),
            fetches("cpu", "trilinear", "R16", 16, 6e9),
            fetches("cpu-pairs", "trilinear", "R16", 16, 8e9),
            fetches("opencl-lanes", "trilinear", "R16", 16, 7e9),
            fetches("opencl-buffers", "trilinear", "R16", 16, 1e9),
            fetches("opencl-images", "trilinear", "R16", 16, 0.5e9),
        ],
        "copies": [{"path": "gl", "bytes": 8.0, "bytes_per_second": rate(1e9)}],
    }


@pytest.fixture
def file(tmp_path, calibration_document):
    path = tmp_path / "calibration.json"
    path.write_text(json.dumps(calibration_document))
    return path


@pytest.fixture
def context(file):
    return with_calibration(Context(**MACHINE), load_calibration(file))


def row_of(study, technique, scalar_type, samples, ms, settings=(), **values):
    run = replace(study.runs()[0], technique=technique, settings=settings)
    measured = times(FrameLog([0], [ms], [None]))
    return record_of(
        run, None, scalar_type, samples_taken=samples, **measured, **values
    )


def test_the_ceiling_is_the_highest_trilinear_rate(context):
    kept = context.calibration["samples_per_second"]
    assert kept == {
        "gl-fragment": {"R16": 4e9, "R32F": 2e9},
        "gl-compute": {"R16": 5e9},
        "cpu": {"R16": 6e9},
        "cpu-pairs": {"R16": 8e9},
        "opencl-lanes": {"R16": 7e9},
        "opencl-buffers": {"R16": 1e9},
        "opencl-images": {"R16": 0.5e9},
    }


def test_a_sample_with_a_look_up_takes_the_time_of_both(context, study):
    def ceiling(technique):
        return sample_ceiling_of(context, row_of(study, technique, "uint8", 1, 1))

    assert ceiling("single-pass") == pytest.approx(3e9)
    assert ceiling("compute") is None  # its look-ups were not measured
    bare = replace(context, calibration=None)
    assert sample_ceiling_of(bare, row_of(study, "slices", "uint8", 1, 1)) is None


def test_each_row_has_the_ceiling_of_its_path_and_format(context, study):
    def ceiling(technique, scalar_type):
        return ceiling_of(context, row_of(study, technique, scalar_type, 1, 1))

    assert ceiling("single-pass", "uint8") == 4e9
    assert ceiling("slices", "float64") == 2e9
    assert ceiling("compute", "uint16") == 5e9
    assert ceiling("compute", "float32") is None  # not measured
    assert (
        ceiling("vtk-fixed-point", "uint8") is None
    )  # no trilinear fetches of its own
    assert ceiling_of(Context(), row_of(study, "compute", "uint8", 1, 1)) is None


def test_opencl_has_the_ceiling_of_the_way_it_fetches(context, study):
    def ceiling(features=(), **settings):
        row = row_of(study, "opencl", "uint8", 1, 1, tuple(settings.items()))
        return ceiling_of(context, replace(row, features=features))

    assert ceiling(("midpoint", "simd-rays")) == 7e9
    assert ceiling(opencl_storage="Images") == 0.5e9
    assert ceiling(opencl_storage="Buffers") == 1e9
    assert ceiling() == ceiling(opencl_storage="Auto") == 1e9
    context.calibration["opencl_device_type"] = "gpu"
    assert ceiling() == 0.5e9
    del context.calibration["samples_per_second"]["opencl-images"]
    assert ceiling() == 1e9
    assert ceiling(opencl_device="a platform: a device") == 1e9
    assert ceiling(opencl_device="another") is None


def test_the_native_ceiling_is_for_what_the_processor_draws(context, study):
    def native(technique):
        return native_ceiling_of(context, row_of(study, technique, "uint8", 1, 1))

    assert native("opencl") == 8e9
    assert native("single-pass") is None  # a device draws it
    context.calibration["gl_renderer"] = "llvmpipe (LLVM 15.0.6, 256 bits)"
    context.calibration["opencl_device_type"] = "gpu"
    assert native("single-pass") == native("compute") == 8e9
    assert native("opencl") is None
    assert native("vtk-fixed-point") is None


def test_calibrations_of_before_there_were_others_have_their_ceilings(context, study):
    rates = context.calibration["samples_per_second"]
    for path in [name for name in rates if not name.startswith("gl-")]:
        del rates[path]
    del context.calibration["look_ups_per_second"]
    del context.calibration["opencl_device"], context.calibration["opencl_device_type"]
    single = row_of(study, "single-pass", "uint8", 2_000_000, 2)
    assert ceiling_of(context, single) == 4e9
    assert ceiling_of(context, row_of(study, "opencl", "uint8", 1, 1)) is None
    assert ceiling_table(context, [single]).rows[0][4:] == (
        *("1000", "4000", "25.0 %"),
        *("-", "-", "-", "-"),
    )


def test_the_profile_tells_what_fetches_alone_would_take(context, study):
    stages = {"dispatch": 1.5, "display": 0.5}
    rows = [
        row_of(study, "opencl", "uint8", 2_000_000, 4, stages_ms=stages),
        row_of(study, "opencl", "uint8", None, 4),
        row_of(study, "reference", "uint8", 2_000_000, 4),
    ]
    assert [row[4:] for row in profile_table(context, rows).rows] == [
        ("4.0", "dispatch 1.50 ms (75 %), display 0.50 ms (25 %)")
        + ("2.00", "2.0", "0.2", "2.0")
    ]
    assert profile_table(Context(), rows) is None


def test_the_table_tells_the_share(context, study):
    records = [
        row_of(study, "single-pass", "uint8", 2_000_000, 2),
        row_of(study, "single-pass", "uint8", None, 2),
    ]
    table = ceiling_table(context, records)
    assert [row[4:] for row in table.rows] == [("1000", "4000", "25.0 %", "3000", "33.3 %", "-", "-")]
    table = ceiling_table(context, [row_of(study, "opencl", "uint8", 2_000_000, 4)])
    assert table.rows[0][4:] == ("500", "1000", "50.0 %", "-", "-", "8000", "6.2 %")
    assert ceiling_table(Context(), records) is None


def test_results_keep_the_calibration(tmp_path, context):
    write_results(tmp_path, context, [])
    assert read_results(tmp_path / "results.json")[0] == context


def test_results_from_before_calibrations_can_be_read(tmp_path):
    write_results(tmp_path, Context(), [])
    path = tmp_path / "results.json"
    old = json.loads(path.read_text())
    del old["context"]["calibration"]
    path.write_text(json.dumps(old))
    assert read_results(path)[0] == Context()


@pytest.mark.parametrize("key", ["kind", "fetches", "copies"])
def test_a_file_that_is_no_calibration_is_named(file, calibration_document, key):
    del calibration_document[key]
    file.write_text(json.dumps(calibration_document))
    with pytest.raises(BenchError, match=f"calibration.json: .*'{key}'"):
        load_calibration(file)


@pytest.mark.parametrize("key", MACHINE)
def test_the_ceilings_of_another_machine_are_refused(file, key):
    here = Context(**MACHINE | {key: "another"})
    with pytest.raises(BenchError, match=f'"{key}" is .*another'):
        with_calibration(here, load_calibration(file))


def test_a_resumed_study_keeps_its_calibration(study, tmp_path, file):
    class Here(FakeSession):
        def context(self):
            return Context(**MACHINE)

    calm = replace(study, timing=Timing(1, 4, 1.0, 60.0))

    def measure(calibration, resume):
        earlier = prepare_folder(calm, tmp_path, resume)
        inputs = find_inputs(calm, None, tmp_path / "volumes")
        runner = Runner(calm, inputs, tmp_path, earlier, calibration)
        runner.measure(Here(calm), Progress(1))
        return read_results(tmp_path / "results.json")[0].calibration

    assert measure(None, False) is None
    calibration = load_calibration(file)
    assert measure(calibration, True) == calibration
    assert measure(None, True) == calibration
    assert measure(None, False) is None
