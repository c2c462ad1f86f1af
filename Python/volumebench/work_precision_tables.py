"""The tables and sentences of a sweep, for the terminal and for the report."""

from .results import Record
from .summary import number, sampling_text, scenes_of
from .tables import Table
from .techniques import PARAVIEW, TECHNIQUES
from .work_precision import (
    DOUBT_FACTOR,
    LEVELS,
    VTK_GPU,
    EqualError,
    Order,
    SampleRatio,
    equal_errors,
    is_doubtful,
    orders,
    points_of,
    sample_ratios,
    samples_verdict,
)

NOT_REACHED = "not reached"
FLAT = "the step hardly matters any more: tables, rounding or the reference do"
STOPPING = "rays stop early: what they leave out does not depend on the step"
KINKS = (
    "kinks: trilinear data bend at every cell face, and the functions at their points"
)


def speed_up_table(records: list[Record], peer: str) -> Table | None:
    """Return the speed-ups over a peer at equal error: a row for each scene."""
    found = equal_errors(records, peer)
    if not found:
        return None
    rows = []
    for scene in dict.fromkeys(item.scene for item in found):
        inside = [item for item in found if item.scene == scene]
        own = next((item for item in inside if item.at_peers_error), None)
        levels = {item.rmse: item for item in inside if not item.at_peers_error}
        rows.append(
            (
                scene.title(),
                *(_factor(levels.get(level)) for level in LEVELS),
                number(own.rmse if own else None, ".1e"),
                number(own.ours_ms if own else None, ".1f"),
                number(own.peer_ms if own else None, ".1f"),
                _factor(own),
            )
        )
    title = f"Speed-up over {TECHNIQUES[peer].title} at equal error (RMSE)"
    header = ("scene", *(f"at {level:g}" for level in LEVELS), "ParaView's error")
    header += ("our ms there", "peer's ms there", "at ParaView's error")
    return Table(title, header, tuple(rows), 1)


def _factor(item: EqualError | None) -> str:
    if item is None:
        return "-"
    factor = item.speed_up()
    if factor is None:
        lacking = "ours" if item.ours_ms is None else "peer"
        return f"{NOT_REACHED} ({lacking})"
    return f"{'at least ' if item.ours_is_bound else ''}{factor:.1f}x"


def order_table(records: list[Record]) -> Table | None:
    """Return the measured order of convergence of each integrator in each scene."""
    rows = tuple(_order_row(item) for item in orders(records))
    header = ("scene", "technique", "integrator", "cause, where it is low", "steps")
    header += ("order", "for smooth data")
    title = "Order of convergence"
    return Table(title, header, rows, 5) if rows else None


def _order_row(item: Order) -> tuple[str, ...]:
    return (
        item.scene.title(),
        TECHNIQUES[item.technique].title,
        item.integrator,
        _cause(item) if item.is_low() else "",
        f"{max(item.steps):g} to {min(item.steps):g}",
        f"{item.order:.2f}",
        str(item.expected()),
    )


def _cause(item: Order) -> str:
    if item.stopping:
        return STOPPING
    return FLAT if item.is_flat() else KINKS


def sample_table(records: list[Record]) -> Table | None:
    """Return our samples beside ParaView's at its own error."""
    rows = tuple(_sample_row(item) for item in sample_ratios(records))
    header = ("scene", "our cheapest run", "our RMSE", "ParaView's RMSE")
    header += ("our Msamples", "ParaView's Msamples", "ratio")
    title = "Samples at ParaView's own error"
    return Table(title, header, rows, 2) if rows else None


def _sample_row(item: SampleRatio) -> tuple[str, ...]:
    ours = item.ours
    return (
        item.scene.title(),
        sampling_text(ours) if ours else NOT_REACHED,
        number(ours.error.rmse if ours else None, ".1e"),
        number(item.paraview.error.rmse, ".1e"),
        number(ours.samples_taken / 1e6 if ours else None, ".3f"),
        number(item.paraview.samples_taken / 1e6, ".3f"),
        number(item.ratio(), ".2f"),
    )


def doubt_sentence(records: list[Record]) -> str | None:
    """Return how many points are grey, and why; None if none is."""
    points = points_of(records)
    doubtful = [point.record for point in points if is_doubtful(point.record)]
    if not doubtful:
        return None
    scenes = ", ".join(scene.title() for scene in scenes_of(doubtful))
    return (
        f"{len(doubtful)} of {len(points)} points are grey: their error is less than "
        f"{DOUBT_FACTOR:g} times the uncertainty of the reference ({scenes})."
    )


def sweep_tables(records: list[Record]) -> list[Table]:
    """Return all tables of a sweep that have rows."""
    tables = [speed_up_table(records, peer) for peer in (PARAVIEW, VTK_GPU)]
    tables += [sample_table(records), order_table(records)]
    return [table for table in tables if table]


def sweep_remarks(records: list[Record]) -> list[str]:
    """Return the sentences that go with the tables."""
    verdict = samples_verdict(sample_ratios(records))
    return [text for text in (verdict, doubt_sentence(records)) if text]
