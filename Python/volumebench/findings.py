"""What opens the report of a study: its sentence, tables and figures, by the kind of its report."""

import csv
import io
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt

from .equal_error import equal_error_table
from .equal_error import sentence as equal_error_sentence
from .error_targets import target_table
from .json_file import write_atomically
from .paper import verdicts
from .paper_plot import paper_figures
from .paper_tables import conclusion_table, paper_sentence, published_tables
from .plot import FOLDER, save_figure
from .plot_style import STYLE
from .report_style import (
    HOW_EQUAL_ERROR_IS_READ,
    HOW_PAPERS_ARE_READ,
    HOW_SCALING_IS_READ,
    HOW_SPEED_IS_READ,
    HOW_SWEEPS_ARE_READ,
)
from .results import Record
from .scaling import remarks as scaling_remarks
from .scaling import sentence as scaling_sentence
from .scaling_plot import series_figures
from .scaling_tables import scaling_tables
from .speed import sentence as speed_sentence
from .speed_plot import ratio_figure
from .speed_tables import (
    edit_table,
    first_table,
    left_out_remarks,
    ratio_tables,
    saving_table,
    start_remarks,
)
from .start import StartRow
from .study import EQUAL_ERROR, SCALING, SPEED, Study
from .tables import Table, as_text
from .work_precision import sentence
from .work_precision_tables import doubt_sentence, sweep_remarks, sweep_tables


TABLE_FOLDER = "tables"


@dataclass(frozen=True)
class Findings:
    """Tables may be None where there is nothing to put in them; figures are file and title."""

    sentence: str
    tables: tuple[Table | None, ...]
    remarks: tuple[str | None, ...]
    how_to_read: str
    figures: tuple[tuple[str, str], ...] = ()
    tables_first: bool = False

    def given_tables(self) -> list[Table]:
        """Return the tables that have rows."""
        return [table for table in self.tables if table]

    def text(self) -> str:
        """Return sentence, tables and remarks for the terminal."""
        tables = [as_text(table) for table in self.given_tables()]
        return "\n".join([self.sentence, *tables, *filter(None, self.remarks)])


def findings_of(
    study: Study, records: list[Record], start_rows: list[StartRow], folder: Path
) -> Findings | None:
    """Return what the study tells, with its figures written; None of one without sweeps."""
    if study.paper is not None:
        return _paper(study, records, folder)
    if study.report == SPEED:
        return _speed(records, start_rows, folder)
    if study.report == SCALING:
        return _scaling(study, records, folder)
    if study.report == EQUAL_ERROR:
        return _equal_error(records)
    if study.sweeps:
        return sweep_findings(records)
    return None


def sweep_findings(records: list[Record]) -> Findings:
    """Return what sweeps of error against time tell."""
    tables = [*sweep_tables(records), target_table(records)]
    remarks = sweep_remarks(records)
    return Findings(
        sentence(records), tuple(tables), tuple(remarks), HOW_SWEEPS_ARE_READ
    )


def _speed(records: list[Record], start_rows: list[StartRow], folder: Path) -> Findings:
    tables = ratio_tables(records)
    tables += [saving_table(records), target_table(records)]
    tables += [first_table(start_rows), edit_table(start_rows)]
    remarks = [*start_remarks(start_rows), doubt_sentence(records)]
    remarks += left_out_remarks(records)
    title = "Frame-time ratio against ParaView's Volume"
    figures = _written(folder, {"speed.png": (title, lambda: ratio_figure(records))})
    return Findings(
        speed_sentence(records),
        tuple(tables),
        tuple(remarks),
        HOW_SPEED_IS_READ,
        figures,
    )


def _equal_error(records: list[Record]) -> Findings:
    return Findings(
        equal_error_sentence(records),
        (equal_error_table(records), saving_table(records)),
        (doubt_sentence(records),),
        HOW_EQUAL_ERROR_IS_READ,
    )


def _paper(study: Study, records: list[Record], folder: Path) -> Findings:
    found = verdicts(study.paper, records)
    tables = [conclusion_table(found), *published_tables(study.paper, records)]
    return Findings(
        paper_sentence(study.paper, found),
        tuple(tables),
        study.notes,
        HOW_PAPERS_ARE_READ,
        _written(folder, paper_figures(study, records)),
        tables_first=True,
    )


def _scaling(study: Study, records: list[Record], folder: Path) -> Findings:
    return Findings(
        scaling_sentence(study, records),
        tuple(scaling_tables(study, records)),
        tuple(scaling_remarks(study, records)),
        HOW_SCALING_IS_READ,
        _written(folder, series_figures(study, records)),
    )


def write_tables(folder: Path, findings: Findings) -> None:
    """Write each table as CSV."""
    target = folder / TABLE_FOLDER
    target.mkdir(exist_ok=True)
    for table in findings.given_tables():
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerows([table.full_header(), *table.rows])
        stem = re.sub(r"[^a-z0-9]+", "-", table.title.lower()).strip("-")[:60]
        write_atomically(target / f"{stem}.csv", stream.getvalue())


def _written(
    folder: Path, figures: dict[str, tuple[str, Callable[[], Any | None]]]
) -> tuple[tuple[str, str], ...]:
    """Write the figures that have something to show; return file and title of each."""
    written = []
    for name, (title, make) in figures.items():
        with plt.rc_context(STYLE):
            figure = make()
            if figure is not None:
                save_figure(figure, folder / FOLDER / name)
                written.append((name, title))
    return tuple(written)
