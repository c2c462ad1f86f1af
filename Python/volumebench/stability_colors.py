"""The colours of the stability heat map: blue within the limit, orange beyond it."""

# Near and far from the limit: orange and blue can be told apart with any colour vision, and dark
# text can be read on all of them.
_PASSED = ((226, 238, 247), (120, 172, 212))
_FAILED = ((253, 225, 190), (233, 124, 48))
_DECADES = 4.0  # beyond so many decades from the limit the colour stays the same
BLANK = "#eeeff2"


def color_of(ratio_log10: float | None) -> str:
    """Return the colour for log10(error / limit); None is what was not measured."""
    if ratio_log10 is None:
        return BLANK
    passed = ratio_log10 <= 0
    near, far = _PASSED if passed else _FAILED
    share = min(abs(ratio_log10) / _DECADES, 1.0)
    mixed = (round(a + share * (b - a)) for a, b in zip(near, far))
    return "#" + "".join(f"{value:02x}" for value in mixed)
