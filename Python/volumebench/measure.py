"""When a run has been measured enough, and in which order contestants take their turns."""

import random
from dataclasses import dataclass, field
from typing import TypeVar

from .statistics import relative_noise_of_mean
from .study import Timing

Item = TypeVar("Item")


@dataclass
class StopRule:
    """Stops at the minimum of frames once the mean is steady, or at the time limit."""

    timing: Timing
    frame_ms: list[float] = field(default_factory=list)

    def add(self, frame_ms: float) -> None:
        """Take one measured frame."""
        self.frame_ms.append(frame_ms)

    def spent_s(self) -> float:
        """Return the seconds of all measured frames."""
        return sum(self.frame_ms) / 1000

    def is_finished(self) -> bool:
        """Tell whether another block of frames is not needed; one frame is the least."""
        if not self.frame_ms:
            return False
        if self.spent_s() >= self.timing.time_limit_s:
            return True
        if len(self.frame_ms) < self.timing.minimum_frames:
            return False
        return relative_noise_of_mean(self.frame_ms) <= self.timing.relative_noise


def shuffled(items: list[Item], seed: int) -> list[Item]:
    """Return the items in an order that depends on the seed alone."""
    order = list(items)
    random.Random(seed).shuffle(order)
    return order
