"""The filter VolumeImageError: hand-computed errors, several views, and pictures that do not fit."""

import math

import numpy as np
from paraview import servermanager, simple
from support import ERRORS, producer, run_checks
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

EMPTY = [0, 0, 0, 0]


def picture(pixels: list, dtype: type = np.float32) -> vtkImageData:
    """Return a picture of one row."""
    image = vtkImageData()
    image.SetDimensions(len(pixels), 1, 1)
    values = numpy_to_vtk(np.array(pixels, dtype), deep=True)
    image.GetPointData().SetScalars(values)
    return image


def compare(*pairs: tuple[vtkImageData, vtkImageData]) -> dict[str, float] | str:
    """Return the row of the filter without the prefix, or its one error."""
    pictures, references = zip(*pairs)
    bench = simple.VolumeImageError(
        Pictures=[producer(item) for item in pictures],
        References=[producer(item) for item in references if item is not None],
    )
    bench.UpdatePipeline()
    table = servermanager.Fetch(bench)
    simple.Delete(bench)
    if messages := ERRORS.take():
        assert len(messages) == 1, messages
        assert table.GetNumberOfRows() == 0
        return messages[0]
    assert table.GetNumberOfRows() == 1
    names = [table.GetColumnName(index) for index in range(table.GetNumberOfColumns())]
    return {
        name.removeprefix("error."): table.GetValueByName(0, name).ToDouble()
        for name in names
    }


def check_hand_computed_values() -> None:
    """Two covered pixels, eight values: differences 0.5 and 0.25 and six zeros."""
    ours = picture([[0.5, 0, 0, 1], [0.25, 0, 0, 0.5], EMPTY])
    truth = picture([[0, 0, 0, 1], [0.25, 0, 0, 0.25], EMPTY])
    error = compare((ours, truth))
    rmse = math.sqrt((0.25 + 0.0625) / 8)
    assert math.isclose(error["rmse"], rmse)
    assert error["linf"] == 0.5
    assert math.isclose(error["psnr"], -20 * math.log10(rmse))
    assert math.isclose(error["p999"], 0.25 + 0.25 * (7 * 0.999 - 6))
    assert math.isclose(error["mean"], 0.75 / 8)
    assert error["delta_e_over_1_percent"] == 50
    assert 0 < error["flip_mean"] <= error["flip_p99"] < 1
    assert 0 < error["ssim"] < 1


def check_views_are_pooled() -> None:
    """A one-pixel view and a three-pixel view: the mean is over pixels, not over views."""
    one = (picture([[0, 0, 0, 1]]), picture([[0, 0, 0, 0.5]]))
    three = (picture([[0, 0, 0, 1]] * 3), picture([[0, 0, 0, 1]] * 3))
    assert math.isclose(compare(one, three)["rmse"], math.sqrt(0.25 / 16))


def check_equal_and_empty_pictures() -> None:
    same = picture([[0.2, 0.3, 0.4, 0.5]])
    error = compare((same, same))
    assert (error["rmse"], error["ssim"], error["flip_p99"]) == (0, 1, 0)
    assert math.isinf(error["psnr"])
    empty = picture([EMPTY])
    assert all(math.isnan(value) for value in compare((empty, empty)).values())
    broken = picture([[math.nan, 0, 0, 1]])
    assert all(math.isnan(value) for value in compare((broken, empty)).values())


def check_what_does_not_fit_is_refused() -> None:
    two, one = picture([EMPTY, EMPTY]), picture([EMPTY])
    assert "2 x 1 cannot be compared with one of 1 x 1" in compare((two, one))
    assert "2 pictures for 1 references" in compare((one, one), (one, None))
    assert "32-bit floats" in compare((one, picture([EMPTY], np.float64)))
    assert "32-bit floats" in compare((one, picture([[0, 0, 0]])))


if __name__ == "__main__":
    run_checks(dict(globals()))
