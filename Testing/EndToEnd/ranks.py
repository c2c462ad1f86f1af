"""Data spread over 1, 2 and 4 ranks of pvbatch give one picture."""

import re
import shutil
from pathlib import Path

import numpy as np
from parallel import MPI, start
from support import read_png, run_checks, temporary_folder

SCRIPT = Path(__file__).with_name("rank_scenes.py")
QUICK = (
    "wall",
    "lit",
    "inside",
    "moved",
    "geometry",
    "maximum",
    "two_volumes",
    "blocks_apart",
    "interleaved_blocks",
    "volume_slices",
)
LEVEL = 1 / 255
SAME_PICTURE = 2e-3
WORST_PIXEL = 4 * LEVEL


def check_ranks_give_one_picture() -> None:
    expect_one_picture(list(QUICK))


def expect_one_picture(names: list[str]) -> None:
    """Check that scenes look alike whatever the number of ranks."""
    with temporary_folder() as folder:
        for ranks in (1, 2, 4):
            errors = save_scenes(folder / str(ranks), ranks, names)
            assert not errors, f"{ranks} ranks: {errors}"
            expect_figures(folder / str(ranks), ranks)
        wrong = [
            line
            for ranks in (2, 4)
            for name in names
            for line in differences(folder, name, ranks)
        ]
    assert not wrong, "\n".join(wrong)


def check_overlapping_blocks_are_refused() -> None:
    with temporary_folder() as folder:
        errors = save_scenes(folder / "2", 2, ["overlapping_blocks"])
        picture = read_png(folder / "2" / "overlapping_blocks.png")
    assert len(errors) == 2, errors  # one of each rank
    assert all("blocks of different ranks overlap" in line for line in errors), errors
    assert picture.max() == 0.0, "something is drawn"


def save_scenes(folder: Path, ranks: int, names: list[str]) -> list[str]:
    """Save the scenes as several ranks draw them, and return the errors that they report."""
    folder.mkdir()
    pvbatch = [shutil.which("pvbatch"), str(SCRIPT), str(folder), *names]
    done = start([*MPI[:-1], str(ranks), *pvbatch])
    assert done.returncode == 0, f"{ranks} ranks: {done.stderr}"
    return [
        line
        for line in done.stderr.splitlines()
        if "ERR|" in line and "cannot run here" not in line
    ]


def expect_figures(folder: Path, ranks: int) -> None:
    """Check what the panel's row tells of each rank."""
    line = r"rank (\d): (?:([\d.]+) ms|draws nothing), ([\d.]+) MiB of voxels, ([\d.]+) MiB in use"
    for path in folder.glob("*.txt"):
        text = path.read_text(encoding="utf-8")
        told = [re.fullmatch(line, row) for row in text.splitlines()]
        assert all(told), f"{path.stem} on {ranks} ranks: {text}"
        assert [int(match[1]) for match in told] == list(range(ranks)), text
        drawn = [match for match in told if match[2]]
        assert drawn and all(float(match[2]) > 0 for match in drawn), text
        assert all(float(match[4]) > 10 for match in told), text


def differences(folder: Path, name: str, ranks: int) -> list[str]:
    """Return what is wrong with a scene drawn by several ranks, a line each."""
    whole = read_png(folder / "1" / f"{name}.png")
    assert whole.max() > 0.1, f"{name}: the picture is empty"
    difference = read_png(folder / str(ranks) / f"{name}.png") - whole
    rmse = np.sqrt(np.mean(difference**2))
    worst = np.abs(difference).max()
    print(f"  {name}, {ranks} ranks: {rmse:.5f}, worst {worst:.3f}")
    wrong = []
    if rmse > SAME_PICTURE:
        wrong.append(f"{name} on {ranks} ranks: RMSE {rmse:.5f}")
    if worst > WORST_PIXEL:
        wrong.append(f"{name} on {ranks} ranks: a pixel differs by {worst:.3f}")
    return wrong


if __name__ == "__main__":
    run_checks(dict(globals()))
