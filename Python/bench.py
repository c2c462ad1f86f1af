"""Runs a study: pvpython Python/bench.py STUDY [--quick] [--out DIR] [--data DIR] ..."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from volumebench.__main__ import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main())
