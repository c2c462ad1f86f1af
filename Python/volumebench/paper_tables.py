"""What a paper published beside what was measured here."""

from collections import Counter
from typing import Any

from .paper import FAILS, HOLDS, NOT_RUN, UNDECIDED, Verdict, fastest, merged
from .results import Record
from .tables import Table


def paper_sentence(paper: dict[str, Any], found: list[Verdict]) -> str:
    """Return the sentence to quote."""
    counts = Counter(verdict.word for verdict in found)
    words = {HOLDS: "hold", FAILS: "do not hold", UNDECIDED: "are undecided"}
    words[NOT_RUN] = "were not run"
    parts = [f"{counts[word]} {text}" for word, text in words.items()]
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
    return Table("Conclusions", header, rows, len(header))


def published_tables(paper: dict[str, Any], records: list[Record]) -> list[Table]:
    """Return the tables of the paper, each value with ours and ours over theirs."""
    return [
        _table(item, paper["hardware"], records) for item in paper.get("tables", ())
    ]


def _table(item: dict[str, Any], hardware: str, records: list[Record]) -> Table:
    columns = item["columns"]
    header = ["row"]
    for column in columns:
        header += [f"{column['title']}: paper", "here"]
    rows = []
    for row in item["rows"]:
        cells = [row["title"]]
        for column, published in zip(columns, row["published"]):
            record = fastest(records, merged(row["select"], column["select"]))
            cells += ["-" if published is None else f"{published:g}"]
            cells += [_text(_value(record, item["unit"]))]
        rows.append(tuple(cells))
    title = f"{item['title']} ({item['unit']}; paper: {hardware})"
    return Table(title, tuple(header), tuple(rows), 1)


def _value(record: Record | None, unit: str) -> float | None:
    if record is None:
        return None
    return record.fps if unit == "FPS" else record.frame_ms.median


def _text(value: float | None) -> str:
    return "not run" if value is None else f"{value:.4g}"
