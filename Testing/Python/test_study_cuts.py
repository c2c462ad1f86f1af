"""Cuts of a study by the command line: fewer volumes, fewer frames, and notes that tell of both."""

import pytest
from volumebench.__main__ import main, parse, study_of
from volumebench.errors import StudyError
from volumebench.study_cuts import of_datasets, with_frames
from volumebench.study_file import find_study, load_study


def cut(*options):
    return study_of(parse(["maas-2015", *options]))


def test_a_turn_of_fewer_frames_is_shown_once_by_each_run():
    full, short = cut(), cut("--frames", "6")
    assert short.camera.frames == short.timing.minimum_frames == 6
    assert len(short.runs()) == len(full.runs()) == 72, "every factor stays"
    assert short.settings() != full.settings(), "--resume tells them apart"
    assert "at least 3600 a run" in short.notes[-1] and not short.notes[:-1][
        -1
    ].startswith("Cut")


def test_frames_of_a_quick_cut_are_cut_too():
    assert cut("--quick", "--frames", "7").camera.frames == 7


def test_some_volumes_alone():
    study = load_study(find_study("sans-2016"))
    short = of_datasets(study, ["foot"])
    assert {run.scene.dataset for run in short.runs()} == {"foot"}
    assert "Cut to foot; the study also has angiography," in short.notes[-1]
    assert of_datasets(study, [item.name for item in study.datasets]) is study


@pytest.mark.parametrize(
    "options, expected",
    [
        (
            ("volt", "--datasets", "vismal"),
            '"vismal" is not a dataset of volt; it has vismale',
        ),
        (("volt", "--frames", "1"), "--frames 1: volt measures errors at 2 of them"),
        (("volt", "--frames", "0"), "0 is not a number of frames"),
        (("volt", "--frames", "2.5"), "2.5 is not a number of frames"),
        (("speed", "--frames", "9"), "three-views has frames of its own"),
        (("stability", "--frames", "9"), "do not apply to a stability study"),
    ],
)
def test_what_cannot_be_cut_is_one_line(options, expected, capsys):
    assert main(list(options)) == 2
    assert expected in capsys.readouterr().err


def test_the_functions_refuse_as_the_command_line_does():
    study = load_study(find_study("volt"))
    with pytest.raises(StudyError, match="vismal"):
        of_datasets(study, ["vismal"])
    with pytest.raises(StudyError, match="--frames 1"):
        with_frames(study, 1)
