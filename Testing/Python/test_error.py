"""Image error against values worked out by hand."""

import math

import numpy as np
import pytest
from volumebench.error import compare
from volumebench.errors import BenchError


def picture(pixels: list) -> np.ndarray:
    return np.array([pixels], np.float32)


EMPTY = [0, 0, 0, 0]


def test_hand_computed_values():
    """Two covered pixels, eight values: differences 0.5 and 0.25 and six zeros."""
    ours = picture([[0.5, 0, 0, 1], [0.25, 0, 0, 0.5], EMPTY])
    truth = picture([[0, 0, 0, 1], [0.25, 0, 0, 0.25], EMPTY])
    error = compare([(ours, truth)], "truth", 0.001)
    rmse = math.sqrt((0.25 + 0.0625) / 8)
    assert error.rmse == pytest.approx(rmse)
    assert error.linf == 0.5
    assert error.psnr == pytest.approx(-20 * math.log10(rmse))
    assert error.p999 == pytest.approx(0.25 + 0.25 * (7 * 0.999 - 6))
    assert (error.reference, error.reference_uncertainty) == ("truth", 0.001)


def test_empty_background_does_not_flatter():
    ours = [[0.1, 0.1, 0.1, 0.1]]
    truth = [[0, 0, 0, 0.1]]
    alone = compare([(picture(ours), picture(truth))])
    padded = compare([(picture(ours + [EMPTY] * 50), picture(truth + [EMPTY] * 50))])
    assert (padded.rmse, padded.p999) == (alone.rmse, alone.p999)
    assert (padded.image_size, alone.image_size) == ((51, 1), (1, 1))


def test_union_footprint_counts_pixels_that_only_one_covers():
    covered, other = picture([[1, 0, 0, 1], EMPTY]), picture([EMPTY, [1, 0, 0, 1]])
    assert compare([(covered, other)]).rmse == pytest.approx(math.sqrt(4 / 8))


def test_views_are_pooled():
    """A one-pixel view and a three-pixel view: the mean is over pixels, not over views."""
    one = (picture([[0, 0, 0, 1]]), picture([[0, 0, 0, 0.5]]))
    three = (picture([[0, 0, 0, 1]] * 3), picture([[0, 0, 0, 1]] * 3))
    assert compare([one, three]).rmse == pytest.approx(math.sqrt(0.25 / 16))


def test_equal_pictures_have_no_psnr():
    same = picture([[0.2, 0.3, 0.4, 0.5]])
    error = compare([(same, same)])
    assert (error.rmse, error.linf, error.psnr) == (0, 0, None)


def test_faults():
    empty = picture([EMPTY])
    with pytest.raises(BenchError, match="no pixel is covered"):
        compare([(empty, empty)])
    with pytest.raises(BenchError, match="different size"):
        compare([(empty, picture([EMPTY, EMPTY]))])
    with pytest.raises(BenchError, match="not finite"):
        compare([(picture([[math.nan, 0, 0, 1]]), empty)])
    with pytest.raises(BenchError, match="not finite"):
        compare([(picture([[0, 0, 0, math.nan]]), empty)])
