"""The pictures that a report shows of a scene: the reference, and one of each technique."""

from dataclasses import dataclass, field

import numpy as np

from .study import Run
from .summary import STANDARD_STEP_VOXELS
from .techniques import INTERACTIVE


@dataclass
class Pictures:
    """The reference pictures and one picture per technique, taken at the first view."""

    references: list[np.ndarray] = field(default_factory=list)
    label: str | None = None
    uncertainty: float | None = None
    note: str | None = None
    by_technique: dict[str, tuple[Run, np.ndarray]] = field(default_factory=dict)

    def keep(self, run: Run, picture: np.ndarray) -> bool:
        """Keep the picture of the run nearest to the standard step, one per technique.

        Tell whether it is this one.
        """
        held = self.by_technique.get(run.technique)
        kept = held is None or _preference(run) < _preference(held[0])
        if kept:
            self.by_technique[run.technique] = (run, picture)
        return kept


def _preference(run: Run) -> tuple[bool, bool, float]:
    step = run.step_voxels or STANDARD_STEP_VOXELS
    return (
        run.path == INTERACTIVE,
        run.integrator == "Left",
        abs(step - STANDARD_STEP_VOXELS),
    )
