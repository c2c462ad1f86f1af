"""The scenes of ranks that ranks.py leaves out."""

from rank_scenes import scenes
from ranks import QUICK, differences, save_on_ranks
from support import run_checks, temporary_folder


def check_ranks_give_one_picture() -> None:
    names = [name for name in scenes() if name not in QUICK]
    with temporary_folder() as folder:
        wrong = save_on_ranks(folder, names)
        for name in names:
            wrong += differences(folder, name)
    assert not wrong, "\n".join(wrong)


if __name__ == "__main__":
    run_checks(dict(globals()))
