"""The scenes of ranks that ranks.py leaves out."""

from rank_scenes import scenes
from ranks import QUICK, expect_one_picture
from support import run_checks


def check_ranks_give_one_picture() -> None:
    expect_one_picture([name for name in scenes() if name not in QUICK])


if __name__ == "__main__":
    run_checks(dict(globals()))
