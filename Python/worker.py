"""Measures for bench.py, which starts it: worker.py HANDLE PARENT."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from volumebench.worker import run_worker  # noqa: E402

if __name__ == "__main__":
    run_worker(int(sys.argv[1]), int(sys.argv[2]))
