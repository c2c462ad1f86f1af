"""What those who measure tell while they do, and what they are told of earlier measurements."""

from typing import Any

import numpy as np

from .error import ImageError
from .results import FrameLog
from .study import Run
from .kept_pictures import Pictures


class Watch:
    """Takes every note and keeps none; knows of no earlier measurement."""

    def __call__(self, partial_runs: float) -> None:
        """Take how many of the runs are done, as a sum of shares."""

    def begin(self, run: Run | None, work: str) -> None:
        """Take what is begun: who is at fault should the process end now (None: the reference)."""

    def frames(self, run: Run, log: FrameLog) -> None:
        """Take frames that were timed since the last time."""

    def error(self, run: Run, error: ImageError) -> None:
        """Take the error of a run."""

    def picture(self, run: Run, picture: np.ndarray) -> None:
        """Take a picture of the first error view."""

    def reference(self, pictures: Pictures) -> None:
        """Take the reference."""

    def done(self, run: Run, values: dict[str, Any]) -> None:
        """Take what the record of a run holds beyond the run: it is measured."""

    def earlier_log(self, run: Run) -> FrameLog:
        """Return the frames that were timed before."""
        return FrameLog()

    def earlier_error(self, run: Run) -> ImageError | None:
        """Return the error, if it was measured before."""
        return None
