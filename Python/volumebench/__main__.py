"""Command line of the package: reads a study, measures it, writes results, plots and a report."""

import argparse
import signal
import sys
from pathlib import Path

from .calibration import ceiling_table, load_calibration
from .compare import change_tables, compare_files, summary_of
from .compare_output import write_comparison
from .datasets import fitting_memory, free_memory_gb, with_stand_ins
from .errors import BenchError
from .findings import findings_of, write_tables
from .json_file import make_writable_folder
from .plot import write_plots
from .plugin_file import find_plugin
from .progress import Progress
from .report import write_report
from .results import FAILED, Record
from .runner import Runner, find_inputs, prepare_folder
from .stability import FAIL, outcome_of, summary_lines, write_outcome
from .stability_plot import write_stability_plot
from .stability_report import FILE as REPORT_FILE
from .stability_report import write_stability_report
from .stability_study import is_stability_study, load_stability_study
from .study import SCALING, Study
from .study_cuts import of_datasets, with_frames
from .study_file import find_study, load_study
from .summary import unfinished
from .tables import as_text, text_tables
from .worker import HANG_LIMIT_S, WorkerSession


_NOT_OF_STABILITY = ("data", "datasets", "frames", "resume", "calibration")


class _Parser(argparse.ArgumentParser):
    """Tells a wrong command line in one line, as all bad input is told."""

    def error(self, message: str) -> None:
        raise BenchError(f"command line: {message} (--help lists the options)")


def parse(arguments: list[str] | None) -> argparse.Namespace:
    """Return the options of the command line."""
    parser = _Parser(
        prog="bench",
        description="Measure image error against run time of volume rendering techniques.",
    )
    add = parser.add_argument
    add(
        "study",
        metavar="STUDY",
        nargs="?",
        help="a file, or a name under Python/Studies",
    )
    add(
        "--quick",
        action="store_true",
        help="what the study calls quick, or its extremes",
    )
    add("--out", type=Path, metavar="DIR", help="default: Results/NAME")
    add("--data", type=Path, metavar="DIR", help="folder with more volumes")
    add("--techniques", metavar="A,B", help="these techniques in place of the study's")
    add("--datasets", metavar="A,B", help="these volumes of the study alone")
    add(
        "--frames",
        type=_frames,
        metavar="N",
        help="one turn of so many frames a run, in place of what the study asks for",
    )
    add(
        "--compare",
        nargs=2,
        type=Path,
        metavar=("OLD", "NEW"),
        help="measure nothing: tell what changed between two results.json; exit code 1 says "
        "that something became worse beyond noise",
    )
    add("--resume", action="store_true", help="keep the rows of an earlier run")
    add(
        "--calibration",
        type=Path,
        metavar="FILE",
        help="ceilings of this machine, from ./run calibrate",
    )
    add(
        "--hang-limit",
        type=_seconds,
        default=HANG_LIMIT_S,
        metavar="SECONDS",
        help="a run that gives no sign of life for so long is given up (default: %(default)g)",
    )
    add("--plugin", metavar="FILE", help="the plugin, if not the one built here")
    options = parser.parse_args(arguments)
    if (options.study is None) == (options.compare is None):
        parser.error("give either STUDY or --compare OLD NEW")
    return options


def _seconds(text: str) -> float:
    value = float(text)
    if not 1 <= value <= 86400:
        raise argparse.ArgumentTypeError(f"{text} is not from 1 to 86400 seconds")
    return value


def _frames(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 1000000:
        raise argparse.ArgumentTypeError(f"{text} is not a number of frames")
    return int(text)


def study_of(options: argparse.Namespace) -> Study:
    """Return the study after the cuts of the command line, on the volumes that are here."""
    study = load_study(find_study(options.study))
    if options.techniques is not None:
        study = study.only(_names(options.techniques))
    if options.data is not None and not options.data.is_dir():
        raise BenchError(f"--data {options.data}: no such folder")
    study = study.quick() if options.quick else study
    if options.datasets is not None:
        study = of_datasets(study, _names(options.datasets))
    if options.frames is not None:
        study = with_frames(study, options.frames)
    study = with_stand_ins(study, options.data)
    return fitting_memory(study, free_memory_gb())


def _names(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]


def folder_of(options: argparse.Namespace, name: str) -> Path:
    """Return where the results of a study go."""
    suffix = "-quick" if options.quick else ""
    return options.out or Path("Results") / f"{name}{suffix}"


def run_comparison(options: argparse.Namespace) -> int:
    """Tell what changed between two results; return the exit code."""
    old, new = options.compare
    comparison = compare_files(old, new)
    folder = options.out or new.parent / "compare"
    write_comparison(folder, comparison, f"{new} against {old}")
    print("\n".join(summary_of(comparison)))
    for table in change_tables(comparison):
        print(as_text(table))
    print(folder / "compare.html")
    return 1 if comparison.is_regression() else 0


def run(options: argparse.Namespace) -> int:
    """Measure the study and write everything; return the exit code."""
    if options.compare is not None:
        return run_comparison(options)
    if is_stability_study(find_study(options.study)):
        return try_stability(options)
    study = study_of(options)
    calibration = options.calibration and load_calibration(options.calibration)
    folder = folder_of(options, study.name)
    earlier = prepare_folder(study, folder, options.resume)
    inputs = find_inputs(study, options.data, folder / "volumes")
    runner = Runner(study, inputs, folder, earlier, calibration)
    records = runner.records
    if not runner.is_complete():
        interrupted = measure(study, runner, options)
        records = runner.records
        if interrupted and not records:
            raise KeyboardInterrupt
    else:
        interrupted = False
        runner.renew_calibration()
    write_views(study, folder, runner, records)
    if interrupted:
        raise KeyboardInterrupt
    return 1 if all(record.status == FAILED for record in records) else 0


def measure(study: Study, runner: Runner, options: argparse.Namespace) -> bool:
    """Measure what is missing in a process of its own; tell whether that was interrupted."""
    session = WorkerSession(
        study, find_plugin(options.plugin), hang_limit_s=options.hang_limit
    )
    try:
        runner.measure(session, Progress(len(runner.missing)))
    except KeyboardInterrupt:
        runner.write()
        return True
    finally:
        session.close()
    return False


def try_stability(options: argparse.Namespace) -> int:
    """Try the cases of a stability study and write what they show; return the exit code."""
    given = vars(options)
    if any(given[name] not in (None, False) for name in _NOT_OF_STABILITY):
        options_text = ", ".join(f"--{name}" for name in _NOT_OF_STABILITY)
        raise BenchError(
            f"command line: {options_text} do not apply to a stability study"
        )
    study = load_stability_study(find_study(options.study))
    if options.techniques is not None:
        study = study.only(_names(options.techniques))
    study = study.quick() if options.quick else study
    folder = folder_of(options, study.name)
    make_writable_folder(folder)
    from .session import Session

    session = Session(None, find_plugin(options.plugin))
    progress = Progress(1)
    rows = session.run_stability(
        study, lambda share: progress.show("stability cases", share)
    )
    progress.close()
    outcome = outcome_of(rows)
    write_outcome(folder, session.context(), outcome)
    write_stability_plot(folder, outcome)
    write_stability_report(folder, study, session.context(), outcome)
    print("\n".join(summary_lines(outcome)))
    print(f"{len(rows)} rows; {folder / REPORT_FILE}")
    return 1 if all(row.status == FAIL for row in outcome.rows) else 0


def write_views(
    study: Study, folder: Path, runner: Runner, records: list[Record]
) -> None:
    """Write plots and report, and print the table."""
    if study.report != SCALING:  # its scenes differ in size only
        write_plots(folder, records, bool(study.sweeps) and study.paper is None)
    findings = findings_of(study, records, runner.start_rows, folder)
    if findings is not None:
        write_tables(folder, findings)
    write_report(folder, study, runner.context, records, runner.notes, findings)
    print(text_tables(study, records))
    if findings is not None:
        print(findings.text())
    if table := ceiling_table(runner.context, records):
        print(as_text(table))
    count = len(unfinished(records))
    print(
        f"{len(records)} rows, {count} without a measurement; {folder / 'report.html'}"
    )


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; bad input is one line on stderr and exit code 2."""
    # pvpython's own handler would end an interrupt with a stack trace; ./run sends SIGTERM.
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.default_int_handler)
    try:
        return run(parse(arguments))
    except BenchError as fault:
        print(f"error: {fault}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("interrupted; --resume keeps the rows measured so far", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
