"""Power laws through points worked out by hand."""

import math

import pytest
from volumebench.fits import power_law


def test_an_exact_power_is_found_without_doubt():
    fit = power_law([(x, 3 * x**2.5) for x in (1, 2, 4, 8)])
    assert fit.exponent == pytest.approx(2.5)
    assert fit.factor == pytest.approx(3)
    assert fit.half_width == pytest.approx(0, abs=1e-9)
    assert fit.at(16) == pytest.approx(3 * 16**2.5)


def test_the_interval_is_that_of_a_regression():
    """Logarithms (0, 0), (1, 2), (2, 2): slope 1, residuals -1/3, 2/3, -1/3, one degree of freedom.

    The squares are 2/3, those of x about their mean 2: t * sqrt(1/3).
    """
    points = [(math.exp(x), math.exp(y)) for x, y in ((0, 0), (1, 2), (2, 2))]
    fit = power_law(points)
    assert fit.exponent == pytest.approx(1)
    assert fit.factor == pytest.approx(math.exp(1 / 3))
    assert fit.half_width == pytest.approx(12.706 * math.sqrt(1 / 3))


def test_students_t_follows_the_number_of_points():
    """Residuals +-e about a slope of 1 at x = 0 ... n - 1, whose pattern leaves slope and mean."""
    e = 0.1
    x = [0, 1, 2, 3]
    residuals = [e, -e, -e, e]
    points = [(math.exp(a), math.exp(a + r)) for a, r in zip(x, residuals)]
    fit = power_law(points)
    assert fit.exponent == pytest.approx(1)
    assert fit.half_width == pytest.approx(4.303 * math.sqrt(4 * e**2 / 2 / 5))


def test_two_points_have_no_interval_and_one_has_no_line():
    fit = power_law([(2, 5), (4, 10)])
    assert fit.exponent == pytest.approx(1) and fit.half_width is None
    assert power_law([(2, 5)]) is None
    assert power_law([(2, 5), (2, 6)]) is None
    assert power_law([]) is None
