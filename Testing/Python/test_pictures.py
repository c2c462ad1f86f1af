"""PNG files hold the pixels that were given, and differences are amplified honestly."""

import matplotlib.image
import numpy as np
import pytest
from volumebench.pictures import BLACK, amplification, difference_image, over, write_png


def test_png_round_trip(tmp_path):
    rgb = np.random.default_rng(1).integers(0, 256, (5, 7, 3), np.uint8)
    write_png(tmp_path / "x.png", rgb)
    stored = matplotlib.image.imread(tmp_path / "x.png")
    assert (np.rint(stored[..., :3] * 255) == rgb).all()


def test_premultiplied_colour_over_a_background():
    half_red = np.array([[[0.5, 0, 0, 0.5]]])
    assert over(half_red, BLACK).tolist() == [[[128, 0, 0]]]
    assert over(half_red, (1, 1, 1)).tolist() == [[[255, 128, 128]]]


@pytest.mark.parametrize("peak, factor", [(0.5, 2), (0.011, 50), (0.0, 1000), (3, 1)])
def test_amplification(peak, factor):
    assert amplification(np.full((4, 4), peak)) == factor


def test_difference_image():
    ours, truth = np.zeros((1, 1, 4)), np.array([[[0.01, 0.5, 0, 1]]])
    assert difference_image(ours, truth, 10).tolist() == [[[26, 255, 0]]]
