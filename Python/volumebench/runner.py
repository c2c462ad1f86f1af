"""Runs a study: scene by scene through a session, writing the results after each step."""

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol

from .calibration import keep_calibration, with_calibration
from .datasets import VolumeFile, find_volume
from .errors import BenchError
from .gallery import forget_galleries, write_gallery
from .json_file import make_writable_folder
from .progress import Progress
from .results import (
    FAILED,
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
from .techniques import ENGINE
from .transfer_functions import (
    TRANSFER_FUNCTION_FOLDER,
    TransferFunction,
    find_transfer_function,
    load_transfer_function,
)
from .view_measure import Contestant, Pictures


class Session(Protocol):
    """What the runner asks of session.Session; tests bring their own."""

    def context(self) -> Context:
        ...

    def open_volume(self, file: VolumeFile) -> Any:
        ...

    def run_engine(self, volume: Any, function: Any, runs: Any, report: Any) -> Any:
        ...

    def run_view(self, volume: Any, function: Any, runs: Any, report: Any) -> Any:
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


def prepare_folder(study: Study, folder: Path, resume: bool) -> Earlier:
    """Make the output folder and return what needs no new measurement."""
    make_writable_folder(folder)
    earlier = Earlier()
    if resume and (folder / "results.json").is_file():
        check_same_settings(folder, study.settings())
        context, records = read_results(folder / "results.json")
        kept = [record for record in records if record.status != FAILED]
        earlier = Earlier(context, kept)
        earlier.start_rows = read_start(folder)
    else:
        forget_galleries(folder)
        (folder / START_FILE).unlink(missing_ok=True)
    write_settings(folder, study.settings())
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

    def is_complete(self) -> bool:
        """Tell whether an earlier run left nothing to be measured."""
        return not self.missing and (not self.study.start or bool(self.start_rows))

    def measure(self, session: Session, progress: Progress) -> list[Record]:
        """Measure all missing runs and return all records in study order."""
        self.context = self._calibrated(session.context())
        for dataset in self.study.datasets:
            runs = [run for run in self.missing if run.scene.dataset == dataset.name]
            if runs:
                self._measure_dataset(session, dataset.name, runs, progress)
        self._write()
        if self.study.start and not self.start_rows:
            self._measure_start(session, progress)
        progress.close()
        return self.records

    def _measure_start(self, session: Session, progress: Progress) -> None:
        """Measure first pictures and edits; what cannot be read or shown becomes a note."""
        start = self.study.start
        function = self.inputs.functions[start.transfer_function]
        for file in self.inputs.start_volumes:

            def report(share: float) -> None:
                progress.show(f"first pictures of {file.name}: {100 * share:.0f} %")

            try:
                volume = session.open_volume(file)
                self.start_rows += session.run_start(volume, function, report)
            except Exception as fault:  # the study has its other results
                self.notes.append(f"first picture of {file.name}: {fault}")
        write_start(self.folder, start, self.start_rows)

    def renew_calibration(self) -> None:
        """Put a calibration beside rows that were all measured before."""
        if self._calibration is not None:
            self.context = self._calibrated(self.context)
            self._write()

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
            self._add([_failed(run, None, str(fault)) for run in runs], progress)
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
        function = self.inputs.functions[scene.transfer_function]
        inside = [run for run in runs if run.scene == scene]
        engine = [run for run in inside if run.path == ENGINE]
        view = [run for run in inside if run.path != ENGINE]

        def report(partial_runs: float) -> None:
            progress.show(scene.title(), partial_runs)

        for group, work in ((engine, self._engine), (view, self._view)):
            if not group:
                continue
            try:
                records = work(session, volume, function, group, report)
            except Exception as fault:  # the study goes on with the next scene
                reason = str(fault) or type(fault).__name__
                records = [_failed(run, volume, reason) for run in group]
            self._add(records, progress)

    def _engine(
        self, session: Session, volume: Any, function: Any, runs: Any, report: Any
    ) -> list[Record]:
        records, pictures = session.run_engine(volume, function, runs, report)
        self._keep_pictures(runs[0].scene, pictures, records)
        return records

    def _view(
        self, session: Session, volume: Any, function: Any, runs: Any, report: Any
    ) -> list[Record]:
        contestants, pictures = session.run_view(volume, function, runs, report)
        records = [_measured(item, volume) for item in contestants]
        self._keep_pictures(runs[0].scene, pictures, records)
        return records

    def _keep_pictures(
        self, scene: Scene, pictures: Pictures, records: list[Record]
    ) -> None:
        if pictures.note:
            self.notes.append(f"{scene.title()}: {pictures.note}")
        if pictures.by_technique:
            write_gallery(self.folder, scene, pictures, records)

    def _add(self, records: list[Record], progress: Progress) -> None:
        self.records.extend(self._with_stand_in(record) for record in records)
        progress.finish(len(records))
        self._write()

    def _with_stand_in(self, record: Record) -> Record:
        stands_for = self.study.dataset(record.dataset).stands_for
        return replace(record, stand_in_for=stands_for)

    def _write(self) -> None:
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
