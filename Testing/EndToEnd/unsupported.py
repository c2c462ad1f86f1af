"""A technique that this machine may not be able to run: it says so in one line, and others draw."""

from paraview import simple
from support import (
    ERRORS,
    LABEL,
    capture,
    check_not_empty,
    color_by,
    look,
    new_view,
    run_checks,
    show,
    wavelet,
    why_not_here,
)

MISSING = True  # these checks are for machines that cannot run it, too


def check_says_in_one_line_why_it_draws_nothing() -> None:
    reason = why_not_here(LABEL)
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    look(view)
    for _ in range(3):
        simple.Render(view)
    said = [text for text in ERRORS.take() if "Volume not drawn" in text]
    if not reason:
        assert not said, said
        check_not_empty(capture(view), LABEL)
        return
    print(f"  {reason}")
    assert len(said) == 1, f"said {len(said)} times: {said}"
    line = said[0].splitlines()[-1]
    assert "cannot run here: " in line and len(line) < 300, line


def check_others_draw_after_it() -> None:
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    look(view)
    simple.Render(view)
    ERRORS.take()
    display.SetRepresentationType("Volume Single Pass")
    check_not_empty(capture(view), LABEL)
    assert not ERRORS.take()


if __name__ == "__main__":
    run_checks(dict(globals()))
