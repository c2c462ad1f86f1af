"""Writes a generated volume: python3 Python/generate.py NAME [--dims X Y Z] [--out FILE.mhd] ..."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from volumebench.generate import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main())
