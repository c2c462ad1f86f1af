"""The technique that the recipe adds, in pvpython: it is listed, it draws, it can be measured."""

import os

from paraview import servermanager
from support import (
    ERRORS,
    LABEL,
    capture,
    check_not_empty,
    look,
    new_view,
    run_checks,
    show,
    wavelet,
)

TECHNIQUE = os.environ["VOLUMEBENCH_TECHNIQUE"]


def check_representation_draws() -> None:
    view = new_view()
    display = show(wavelet(), view)
    assert LABEL in display.GetProperty("Representation").Available
    assert display.Representation == LABEL
    look(view)
    picture = capture(view)
    check_not_empty(picture, LABEL)
    assert picture[0, 0].max() == 0, "the box covers the corner of the view"


def check_benchmark_measures() -> None:
    bench = servermanager.filters.VolumeBenchmark(Input=wavelet())
    bench.Techniques = [TECHNIQUE]
    bench.Integrators = ["Midpoint"]
    bench.StepVoxels = [1.0]
    bench.ImageSize = [64, 64]
    bench.Frames = 4
    bench.MinimumFrames = 4
    bench.TimeLimit = 2
    bench.ErrorViews = 0
    bench.UpdatePipeline()
    table = bench.GetClientSideObject().GetOutputDataObject(0)
    assert table.GetNumberOfRows() == 1, f"{table.GetNumberOfRows()} rows"
    row = {
        name: table.GetValueByName(0, name).ToString()
        for name in ("technique", "status")
    }
    assert row == {"technique": TECHNIQUE, "status": "ok"}, row


def check_build_without_cuda_says_so() -> None:
    display = show(wavelet(), new_view())
    assert "Volume CUDA" not in display.GetProperty("Representation").Available
    bench = servermanager.filters.VolumeBenchmark(Input=wavelet())
    bench.Techniques = ["cuda"]
    ERRORS.take()
    bench.UpdatePipeline()
    messages = ERRORS.take()
    assert len(messages) == 1, messages
    assert "was made without CUDA's toolkit" in messages[0], messages


if __name__ == "__main__":
    run_checks(globals())
