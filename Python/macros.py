"""Writes the macros for transfer functions: python3 Python/macros.py [FOLDER]."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from volumebench.macros import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
