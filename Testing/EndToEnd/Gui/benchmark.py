"""Volume Benchmark in ParaView's window: from the menu to its table and its chart."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from window import (
    apply,
    labels,
    picture_of,
    rows,
    settle,
    source_panel,
    trigger,
    wait_until,
)

DEFAULT_ROWS = [
    "Array",
    "Techniques",
    "Integrators",
    "StepVoxels",
    "ImageSize",
    "BlendMode",
    "Frames",
    "TimeLimit",
    "ErrorViews",
]


def open_filter() -> object:
    """Make a wavelet and put the filter on it, as yet without Apply."""
    trigger("Sources", "Alphabetical", "Wavelet")
    apply()
    trigger("Filters", "Volume", "Volume Benchmark")
    return simple.GetActiveSource()


def view_of_type(name: str) -> object:
    found = [one for one in simple.GetViews() if one.SMProxy.GetXMLName() == name]
    assert len(found) == 1, f"{len(found)} views of type {name}"
    return found[0]


def table_of(source: object, port: int) -> object:
    return source.GetClientSideObject().GetOutputDataObject(port)


def check_panel_shows_what_one_needs() -> None:
    source = open_filter()
    assert source.SMProxy.GetXMLName() == "VolumeBenchmark"
    shown = list(rows(source_panel()))
    assert shown == DEFAULT_ROWS, shown
    assert "Time Limit" in labels(source_panel()), labels(source_panel())
    assert list(source.Array) == ["POINTS", "RTData"], source.Array


def check_apply_opens_table_and_chart() -> None:
    source = open_filter()
    source.ImageSize = [96, 96]
    source.TimeLimit = 0.5
    source.StepVoxels = [2.0, 1.0, 0.5]
    apply()
    wait_until(lambda: len(simple.GetViews()) == 3, "two more views")
    settle(500)
    runs, curves = table_of(source, 0), table_of(source, 1)
    assert runs.GetNumberOfRows() == 4, runs.GetNumberOfRows()
    names = [curves.GetColumnName(i) for i in range(curves.GetNumberOfColumns())]
    assert names == ["X frame_ms", "single-pass Midpoint", "vtk-gpu"], names
    expect_curve(runs, curves)
    spread = view_of_type("SpreadSheetView").Representations
    assert [one.Input.Port for one in spread] == [
        0
    ], "the table is not that of the runs"
    expect_chart(view_of_type("VolumeBenchmarkChartView"))
    expect_all_runs_in_sight(view_of_type("VolumeBenchmarkChartView"))


def expect_curve(runs: object, curves: object) -> None:
    """Fail unless the chart's points are the errors and times of the table's rows."""
    errors = vtk_to_numpy(runs.GetColumnByName("error.rmse"))
    times = vtk_to_numpy(runs.GetColumnByName("frame_ms.median"))
    assert errors[0] > 4 * errors[2] > 0, errors
    assert list(vtk_to_numpy(curves.GetColumn(0))) == list(times)
    own, peer = vtk_to_numpy(curves.GetColumn(1)), vtk_to_numpy(curves.GetColumn(2))
    assert list(own[:3]) == list(errors[:3]) and own[3] != own[3], own
    assert peer[3] == errors[3] and (peer[:3] != peer[:3]).all(), peer


def expect_chart(view: object) -> None:
    """Fail unless the chart shows the curves over the time, on logarithmic axes."""
    assert view.LeftAxisLogScale and view.BottomAxisLogScale
    assert view.LeftAxisTitle == "Error (RMSE)", view.LeftAxisTitle
    assert view.BottomAxisTitle == "Frame time (ms)", view.BottomAxisTitle
    (shown,) = view.Representations
    assert shown.Visibility and shown.Input.Port == 1
    assert not shown.UseIndexForXAxis and shown.XArrayName == "X frame_ms"
    visible = list(shown.SeriesVisibility)
    assert visible == ["single-pass Midpoint", "vtk-gpu"], visible


def expect_all_runs_in_sight(view: object) -> None:
    """Fail unless the marks of both curves can be seen; the legend is above them."""
    assert view.ShowLegend and view.LegendLocation == "Top", view.LegendLocation
    (shown,) = view.Representations
    view.ShowLegend = 0
    for series in ("single-pass Midpoint", "vtk-gpu"):
        marks = count_marks(view, shown, series)
        assert marks > 30, f"{series} has {marks} pixels"


def count_marks(view: object, shown: object, series: str) -> int:
    """Return how many pixels have the colour of a curve."""
    colors = list(shown.SeriesColor)
    at = colors.index(series)
    color = np.array([float(one) for one in colors[at + 1 : at + 4]])
    simple.Render(view)
    picture = picture_of(view.SMProxy.CaptureWindow(1))
    return int((np.abs(picture - color).max(axis=2) < 0.1).sum())
