"""What stability cases made of each technique, and its file stability.json."""

import json
import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from .json_file import write_atomically
from .results import Context

SCHEMA = 1
FILE = "stability.json"
PASS = "pass"
FAIL = "fail"
NOT_APPLICABLE = "not-applicable"
UNSUPPORTED = "unsupported"


@dataclass(frozen=True)
class Case:
    """A numbered case: 1 to 32 are the list that the project set out with."""

    number: int
    title: str
    expectation: str
    limit: float


@dataclass(frozen=True)
class Row:
    """One case with one technique and integrator; a peer has no integrator.

    `meant` tells whether a failure is a defect: the others are controls. `error` is the worst
    measurement against its own limit, null when nothing was measured or it is no number.
    """

    case: int
    technique: str
    integrator: str | None
    meant: bool
    status: str
    error: float | None
    limit: float | None
    reason: str

    def ratio_log10(self) -> float | None:
        """Return log10(error / limit): above 0 beyond the limit, -inf without any error."""
        if self.limit is None:
            return None
        if self.error is None:
            return math.inf
        return math.log10(self.error / self.limit) if self.error > 0 else -math.inf

    def column(self) -> tuple[str, str | None]:
        """Return what one column of the heat map holds."""
        return (self.technique, self.integrator)


@dataclass(frozen=True)
class Outcome:
    """All rows of a stability study."""

    cases: tuple[Case, ...]
    rows: tuple[Row, ...]

    def columns(self) -> list[tuple[str, str | None]]:
        """Return technique and integrator of all columns, in the order of the rows."""
        return list(dict.fromkeys(row.column() for row in self.rows))

    def row(self, case: int, column: tuple[str, str | None]) -> Row | None:
        """Return the row of a cell."""
        found = [row for row in self.rows if row.case == case]
        return next((row for row in found if row.column() == column), None)

    def defects(self) -> list[Row]:
        """Return the rows that failed though they are meant to pass."""
        return [row for row in self.rows if row.meant and row.status == FAIL]


def outcome_of(table_rows: list[dict[str, Any]]) -> Outcome:
    """Return the outcome that the rows of the source's table tell."""
    cases = {
        int(row["case"]): Case(
            int(row["case"]), row["title"], row["expectation"], row["case_limit"]
        )
        for row in table_rows
    }
    rows = tuple(
        Row(
            case=int(row["case"]),
            technique=row["technique"],
            integrator=row["integrator"] or None,
            meant=bool(row["meant"]),
            status=row["status"],
            error=_finite(row["error"]),
            limit=_finite(row["limit"]),
            reason=row["reason"],
        )
        for row in table_rows
    )
    return Outcome(tuple(cases.values()), rows)


def _finite(number: float) -> float | None:
    return number if math.isfinite(number) else None


def write_outcome(folder: Path, context: Context, outcome: Outcome) -> None:
    """Write stability.json."""
    document = {
        "schema": SCHEMA,
        "context": asdict(context),
        "cases": [asdict(case) for case in outcome.cases],
        "rows": [asdict(row) for row in outcome.rows],
    }
    text = json.dumps(document, indent=1, allow_nan=False)
    write_atomically(folder / FILE, text + "\n")


def summary_lines(outcome: Outcome) -> list[str]:
    """Return a line for each column with what it passed, then one for each defect."""
    lines = []
    for column in outcome.columns():
        rows = [row for row in outcome.rows if row.column() == column]
        counts = {
            status: sum(row.status == status for row in rows)
            for status in (PASS, FAIL, NOT_APPLICABLE, UNSUPPORTED)
        }
        meant = [row for row in rows if row.meant and row.status in (PASS, FAIL)]
        passed = sum(row.status == PASS for row in meant)
        told = ", ".join(f"{counts[status]} {status}" for status in counts)
        of_meant = f"; of {len(meant)} meant for, {passed} pass" if meant else ""
        lines.append(f"{column_title(column):<32} {told}{of_meant}")
    titles = {case.number: case.title for case in outcome.cases}
    for row in outcome.defects():
        lines.append(
            f"fails case {row.case} ({titles[row.case]}): {column_title(row.column())}: "
            f"{row.reason}"
        )
    return lines


def column_title(column: tuple[str, str | None]) -> str:
    """Return technique and integrator as one text."""
    technique, integrator = column
    return f"{technique} {integrator}" if integrator else technique
