"""Data spread over 1, 2 and 4 ranks of pvbatch give one picture."""

import shutil
from pathlib import Path

import numpy as np
from parallel import MPI, start
from support import read_png, run_checks, temporary_folder

SCRIPT = Path(__file__).with_name("rank_scenes.py")
LEVEL = 1 / 255
SAME_PICTURE = 2e-3
WORST_PIXEL = 4 * LEVEL

# Each rank begins its steps at its own border: off by a part of a step where a surface is hard.
OWN_STEPS = {"wall": 8e-3, "lit": 6e-3, "lit_blocks": 4e-3, "long_steps": 4e-3}
# ParaView blends ranks in 8 bits and rounds down each time, half a level on the average.
ROUNDING = 0.5 * LEVEL


def check_ranks_give_one_picture() -> None:
    with temporary_folder() as folder:
        for ranks in (1, 2, 4):
            save_scenes(folder / str(ranks), ranks)
        names = sorted(path.stem for path in (folder / "1").glob("*.png"))
        assert len(names) > 25, names
        wrong = [
            line
            for ranks in (2, 4)
            for name in names
            for line in differences(folder, name, ranks)
        ]
    assert not wrong, "\n".join(wrong)


def save_scenes(folder: Path, ranks: int) -> None:
    folder.mkdir()
    done = start(
        [*MPI[:-1], str(ranks), shutil.which("pvbatch"), str(SCRIPT), str(folder)]
    )
    errors = [
        line
        for line in done.stderr.splitlines()
        if "ERR|" in line and "cannot run here" not in line
    ]
    assert done.returncode == 0 and not errors, f"{ranks} ranks: {errors} {done.stderr}"


def differences(folder: Path, name: str, ranks: int) -> list[str]:
    """Return what is wrong with a scene drawn by several ranks, a line each."""
    whole = read_png(folder / "1" / f"{name}.png")
    assert whole.max() > 0.1, f"{name}: the picture is empty"
    difference = read_png(folder / str(ranks) / f"{name}.png") - whole
    bias = difference.mean()
    spread = np.sqrt(np.mean((difference - bias) ** 2))
    worst = np.abs(difference).max()
    print(f"  {name}, {ranks} ranks: {spread:.5f}, mean {bias:.5f}, worst {worst:.3f}")
    wrong = []
    if abs(bias) > ROUNDING * (ranks - 1):
        wrong.append(f"{name} on {ranks} ranks: mean difference {bias:.5f}")
    if spread > OWN_STEPS.get(name, SAME_PICTURE):
        wrong.append(f"{name} on {ranks} ranks: RMSE {spread:.5f}")
    if worst > WORST_PIXEL and name not in OWN_STEPS:
        wrong.append(f"{name} on {ranks} ranks: a pixel differs by {worst:.3f}")
    return wrong


if __name__ == "__main__":
    run_checks(dict(globals()))
