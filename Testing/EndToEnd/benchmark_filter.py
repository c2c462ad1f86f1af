"""The filter VolumeBenchmark: rows from good settings, one clear error from bad ones."""

import json
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from paraview import servermanager, simple
from support import (
    ERRORS,
    LABEL,
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


def check_blend_modes() -> None:
    """VTK's mapper gets the blend mode too; what it lacks is told, not drawn otherwise."""
    bench = benchmark(wavelet(8))
    bench.Techniques = ["vtk-gpu"]
    bench.ErrorViews = 0
    for mode in ("Maximum", "Minimum", "Average"):
        bench.BlendMode = mode
        table = expect_rows(bench, 1)
        assert table.GetColumnByName("blend_mode").GetValue(0) == mode
        assert table.GetColumnByName("status").GetValue(0) == "ok"
    bench.BlendMode = "Gradient"
    table = expect_rows(bench, 1)
    assert table.GetColumnByName("status").GetValue(0) == "unsupported"
    assert "Gradient" in table.GetColumnByName("reason").GetValue(0)


def check_jitter() -> None:
    """The property and a variant mean the same, and both are off by default."""

    def features(**settings: Any) -> list[str]:
        bench = benchmark(wavelet(8))
        for name, value in settings.items():
            setattr(bench, name, value)
        table = expect_rows(bench, 1)
        return table.GetColumnByName("features").GetValue(0).split()

    assert "jitter" not in features()
    assert "jitter" in features(Jitter=1, JitterSeed=5)
    assert "jitter" in features(Variants=["single-pass; jitter=1; jitter_seed=5"])


def check_variants() -> None:
    bench = benchmark(wavelet(8))
    bench.Variants = [f"single-pass; slice_threads={count}" for count in (1, 4)]
    table = expect_rows(bench, 2)
    cells = [table.GetColumnByName("settings").GetValue(row) for row in range(2)]
    assert [json.loads(cell) for cell in cells] == [
        {"slice_threads": 1},
        {"slice_threads": 4},
    ]


def check_variants_with_a_sampling_of_their_own() -> None:
    """A variant that names integrator and step is one row, whatever the lists hold."""
    bench = benchmark(wavelet(8))
    bench.Techniques = ["single-pass", "vtk-gpu"]
    bench.StepVoxels = [2.0, 1.0]
    bench.Variants = [
        "single-pass; integrator=Segment; step_voxels=0.25; table_size=64",
        "vtk-gpu; sample_distance_voxels=2",
    ]
    table = expect_rows(bench, 2)

    def column(name: str) -> list:
        return [table.GetColumnByName(name).GetValue(row) for row in range(2)]

    assert column("integrator") == ["Segment", ""]
    assert column("step_voxels") == [0.25, 2.0]
    assert json.loads(column("settings")[0]) == {"table_size": 64}


def check_three_views() -> None:
    bench = benchmark(wavelet(8))
    bench.CameraPath = "three-views"
    expect_nothing(bench, "three-views has 3 frames, not 4")
    bench.Frames = 3
    bench.ErrorViews = 3
    table = expect_rows(bench, 1)
    assert table.GetColumnByName("view").GetValue(0) == "three-views"


def faint_cube(label: str) -> tuple[Any, Any]:
    """Return a view straight at a homogeneous cube of 16 voxels an edge, and its display."""
    view = new_view()
    display = show(wavelet(8), view, label)
    color_by(display, view, "RTData")
    opacity = simple.GetOpacityTransferFunction("RTData")
    opacity.Points = [0, 0.01, 0.5, 0, 300, 0.01, 0.5, 0]
    look(view, 0, 0)
    view.CameraParallelProjection = 1
    return view, display


def check_samples_of_paraviews_volume() -> None:
    """Straight through a cube of 16 voxels: as many samples as ParaView's step for so few voxels.

    Below 100 cells an edge, VTK shortens its half voxel: times 0.01 + 0.99 * 16 / 100 for 16 cells.
    """
    view, _ = faint_cube("Volume")
    before = capture(view)
    counts = capture(view, count_samples=True)[..., 0]
    steps = 16 / (0.5 * (0.01 + 0.99 * 0.16))
    covered = counts[counts > 0]
    print(f"  {covered.min():g} to {covered.max():g} samples for {steps:.1f} steps")
    assert (abs(covered - steps) <= 2).all()
    assert ((counts > 0) == (before[..., 3] > 0)).all()
    assert rmse(capture(view), before) == 0, "counting changed the view"


def check_what_our_own_volume_tells_of_a_frame() -> None:
    """Straight through 16 voxels at a step of one: 16 samples a ray, and the facts of the frame."""
    view, display = faint_cube(LABEL)
    display.StepVoxels = 1
    before = capture(view)
    counts = capture(view, count_samples=True)
    covered = counts[..., 0][counts[..., 0] > 0]
    assert (abs(covered - 16) <= 1).all(), f"{covered.min():g} to {covered.max():g}"
    assert ((counts[..., 0] > 0) == (before[..., 3] > 0)).all()
    assert rmse(capture(view), before) == 0, "counting changed the view"
    description = description_of(view)
    assert description["bytes_on_device"] >= 17**3, description
    assert "lighting" in description["left_out"].split(), description
    assert description["setup_ms.upload"] > 0, description
    display.SetRepresentationType("Volume")
    simple.Render(view)
    assert description_of(view) == {}, "ParaView's Volume is none of ours"


def description_of(view: Any) -> dict[str, Any]:
    proxy = servermanager.misc.VolumeBenchmarkViewCapture()
    proxy.View = view
    proxy.UpdateVTKObjects()
    proxy.UpdatePropertyInformation()
    return json.loads(proxy.GetProperty("Description").GetData())


def check_samples_and_stages() -> None:
    """Counts are whole numbers above 0 where a technique counts; stages are JSON."""
    table = expect_rows(benchmark(wavelet(8)), 1)
    taken = table.GetColumnByName("samples_taken").GetValue(0)
    assert np.isnan(taken) or (taken > 0 and taken == int(taken)), taken
    stages = table.GetColumnByName("stages_ms").GetValue(0)
    assert not stages or all(value >= 0 for value in json.loads(stages).values())


def check_errors_have_a_size_and_pictures() -> None:
    bench = benchmark(wavelet(8))
    bench.ErrorImageSize = [32, 20]
    with tempfile.TemporaryDirectory() as folder:
        bench.PictureFolder = folder
        table = expect_rows(bench, 1)
        name = table.GetColumnByName("picture").GetValue(0)
        for file in (name, "reference.rgba32f"):
            values = np.fromfile(Path(folder) / file, "<f4")
            assert values.size == 32 * 20 * 4 and np.isfinite(values).all()
            assert values.max() > 0
    size = [table.GetColumnByName(f"error.image_size.{side}") for side in "wh"]
    assert [column.GetValue(0) for column in size] == [32, 20]
    assert table.GetColumnByName("image_size.w").GetValue(0) == 64
    bench.PictureFolder = "/no/such/folder"
    expect_nothing(bench, "/no/such/folder")


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
        ("ErrorImageSize", [5, 0], "5 x 0"),
        ("Integrators", ["Simpson"], "Simpson"),
        ("SliceThreads", 3, "threads 3"),
        ("Variants", ["slices"], "'slices', which is not measured"),
        ("Variants", ["single-pass; colour=red"], "colour"),
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
