"""How long tests wait for what they start."""

import os

_FACTOR = float(os.environ.get("VOLUMEBENCH_PATIENCE", "1"))


def patient_s(seconds: float) -> float:
    """Return a time limit, longer where programs are slow, as under the sanitizers."""
    return seconds * _FACTOR
