"""Command line of the package: reads a study, measures it, writes results, plots and a report."""

import argparse
import signal
import sys
from pathlib import Path

from .datasets import with_stand_ins
from .errors import BenchError
from .plot import write_plots
from .progress import Progress
from .report import write_report
from .results import FAILED, Record
from .runner import Runner, find_inputs, prepare_folder
from .study import Study
from .study_file import find_study, load_study
from .summary import unfinished
from .tables import text_tables


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
    add("study", metavar="STUDY", help="a file, or a name under Python/Studies")
    add(
        "--quick",
        action="store_true",
        help="what the study calls quick, or its extremes",
    )
    add("--out", type=Path, metavar="DIR", help="default: Results/NAME")
    add("--data", type=Path, metavar="DIR", help="folder with more volumes")
    add("--techniques", metavar="A,B", help="these techniques in place of the study's")
    add("--resume", action="store_true", help="keep the rows of an earlier run")
    add("--plugin", metavar="FILE", help="the plugin, if not the one built here")
    return parser.parse_args(arguments)


def study_of(options: argparse.Namespace) -> Study:
    """Return the study after the cuts of the command line, on the volumes that are here."""
    study = load_study(find_study(options.study))
    if options.techniques is not None:
        names = [name.strip() for name in options.techniques.split(",")]
        study = study.only([name for name in names if name])
    if options.data is not None and not options.data.is_dir():
        raise BenchError(f"--data {options.data}: no such folder")
    return with_stand_ins(study.quick() if options.quick else study, options.data)


def run(options: argparse.Namespace) -> int:
    """Measure the study and write everything; return the exit code."""
    study = study_of(options)
    suffix = "-quick" if options.quick else ""
    folder = options.out or Path("Results") / f"{study.name}{suffix}"
    earlier = prepare_folder(study, folder, options.resume)
    inputs = find_inputs(study, options.data, folder / "volumes")
    runner = Runner(study, inputs, folder, earlier)
    records = runner.records
    if runner.missing:
        from .session import Session, find_plugin

        session = Session(study, find_plugin(options.plugin))
        records = runner.measure(session, Progress(len(runner.missing)))
    write_views(study, folder, runner, records)
    return 1 if all(record.status == FAILED for record in records) else 0


def write_views(
    study: Study, folder: Path, runner: Runner, records: list[Record]
) -> None:
    """Write plots and report, and print the table."""
    write_plots(folder, records)
    write_report(folder, study, runner.context, records, runner.notes)
    print(text_tables(study, records))
    count = len(unfinished(records))
    print(
        f"{len(records)} rows, {count} without a measurement; {folder / 'report.html'}"
    )


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; bad input is one line on stderr and exit code 2."""
    # pvpython's own handler would end an interrupt with a stack trace.
    signal.signal(signal.SIGINT, signal.default_int_handler)
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
