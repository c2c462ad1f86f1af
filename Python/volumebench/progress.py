"""A progress bar on stderr with the remaining time."""

import sys
import time
from typing import TextIO

BAR_WIDTH = 28


class Progress:
    """Counts runs; fractions of a run are welcome."""

    def __init__(self, total_runs: int, stream: TextIO = sys.stderr) -> None:
        self.total_runs = max(total_runs, 1)
        self.finished_runs = 0
        self._stream = stream
        self._start_s = time.monotonic()
        self._last_line_s = 0.0

    def finish(self, runs: int) -> None:
        """Count whole runs as done."""
        self.finished_runs += runs

    def show(self, label: str, partial_runs: float = 0.0) -> None:
        """Draw the bar; on a file rather than a terminal, one line every ten seconds."""
        now_s = time.monotonic()
        terminal = self._stream.isatty()
        if now_s - self._last_line_s < (0.2 if terminal else 10):
            return
        self._last_line_s = now_s
        done = min((self.finished_runs + partial_runs) / self.total_runs, 1.0)
        line = bar_line(done, now_s - self._start_s, label)
        end = "\033[K\r" if terminal else "\n"
        self._stream.write(line + end)
        self._stream.flush()

    def close(self) -> None:
        """Leave the line of the bar."""
        if self._stream.isatty():
            self._stream.write("\033[K")
            self._stream.flush()


def bar_line(done: float, elapsed_s: float, label: str) -> str:
    """Return the bar as text for the share that is done."""
    filled = round(done * BAR_WIDTH)
    bar = "#" * filled + "-" * (BAR_WIDTH - filled)
    remaining = "--:--"
    if done > 0.02:
        minutes, seconds = divmod(round(elapsed_s * (1 - done) / done), 60)
        remaining = f"{minutes:02d}:{seconds:02d}"
    return f"[{bar}] {100 * done:3.0f} %  {remaining} left  {label}"
