"""The tables of a scaling study: exponents, and the numbers that they are fitted to."""

from .results import Record
from .scaling import SYMBOLS, Growth, growths
from .study import Series, Study
from .tables import Table
from .techniques import TECHNIQUES


def scaling_tables(study: Study, records: list[Record]) -> list[Table]:
    """Return the table of all exponents, and one of numbers for each series."""
    found = growths(study, records)
    rows = tuple(map(_exponent_row, found))
    header = ("series", "technique", "quantity", "grows with", "points", "exponent")
    tables = [Table("Exponents of growth (95 % interval)", header, rows, 4)]
    tables += [_numbers(series, found) for series in study.series]
    return [table for table in tables if table.rows]


def _exponent_row(item: Growth) -> tuple[str, ...]:
    return (
        item.series.title,
        TECHNIQUES[item.technique].title,
        item.quantity,
        SYMBOLS[item.series.factor],
        str(len(item.points)),
        item.exponent_text(),
    )


def _numbers(series: Series, found: list[Growth]) -> Table:
    """Return a row for each technique and quantity, a column for each place of the series."""
    inside = [item for item in found if item.series == series]
    places = sorted({x for item in inside for x, _ in item.points})
    rows = []
    for item in inside:
        values = dict(item.points)
        cells = (f"{values[x]:.4g}" if x in values else "-" for x in places)
        rows.append((TECHNIQUES[item.technique].title, item.quantity, *cells))
    header = ("technique", "quantity", *(f"{x:.4g}" for x in places))
    return Table(f"{series.title}, by {SYMBOLS[series.factor]}", header, tuple(rows), 2)
