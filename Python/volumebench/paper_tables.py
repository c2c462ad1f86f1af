"""What a paper published beside what was measured here."""

from collections import Counter
from typing import Any

from .paper import FAILS, HOLDS, NOT_RUN, UNDECIDED, Verdict
from .paper import fastest, matches, merged
from .results import Record
from .summary import number
from .tables import Table

LEFT_OUT = "left out"


def paper_sentence(paper: dict[str, Any], found: list[Verdict]) -> str:
    """Return the sentence to quote."""
    counts = Counter(verdict.word for verdict in found)
    words = {
        HOLDS: ("holds", "hold"),
        FAILS: ("does not hold", "do not hold"),
        UNDECIDED: ("is undecided", "are undecided"),
        NOT_RUN: ("was not run", "were not run"),
    }
    parts = [
        f"{counts[word]} {one if counts[word] == 1 else several}"
        for word, (one, several) in words.items()
        if counts[word]
    ]
    return (
        f"Of {len(found)} conclusions of {paper['title']} ({paper['hardware']}), tested on this "
        f"machine: {', '.join(parts)}."
    )


def conclusion_table(found: list[Verdict]) -> Table:
    """Return each conclusion with the published and the measured figure."""
    rows = tuple(
        (verdict.word, verdict.text, verdict.published, verdict.measured)
        for verdict in found
    )
    header = ("verdict", "conclusion of the paper", "published", "measured here (95 %)")
    return Table("Conclusions", header, rows, len(header), marked=True)


def published_tables(paper: dict[str, Any], records: list[Record]) -> list[Table]:
    """Return the tables of the paper, each value with ours and the error of ours."""
    return [
        _table(item, paper["hardware"], records) for item in paper.get("tables", ())
    ]


def _table(item: dict[str, Any], hardware: str, records: list[Record]) -> Table:
    columns = item["columns"]
    groups = (("", 1), *((column["title"], 3) for column in columns))
    header = ("", *("paper", "here", "RMSE") * len(columns))
    rows = []
    for row in item["rows"]:
        cells = [row["title"]]
        for column, published in zip(columns, row["published"]):
            select = merged(row["select"], column["select"])
            cells += ["-" if published is None else f"{published:g}"]
            cells += _ours(records, select, item["unit"])
        rows.append(tuple(cells))
    title = f"{item['title']} ({item['unit']}; paper: {hardware})"
    return Table(title, header, tuple(rows), 1, groups)


def _ours(records: list[Record], select: dict[str, Any], unit: str) -> tuple[str, str]:
    """Return the value that is picked and its error, or why there is none."""
    record = fastest(records, select)
    if record is None:
        planned = any(matches(row, select) for row in records)
        return NOT_RUN if planned else LEFT_OUT, "-"
    value = record.fps if unit == "FPS" else record.frame_ms.median
    return number(value, ".4g"), number(record.error.rmse, ".1e")
