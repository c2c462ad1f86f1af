"""Keeps what is measured of one scene on one kind of path, while it is measured."""

from typing import Any, Protocol

import numpy as np

from .error import ImageError
from .journal import Journal, PictureStore, RunProgress
from .kept_pictures import Pictures
from .progress import Progress
from .results import FrameLog, Record, record_of
from .study import Run
from .techniques import ENGINE, REMOTE, VIEW
from .watch import Watch


class Keeper(Protocol):
    """What is asked of the runner."""

    folder: Any
    journal: Journal

    def keep(self, record: Record) -> None:
        ...

    def progress_of(self, run: Run) -> RunProgress:
        ...


class GroupWatch(Watch):
    """Writes every note into the journal; holds the pictures of the scene."""

    def __init__(
        self, keeper: Keeper, runs: list[Run], volume: Any, progress: Progress
    ) -> None:
        group = runs[0].path if runs[0].path in (ENGINE, REMOTE) else VIEW
        self._keeper = keeper
        self._left = list(runs)
        self._asked = len(runs)
        self._volume = volume
        self._progress = progress
        self._title = runs[0].scene.title()
        self._store = PictureStore(keeper.folder, runs[0].scene, group)
        self.pictures = self._store.load(runs)

    def left(self) -> list[Run]:
        """Return the runs that have no row yet."""
        return list(self._left)

    def next_request(self) -> list[Run]:
        """Return the runs to ask for now; what is told of their share counts from here."""
        self._asked = len(self._left)
        return self.left()

    def take(self, records: list[Record]) -> None:
        """Keep rows, measured or not."""
        for record in records:
            self._left.remove(record.run())
            self._keeper.keep(record)
            self._progress.finish(1)

    def __call__(self, partial_runs: float) -> None:
        kept = self._asked - len(
            self._left
        )  # rows of this request, which count by themselves
        self._progress.show(self._title, max(partial_runs - kept, 0))

    def frames(self, run: Run, log: FrameLog) -> None:
        self._keeper.progress_of(run).log.extend(log)
        self._keeper.journal.frames(run, log)

    def error(self, run: Run, error: ImageError) -> None:
        self._keeper.progress_of(run).error = error
        self._keeper.journal.error(run, error)

    def picture(self, run: Run, picture: np.ndarray) -> None:
        if self.pictures.keep(run, picture):
            self._store.keep(run, picture)

    def reference(self, pictures: Pictures) -> None:
        self.pictures.references = pictures.references[:1]
        self.pictures.label = pictures.label
        self.pictures.uncertainty = pictures.uncertainty
        self._store.keep_reference(pictures)

    def done(self, run: Run, values: dict[str, Any]) -> None:
        dims, scalar_type = self._volume.dims, self._volume.scalar_type
        self.take([record_of(run, dims, scalar_type, **values)])

    def earlier_log(self, run: Run) -> FrameLog:
        return self._keeper.progress_of(run).log

    def earlier_error(self, run: Run) -> ImageError | None:
        return self._keeper.progress_of(run).error
