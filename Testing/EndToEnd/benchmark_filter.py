"""The filter VolumeBenchmark: rows from good settings, one clear error from bad ones."""

from typing import Any

import numpy as np
from paraview import servermanager, simple
from support import (
    ERRORS,
    blob,
    capture,
    check_not_empty,
    color_by,
    image_data,
    look,
    new_view,
    producer,
    rmse,
    run_checks,
    show,
    wavelet,
)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkImageData

NOTHING = "Nothing measured: "


def benchmark(source: Any) -> Any:
    """Return the filter with settings that take a fraction of a second."""
    bench = simple.VolumeBenchmark(Input=source)
    bench.Techniques = ["single-pass"]
    bench.StepVoxels = [1.0]
    bench.ImageSize = [64, 48]
    bench.Frames = 4
    bench.MinimumFrames = 2
    bench.WarmUpFrames = 1
    bench.TimeLimit = 0.2
    bench.ReferenceStepVoxels = 0.25
    return bench


def table_of(bench: Any) -> Any:
    bench.UpdatePipeline()
    return servermanager.Fetch(bench)


def expect_nothing(bench: Any, cause: str) -> None:
    """Check that the table is empty and that one error names the cause."""
    table = table_of(bench)
    messages = ERRORS.take()
    assert table.GetNumberOfRows() == 0, f"{cause}: {table.GetNumberOfRows()} rows"
    assert len(messages) == 1, f"{cause}: {len(messages)} errors: {messages}"
    assert NOTHING in messages[0], messages[0]
    text = messages[0].rpartition(NOTHING)[2]
    print(f"  {text}")
    assert cause in text, f"{cause!r} is not in {text!r}"


def expect_rows(bench: Any, rows: int) -> Any:
    """Check for so many rows of finite numbers; return the table."""
    table = table_of(bench)
    assert not ERRORS.messages, ERRORS.take()
    assert (
        table.GetNumberOfRows() == rows
    ), f"{table.GetNumberOfRows()} rows, not {rows}"
    for index in range(table.GetNumberOfColumns()):
        column = table.GetColumn(index)
        if isinstance(column, vtkDataArray):
            values = vtk_to_numpy(column)
            assert not np.isinf(values).any(), f"{column.GetName()}: {values}"
    return table


def check_rows() -> None:
    bench = benchmark(wavelet(8))
    bench.StepVoxels = [1.0, 0.5]
    bench.Integrators = ["Left", "Midpoint"]
    table = expect_rows(bench, 4)
    names = [table.GetColumnName(index) for index in range(table.GetNumberOfColumns())]
    print("  " + " ".join(names))
    assert len(set(names)) == len(names) > 5


def check_peers() -> None:
    bench = benchmark(wavelet(8))
    bench.Techniques = ["single-pass", "vtk-gpu", "vtk-fixed-point"]
    expect_rows(bench, 3)


def check_bad_settings() -> None:
    bench = benchmark(wavelet(8))
    for name, value, cause in (
        ("Techniques", ["no-such-technique"], "no-such-technique"),
        ("Techniques", [], "technique"),
        ("StepVoxels", [0.0], "step"),
        ("StepVoxels", [-1.0], "step"),
        ("StepVoxels", [float("nan")], "step"),
        ("ImageSize", [0, 0], "size"),
        ("ImageSize", [-5, 10], "size"),
        ("Integrators", ["Simpson"], "Simpson"),
        ("OpacityPoints", [1.0, 0.1, 0.0, 0.5], "ascending"),
        ("CameraPath", "spiral", "spiral"),
        ("Frames", 0, "frames"),
    ):
        good = bench.GetPropertyValue(name)
        good = good if isinstance(good, (int, float, str)) else list(good)
        setattr(bench, name, value)
        expect_nothing(bench, cause)
        setattr(bench, name, good)
    expect_rows(bench, 1)


def check_technique_that_fails() -> None:
    bench = benchmark(wavelet(8))
    bench.TerminationThreshold = 1.5
    table = table_of(bench)
    assert len(ERRORS.take()) <= 1
    assert table.GetNumberOfRows() == 1
    assert table.GetColumnByName("status").GetValue(0) == "failed"
    assert "threshold" in table.GetColumnByName("reason").GetValue(0)


def check_bad_input() -> None:
    empty = image_data(blob(6))
    empty.GetPointData().RemoveArray(0)
    for image, cause in (
        (vtkImageData(), ""),
        (empty, "no numeric array"),
        (image_data(blob(6)[:, :, :1]), "one point thick"),
        (image_data(np.full((4, 4, 4), np.nan)), "no finite value"),
    ):
        expect_nothing(benchmark(producer(image)), cause)


def check_view_is_left_alone() -> None:
    view = new_view()
    source = wavelet(8)
    display = show(source, view)
    color_by(display, view, "RTData")
    look(view)
    before = capture(view)
    check_not_empty(before, "before")
    expect_rows(benchmark(source), 1)
    assert rmse(capture(view), before) == 0, "measuring changed the view"


if __name__ == "__main__":
    run_checks(dict(globals()))
