"""Data spread over 1, 2 and 4 ranks of pvbatch give one picture."""

import re
import shutil
from pathlib import Path

import numpy as np
from parallel import MPI, start
from rank_scenes import refused
from support import read_png, run_checks, temporary_folder

SCRIPT = Path(__file__).with_name("rank_scenes.py")
QUICK = (
    "wall",
    "lit",
    "inside",
    "moved",
    "geometry",
    "out_of_sight",
    "maximum",
    "two_volumes",
    "two_volumes_behind",
    "blocks_apart",
    "interleaved_blocks",
    "volume_slices",
    "non_overlapping_levels",
    "other_arrays",
    "error_target",
    "exact",
    "translucent_behind",
)
LEVEL = 1 / 255
SAME_PICTURE = 2e-3
WORST_PIXEL = 4 * LEVEL
ROUNDING_ERROR = 0.1 * LEVEL  # a picture that differs more is another one


def check_ranks_give_one_picture() -> None:
    with temporary_folder() as folder:
        wrong = save_on_ranks(folder, list(QUICK))
        for name in QUICK:
            wrong += differences(folder, name)
        wrong += lost_targets(folder)
    assert not wrong, "\n".join(wrong)


def check_overlapping_data_are_refused() -> None:
    names = list(refused())
    with temporary_folder() as folder:
        errors = save_scenes(folder / "2", 2, names)
        pictures = [read_png(folder / "2" / f"{name}.png") for name in names]
    assert len(errors) == 2 * len(names), errors  # one of each rank
    assert all("blocks of different ranks overlap" in line for line in errors), errors
    assert all(picture.max() == 0.0 for picture in pictures), "something is drawn"


def save_on_ranks(folder: Path, names: list[str]) -> list[str]:
    """Save scenes as 1, 2 and 4 ranks draw them, and return what was wrong, a line each."""
    wrong = []
    for ranks in (1, 2, 4):
        wrong += save_scenes(folder / str(ranks), ranks, names)
        expect_figures(folder / str(ranks), ranks)
    return wrong


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
        assert all(float(match[2]) > 0 and float(match[3]) > 0 for match in drawn), text
        if path.stem == "wall":
            assert drawn == told, text
        if path.stem == "maximum":  # drawn by one rank, whatever others read
            assert drawn == told[:1] and float(told[-1][3]) == 0 or ranks == 1, text
        assert all(float(match[4]) > 10 for match in told), text


def differences(folder: Path, name: str) -> list[str]:
    """Return what is wrong with a scene drawn by several ranks, a line each."""
    whole = read_png(folder / "1" / f"{name}.png")
    assert whole.max() > 0.1, f"{name}: the picture is empty"
    wrong = []
    for ranks in (2, 4):
        difference = read_png(folder / str(ranks) / f"{name}.png") - whole
        rmse = np.sqrt(np.mean(difference**2))
        worst = np.abs(difference).max()
        print(f"  {name}, {ranks} ranks: {rmse:.5f}, worst {worst:.3f}")
        if rmse > SAME_PICTURE:
            wrong.append(f"{name} on {ranks} ranks: RMSE {rmse:.5f}")
        if worst > WORST_PIXEL:
            wrong.append(f"{name} on {ranks} ranks: a pixel differs by {worst:.3f}")
    return wrong


def lost_targets(folder: Path) -> list[str]:
    """Return which ranks are farther from the exact picture with an error target than one is."""
    exact = read_png(folder / "1" / "exact.png")
    errors = {
        ranks: np.sqrt(
            np.mean((read_png(folder / str(ranks) / "error_target.png") - exact) ** 2)
        )
        for ranks in (1, 2, 4)
    }
    print("  errors of ranks with a target:", errors)
    assert errors[1] > ROUNDING_ERROR, "the picture is exact, whatever the target"
    return [
        f"{ranks} ranks: error {error:.5f}"
        for ranks, error in errors.items()
        if error > 1.05 * errors[1]
    ]


if __name__ == "__main__":
    run_checks(dict(globals()))
