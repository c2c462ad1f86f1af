"""Runs a study: scene by scene through a session, keeping all that is measured as it comes."""

import time
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol

from .calibration import keep_calibration, with_calibration
from .datasets import VolumeFile, find_volume
from .errors import BenchError, OutputError
from .gallery import forget_galleries, write_gallery
from .group_watch import GroupWatch
from .journal import FILE as JOURNAL_FILE
from .journal import FolderLock, Journal, Measured, RunProgress, forget_journal
from .journal import read_journal
from .json_file import make_writable_folder
from .kept_pictures import Pictures
from .progress import Progress
from .results import (
    FAILED,
    OK,
    Context,
    Record,
    check_same_settings,
    read_results,
    record_of,
    write_results,
    write_settings,
)
from .start import FILE as START_FILE
from .start import StartRow, read_start, write_start
from .study import Run, Scene, Study
from .techniques import ENGINE, REMOTE
from .transfer_functions import (
    TRANSFER_FUNCTION_FOLDER,
    TransferFunction,
    find_transfer_function,
    load_transfer_function,
)
from .view_measure import Contestant
from .worker import WorkerEnded

WRITE_INTERVAL_S = 5.0


class Session(Protocol):
    """What the runner asks of session.Session; tests bring their own."""

    def context(self) -> Context:
        ...

    def open_volume(self, file: VolumeFile) -> Any:
        ...

    def run_engine(self, volume: Any, function: Any, runs: Any, watch: Any) -> Any:
        ...

    def run_view(self, volume: Any, function: Any, runs: Any, watch: Any) -> Any:
        ...

    def run_remote(self, volume: Any, function: Any, runs: Any, watch: Any) -> Any:
        ...

    def run_start(self, volume: Any, function: Any, report: Any) -> Any:
        ...


@dataclass
class Inputs:
    """Everything a study reads, found and checked before anything is measured."""

    volumes: dict[str, VolumeFile] = field(default_factory=dict)
    start_volumes: list[VolumeFile] = field(default_factory=list)
    functions: dict[str, TransferFunction] = field(default_factory=dict)


def find_inputs(study: Study, data_folder: Path | None, cache: Path) -> Inputs:
    """Find all volumes and transfer functions of a study."""
    folders = [study.folder, data_folder, TRANSFER_FUNCTION_FOLDER]
    given = [folder for folder in folders if folder is not None]
    inputs = Inputs()
    names = [name for item in study.transfer_functions.values() for name in item]
    for name in names + ([study.start.transfer_function] if study.start else []):
        file = find_transfer_function(name, given)
        inputs.functions[name] = load_transfer_function(file)
    for dataset in study.datasets:
        inputs.volumes[dataset.name] = find_volume(dataset, data_folder, cache)
    for dataset in study.start.datasets if study.start else ():
        inputs.start_volumes.append(find_volume(dataset, data_folder, cache))
    return inputs


@dataclass
class Earlier:
    """What an earlier run left in the output folder; failed rows are measured again."""

    context: Context = field(default_factory=Context)
    records: list[Record] = field(default_factory=list)
    start_rows: list[StartRow] = field(default_factory=list)
    measured: Measured = field(default_factory=Measured)
    lock: FolderLock | None = None


def prepare_folder(study: Study, folder: Path, resume: bool) -> Earlier:
    """Make the output folder, keep others out of it, and return what needs no new measurement."""
    make_writable_folder(folder)
    lock = FolderLock(folder)
    written = [folder / name for name in ("results.json", JOURNAL_FILE)]
    if resume and any(path.is_file() for path in written):
        check_same_settings(folder, study.settings())
        earlier = _earlier(folder)
    else:
        earlier = Earlier()
        forget_journal(folder)
        forget_galleries(folder)
        for name in (START_FILE, "results.json", "results.csv"):
            (folder / name).unlink(missing_ok=True)
    earlier.lock = lock
    write_settings(folder, study.settings())
    return earlier


def _earlier(folder: Path) -> Earlier:
    earlier = Earlier(measured=read_journal(folder), start_rows=read_start(folder))
    records: list[Record] = []
    if (folder / "results.json").is_file():
        earlier.context, records = read_results(folder / "results.json")
    rows = {record.run().key(): record for record in records}
    rows |= {row.run().key(): row for row in earlier.measured.records.values()}
    earlier.records = [row for row in rows.values() if row.status != FAILED]
    return earlier


class Runner:
    """Holds the records of one study while it runs."""

    def __init__(
        self,
        study: Study,
        inputs: Inputs,
        folder: Path,
        earlier: Earlier,
        calibration: dict[str, Any] | None = None,
    ) -> None:
        self.study = study
        self.inputs = inputs
        self.folder = folder
        self.records = list(earlier.records)
        self.context = earlier.context
        self._calibration = calibration
        measured = {record.run().key() for record in earlier.records}
        self.missing = [run for run in study.runs() if run.key() not in measured]
        self.notes: list[str] = []
        self.start_rows = earlier.start_rows
        self._measured = earlier.measured
        self._lock = earlier.lock  # held as long as this is
        self._journal: Journal | None = None
        self._written_s = 0.0

    def is_complete(self) -> bool:
        """Tell whether an earlier run left nothing to be measured."""
        return not self.missing and (not self.study.start or bool(self.start_rows))

    def measure(self, session: Session, progress: Progress) -> list[Record]:
        """Measure all missing runs and return all records in study order."""
        self.context = self._calibrated(session.context())
        self._journal = Journal(self.folder)
        try:
            for dataset in self.study.datasets:
                runs = [
                    run for run in self.missing if run.scene.dataset == dataset.name
                ]
                if runs:
                    self._measure_dataset(session, dataset.name, runs, progress)
            self.write()
            if self.study.start and not self.start_rows:
                self._measure_start(session, progress)
        finally:
            self._journal.close()
            progress.close()
        forget_journal(self.folder)
        return self.records

    def _measure_start(self, session: Session, progress: Progress) -> None:
        """Measure first pictures and edits; what cannot be read or shown becomes a note."""
        start = self.study.start
        function = self.inputs.functions[start.transfer_function]
        for file in self.inputs.start_volumes:

            def report(share: float) -> None:
                progress.show(f"first pictures of {file.name}: {100 * share:.0f} %")

            known = self._measured.start_rows.get(file.name)
            if known is not None:
                self.start_rows += known
                continue
            try:
                volume = session.open_volume(file)
                rows = session.run_start(volume, function, report)
            except OutputError:
                raise
            except Exception as fault:  # the study has its other results
                self.notes.append(f"first picture of {file.name}: {fault}")
                continue
            self._journal.start(file.name, rows)
            self.start_rows += rows
        write_start(self.folder, start, self.start_rows)

    def close(self) -> None:
        """Let others measure into the folder."""
        self._lock.close()

    def renew_calibration(self) -> None:
        """Put a calibration beside rows that were all measured before."""
        if self._calibration is not None:
            self.context = self._calibrated(self.context)
            self.write()

    def _calibrated(self, context: Context) -> Context:
        if self._calibration is not None:
            return with_calibration(context, self._calibration)
        return keep_calibration(context, self.context)

    def _measure_dataset(
        self, session: Session, name: str, runs: list[Run], progress: Progress
    ) -> None:
        progress.show(f"reading {name}")
        try:
            volume = session.open_volume(self.inputs.volumes[name])
        except BenchError as fault:
            for run in runs:
                self.keep(_failed(run, None, str(fault)))
            progress.finish(len(runs))
            return
        for scene in dict.fromkeys(run.scene for run in runs):
            self._measure_scene(session, volume, scene, runs, progress)

    def _measure_scene(
        self,
        session: Session,
        volume: Any,
        scene: Scene,
        runs: list[Run],
        progress: Progress,
    ) -> None:
        inside = [run for run in runs if run.scene == scene]
        engine = [run for run in inside if run.path == ENGINE]
        remote = [run for run in inside if run.path == REMOTE]
        view = [run for run in inside if run.path not in (ENGINE, REMOTE)]
        groups = (engine, self._engine), (remote, self._remote), (view, self._view)
        for group, work in groups:
            if group:
                self._measure_group(session, volume, group, work, progress)

    def _measure_group(
        self, session: Session, volume: Any, runs: list[Run], work: Any, progress: Any
    ) -> None:
        """Measure runs that take turns; one that ends the process is left out, the others go on."""
        watch = GroupWatch(self, runs, volume, progress)
        without_culprit = 0
        while left := watch.next_request():
            try:
                records = work(session, volume, left, watch)
                watch.take([row for row in records if row.run() in watch.left()])
                break
            except OutputError:
                raise
            except WorkerEnded as fault:
                without_culprit += fault.run is None
                given_up = [fault.run] if fault.run else left
                if fault.run or without_culprit > 1:
                    watch.take([_failed(run, volume, str(fault)) for run in given_up])
            except Exception as fault:  # the study goes on with the next scene
                reason = str(fault) or type(fault).__name__
                watch.take([_failed(run, volume, reason) for run in left])
        if watch.pictures.by_technique:
            rows = [row for row in self.records if row.run().scene == runs[0].scene]
            write_gallery(self.folder, runs[0].scene, watch.pictures, rows)
        self.write()

    def _engine(
        self, session: Session, volume: Any, runs: list[Run], watch: GroupWatch
    ) -> list[Record]:
        function = self.inputs.functions[runs[0].scene.transfer_function]
        records, pictures = session.run_engine(volume, function, runs, watch)
        self._take_note(runs[0].scene, pictures)
        return records

    def _view(
        self, session: Session, volume: Any, runs: list[Run], watch: GroupWatch
    ) -> list[Record]:
        return self._in_view(session.run_view, volume, runs, watch)

    def _remote(
        self, session: Session, volume: Any, runs: list[Run], watch: GroupWatch
    ) -> list[Record]:
        return self._in_view(session.run_remote, volume, runs, watch)

    def _in_view(
        self, measure: Any, volume: Any, runs: list[Run], watch: GroupWatch
    ) -> list[Record]:
        function = self.inputs.functions[runs[0].scene.transfer_function]
        contestants, pictures = measure(volume, function, runs, watch)
        self._take_note(runs[0].scene, pictures)
        return [_measured(item, volume) for item in contestants]

    def _take_note(self, scene: Scene, pictures: Pictures) -> None:
        if pictures.note:
            self.notes.append(f"{scene.title()}: {pictures.note}")

    def keep(self, record: Record) -> None:
        """Keep a row for good, and write all rows if that was not done lately."""
        record = self._with_stand_in(record)
        if record.status == OK:
            self._journal.record(record)
        self.records.append(record)
        if time.monotonic() - self._written_s > WRITE_INTERVAL_S:
            self.write()

    def progress_of(self, run: Run) -> RunProgress:
        """Return what an earlier run measured of a run that has no row."""
        return self._measured.of(run)

    @property
    def journal(self) -> Journal:
        """Return where what is measured is kept."""
        return self._journal

    def _with_stand_in(self, record: Record) -> Record:
        stands_for = self.study.dataset(record.dataset).stands_for
        return replace(record, stand_in_for=stands_for)

    def write(self) -> None:
        """Write the results, in study order."""
        self._written_s = time.monotonic()
        replaced = {record.run().key(): record for record in self.records}
        order = [run.key() for run in self.study.runs()]
        inside = [replaced.pop(key) for key in order if key in replaced]
        self.records = inside + list(replaced.values())
        write_results(self.folder, self.context, self.records)


def _failed(run: Run, volume: Any, reason: str) -> Record:
    dims = getattr(volume, "dims", None)
    scalar_type = getattr(volume, "scalar_type", None)
    return record_of(run, dims, scalar_type, status=FAILED, reason=reason)


def _measured(contestant: Contestant, volume: Any) -> Record:
    values = contestant.values()
    return record_of(contestant.run, volume.dims, volume.scalar_type, **values)
