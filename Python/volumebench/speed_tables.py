"""The tables of a speed study: ratios at equal error, what skipping saves, first pictures, edits."""

from .results import Record
from .speed import LEVEL, Ratio, Saving, ratios, savings
from .start import StartRow
from .statistics import Spread
from .summary import number, sampling_text
from .tables import Table
from .techniques import PARAVIEW, TECHNIQUES
from .work_precision import geometric_mean

MEGA = 1e6
NOT_REACHED = "not reached"


def ratio_tables(records: list[Record]) -> list[Table]:
    """Return the ratios at ParaView's own error and at the level."""
    titles = (
        (None, "At ParaView's own error"),
        (LEVEL, f"At an RMSE of {LEVEL:g}, or ParaView's own where that is smaller"),
    )
    found = [(title, ratios(records, level)) for level, title in titles]
    return [_ratio_table(title, items) for title, items in found if items]


def _ratio_table(title: str, items: list[Ratio]) -> Table:
    header = ("scene", "our variant", "RMSE", "ParaView's ms", "our ms")
    header += ("ParaView's Msamples", "our Msamples", "ratio", "95 % interval")
    return Table(title, header, tuple(map(_ratio_row, items)), 2)


def _ratio_row(item: Ratio) -> tuple[str, ...]:
    ours, theirs = item.ours, item.paraview
    least = "at least " if ours and ours.is_bound else ""
    interval = item.interval()
    return (
        item.scene.title() + (" (stand-in)" if theirs.stand_in_for else ""),
        ours.variant() if ours else NOT_REACHED,
        number(item.rmse, ".1e"),
        number(theirs.frame_ms.median, ".1f"),
        number(ours.ms if ours else None, ".1f"),
        mega(theirs.samples_taken),
        mega(ours.samples if ours else None),
        least + number(item.factor(), ".1f"),
        "{:.1f} to {:.1f}".format(*interval) if interval else "-",
    )


def left_out_remarks(records: list[Record]) -> list[str]:
    """Return what our variants at ParaView's own error leave out, once for all that leave out the same."""
    scenes: dict[tuple[str, ...], list[str]] = {}
    for item in ratios(records):
        if item.ours and item.ours.record.left_out:
            title = f"{item.scene.dataset}, {item.scene.transfer_function}"
            scenes.setdefault(item.ours.record.left_out, []).append(title)
    return [
        f"Left out, since the scene does not need it: {', '.join(names)} ({'; '.join(where)})."
        for names, where in scenes.items()
    ]


def mega(count: float | None) -> str:
    return number(None if count is None else count / MEGA, ".2f")


def saving_table(records: list[Record]) -> Table | None:
    """Return what skipping saves in each pair of runs."""
    rows = tuple(map(_saving_row, savings(records)))
    header = ("scene", "technique", "sampling", "ms", "ms without", "Msamples")
    header += ("Msamples without", "skipped", "time without skipping")
    title = "What skipping empty space saves"
    return Table(title, header, rows, 3) if rows else None


def _saving_row(item: Saving) -> tuple[str, ...]:
    with_it, off = item.skipping, item.off
    return (
        with_it.run().scene.title(),
        TECHNIQUES[with_it.technique].title,
        sampling_text(with_it),
        number(with_it.frame_ms.median, ".1f"),
        number(off.frame_ms.median, ".1f"),
        mega(with_it.samples_taken),
        mega(off.samples_taken),
        mega(with_it.samples_skipped),
        f"{item.factor():.2f}x",
    )


def first_table(rows: list[StartRow]) -> Table | None:
    """Return how long the first picture of each volume takes, and what it leaves on the device."""
    cells = []
    for row in rows:
        setup = row.setup_ms
        peer = _of_paraview(rows, row)
        factor = _over(peer.first_ms if peer else None, row.first_ms)
        cells.append(
            (
                _volume(row),
                TECHNIQUES[row.technique].title,
                row.reason or "",
                _quartiles(row.first_ms),
                number(row.show_ms.median, ".0f"),
                *(
                    number(value, ".1f")
                    for value in (setup.upload, setup.tables, setup.grid, setup.compile)
                ),
                number(factor, ".2f"),
                mega(row.bytes_on_device),
                number(_bytes_ratio(row), ".2f"),
            )
        )
    header = ("volume", "technique", "reason", "first picture, ms (quartiles)")
    header += ("of it the display, ms",)
    header += (
        "upload ms",
        "tables ms",
        "grid ms",
        "compile ms",
        "ParaView's over ours",
    )
    header += ("MB on the device", "over the volume's bytes")
    title = "First picture of a volume in memory"
    return Table(title, header, tuple(cells), 3) if cells else None


def edit_table(rows: list[StartRow]) -> Table | None:
    """Return how long the picture after an edit of the transfer function takes."""
    cells = []
    for row in rows:
        if not row.edit_ms.median:
            continue
        peer = _of_paraview(rows, row)
        share = None
        set_up = edit_set_up(row)
        if set_up is not None:
            share = 100 * set_up / row.edit_ms.median
        cells.append(
            (
                _volume(row),
                TECHNIQUES[row.technique].title,
                _quartiles(row.still_ms),
                _quartiles(row.edit_ms),
                number(row.edit_setup_ms.tables, ".1f"),
                number(row.edit_setup_ms.grid, ".1f"),
                number(share, ".1f", " %"),
                number(_over(peer.edit_ms if peer else None, row.edit_ms), ".2f"),
            )
        )
    header = ("volume", "technique", "still picture, ms", "after an edit, ms")
    header += ("tables ms", "grid ms", "set-up share", "ParaView's over ours")
    title = "Picture after an edit of the transfer function"
    return Table(title, header, tuple(cells), 2) if cells else None


def edit_set_up(row: StartRow) -> float | None:
    """Return the milliseconds of tables and grid after an edit; None of a peer."""
    parts = [row.edit_setup_ms.tables, row.edit_setup_ms.grid]
    known = [part for part in parts if part is not None]
    return sum(known) if known else None


def start_remarks(rows: list[StartRow]) -> list[str]:
    """Return how the first pictures and those after edits compare, in a sentence each."""
    found = []
    for name, words in (
        ("first_ms", "first picture of a volume in memory"),
        ("edit_ms", "picture after an edit of the transfer function"),
    ):
        factors = []
        for row in rows:
            peer = _of_paraview(rows, row)
            factor = _over(getattr(peer, name) if peer else None, getattr(row, name))
            if factor and row.technique != PARAVIEW:
                factors.append(factor)
        if factors:
            found.append(
                f"The {words} comes {geometric_mean(factors):.1f} times as fast as "
                f"ParaView's ({min(factors):.1f} to {max(factors):.1f} over {len(factors)} rows)."
            )
    return found


def _bytes_ratio(row: StartRow) -> float | None:
    known = row.bytes_on_device and row.volume_bytes
    return row.bytes_on_device / row.volume_bytes if known else None


def _of_paraview(rows: list[StartRow], row: StartRow) -> StartRow | None:
    for other in rows:
        if other.dataset == row.dataset and other.technique == PARAVIEW:
            return other
    return None


def _over(theirs: Spread | None, ours: Spread) -> float | None:
    known = theirs and theirs.median and ours.median
    return theirs.median / ours.median if known else None


def _volume(row: StartRow) -> str:
    size = " x ".join(str(count) for count in row.dims)
    return f"{row.dataset}, {size} {row.scalar_type}"


def _quartiles(times: Spread) -> str:
    if times.median is None:
        return "-"
    return f"{times.median:.0f} ({times.q1:.0f} to {times.q3:.0f})"
