"""stability.html: every case with every technique as a heat map, and the sentences behind it."""

import math
from html import escape
from itertools import groupby
from pathlib import Path

from .json_file import write_atomically
from .page import head, page
from .results import Context
from .stability import (
    FAIL,
    NOT_APPLICABLE,
    PASS,
    UNSUPPORTED,
    Case,
    Outcome,
    Row,
    column_title,
)
from .stability_colors import color_of
from .stability_study import StabilityStudy
from .techniques import TECHNIQUES

FILE = "stability.html"
FIRST_OWN_CASE = 33  # those before are the list that the project set out with
MARKS = {PASS: "✓", FAIL: "✗", NOT_APPLICABLE: "–", UNSUPPORTED: "∅"}
_STYLE = """
body { max-width: none; }
table.map { width: auto; border-collapse: separate; border-spacing: 2px; font-size: 12px; }
table.map th, table.map td { border: 0; padding: 2px 4px; text-align: center; }
table.map th.case { text-align: left; white-space: nowrap; font-weight: 400; color: #1f2430; }
table.map th.group { border-bottom: 2px solid #9aa0ab; color: #1f2430; }
table.map td { min-width: 38px; border-radius: 3px; font-variant-numeric: tabular-nums;
  white-space: nowrap; cursor: help; }
table.map td.meant { outline: 1.5px solid #3a3f4a; font-weight: 600; }
table.map td.defect { outline: 3px solid #a50026; }
li.defect b { color: #a50026; }
"""
_HOW_TO_READ = """
<p>Each case draws a scene whose true picture is known from a formula or an integral in double
precision, and measures how far the drawn one is from it. The number is
log<sub>10</sub>(error / limit): 0 is at the limit, -2 a hundred times below it, +2 a hundred times
beyond, -&infin; no difference at all. Blue is within the limit, orange beyond, deeper further away.</p>
<p>&#10003; passes, &#10007; fails, &#8211; does not apply, &#8709; is not supported. <b>Framed</b>
cells are what the case is meant for: there a failure is a defect, and has a thick red frame. The
others, with their mark in brackets, are <b>controls</b>: first-order sampling and VTK's own mappers
are shown to tell what the case is hard about, and may fail. Point at a cell for what was
measured.</p>
"""


def write_stability_report(
    folder: Path, study: StabilityStudy, context: Context, outcome: Outcome
) -> None:
    """Write stability.html with everything inlined."""
    body = "\n".join(
        [
            head(study.name, study.description, context),
            _defects(outcome),
            f"<section><h2>Cases and techniques</h2>{_HOW_TO_READ}"
            f'<div class="wide">{_map(outcome)}</div></section>',
            f"<section><h2>What was measured</h2>{_details(outcome)}</section>",
        ]
    )
    title = f"VolumeBench: {study.name}"
    write_atomically(folder / FILE, page(title, body, _STYLE))


def _defects(outcome: Outcome) -> str:
    titles = {case.number: case.title for case in outcome.cases}
    items = "".join(
        f'<li class="defect"><b>Case {row.case}, {escape(titles[row.case])}</b>, '
        f"{escape(column_title(row.column()))}: {escape(row.reason)}</li>"
        for row in outcome.defects()
    )
    meant = [row for row in outcome.rows if row.meant and row.status in (PASS, FAIL)]
    passed = sum(row.status == PASS for row in meant)
    text = f"<p>{passed} of {len(meant)} cells that a case is meant for pass.</p>"
    return f"<section><h2>Result</h2>{text}<ul>{items}</ul></section>"


def _map(outcome: Outcome) -> str:
    columns = outcome.columns()
    groups = "".join(
        f'<th class="group" colspan="{len(list(members))}">'
        f"{escape(TECHNIQUES[technique].title)}</th>"
        for technique, members in groupby(columns, key=lambda column: column[0])
    )
    heads = "".join(f"<th>{escape(integrator or '')}</th>" for _, integrator in columns)
    lines = []
    for case in outcome.cases:
        cells = "".join(_cell(outcome.row(case.number, column)) for column in columns)
        lines.append(f"<tr>{_case_head(case)}{cells}</tr>")
    return (
        f'<table class="map"><thead><tr><th></th>{groups}</tr><tr><th></th>{heads}</tr>'
        f"</thead><tbody>{''.join(lines)}</tbody></table>"
    )


def _case_head(case: Case) -> str:
    own = " *" if case.number >= FIRST_OWN_CASE else ""
    return (
        f'<th class="case" title="{escape(case.expectation)}">'
        f"{case.number}{own} {escape(case.title)}</th>"
    )


def _cell(row: Row | None) -> str:
    if row is None:
        return "<td></td>"
    kind = "meant" if row.meant else "control"
    if row.meant and row.status == FAIL:
        kind += " defect"
    hover = escape(f"{column_title(row.column())}: {row.status}. {row.reason}")
    return (
        f'<td class="{kind}" style="background:{color_of(row.ratio_log10())}" '
        f'title="{hover}">{escape(cell_text(row))}</td>'
    )


def cell_text(row: Row) -> str:
    """Return the mark and the number of a cell: "✓ -1.3", a control's mark in brackets."""
    mark = MARKS[row.status] if row.meant else f"({MARKS[row.status]})"
    ratio = row.ratio_log10()
    if ratio is None:
        return mark
    if math.isinf(ratio):
        return f"{mark} {'-∞' if ratio < 0 else 'NaN'}"
    return f"{mark} {round(ratio, 1) or 0.0:+.1f}"


def _details(outcome: Outcome) -> str:
    parts = []
    for case in outcome.cases:
        rows = [row for row in outcome.rows if row.case == case.number]
        items = "".join(
            f"<li>{MARKS[row.status]} <b>{escape(column_title(row.column()))}</b>"
            f"{'' if row.meant else ' (control)'}: {escape(row.reason)}</li>"
            for row in rows
        )
        parts.append(
            f"<details><summary>{case.number} {escape(case.title)}</summary>"
            f"<p>Expected: {escape(case.expectation)}.</p><ul>{items}</ul></details>"
        )
    note = f"<p><small>* cases from {FIRST_OWN_CASE} on are our own</small></p>"
    return note + "".join(parts)
