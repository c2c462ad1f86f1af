"""Finds the faults of what a study says of a paper, before anything is measured."""

from collections.abc import Iterator
from typing import Any

from .paper import matches, merged
from .results import Record, record_of
from .study import Study

_NEEDED = {
    "ratio": ("over", "under"),
    "change": ("over", "under", "from", "to"),
    "difference": ("over", "under", "at_most"),
    "crossover": ("over", "under"),
    "unmeasured": ("reason",),
}


def paper_faults(study: Study) -> Iterator[tuple[str, str]]:
    """Yield the key and the fault of each part that cannot be answered by a run of the study."""
    paper = study.paper
    if paper is None:
        return
    rows = [record_of(run, None, None) for run in study.runs()]
    for index, table in enumerate(paper.get("tables", ())):
        yield from _table_faults(f"tables[{index}]", table, rows)
    for index, conclusion in enumerate(paper["conclusions"]):
        yield from _conclusion_faults(f"conclusions[{index}]", conclusion, rows)


def _table_faults(
    place: str, table: dict[str, Any], rows: list[Record]
) -> Iterator[tuple[str, str]]:
    columns = table["columns"]
    for number, row in enumerate(table["rows"]):
        where = f"{place}.rows[{number}]"
        if len(row["published"]) != len(columns):
            yield where, f"{len(row['published'])} values for {len(columns)} columns"
            continue
        for column, value in zip(columns, row["published"]):
            select = merged(row["select"], column["select"])
            if value is not None and not _picks(select, rows):
                yield where, f"no run of the study is {_text(select)}"


def _conclusion_faults(
    place: str, conclusion: dict[str, Any], rows: list[Record]
) -> Iterator[tuple[str, str]]:
    kind = conclusion["kind"]
    for key in _NEEDED[kind]:
        if key not in conclusion:
            yield place, f'kind {kind} needs "{key}"'
            return
    bounds = {"at_least", "at_most"} & set(conclusion)
    if kind != "unmeasured" and not bounds:
        yield place, f'kind {kind} needs "at_least" or "at_most"'
    for side in ("over", "under"):
        for end in ("from", "to"):
            parts = [conclusion.get(key, {}) for key in ("where", end, side)]
            select = merged(*parts)
            if side in conclusion and not _picks(select, rows):
                yield f"{place}.{side}", f"no run of the study is {_text(select)}"


def _picks(select: dict[str, Any], rows: list[Record]) -> bool:
    return any(matches(row, select) for row in rows)


def _text(select: dict[str, Any]) -> str:
    return ", ".join(f"{name} {value}" for name, value in select.items())
