"""Contestants of a view take turns fairly, and one that fails does not stop the others."""

from dataclasses import replace

import numpy as np
import pytest
from fakes import CHECK_ERROR, FakeStage
from volumebench.results import FAILED, OK, UNSUPPORTED
from volumebench.study import ErrorSettings, Timing
from volumebench.sample_counts import SampleCount, sample_count
from volumebench.view_measure import BLOCK_FRAMES, SETTLE_FRAMES
from volumebench.view_measure import measure_view
from volumebench.watch import Watch


@pytest.fixture
def calm(study):
    """Stops by the number of frames, since fake frames take no time."""
    timing = Timing(
        warm_up_frames=1, minimum_frames=8, relative_noise=1, time_limit_s=60
    )
    return replace(study, timing=timing)


def measured(stage, study, **changes):
    study = replace(study, **changes)
    runs = [run for run in study.runs() if run.path != "engine"]
    contestants, pictures = measure_view(stage, runs, study, Watch())
    return {contestant.run: contestant for contestant in contestants}, pictures


def test_every_contestant_gets_its_frames(calm):
    found, _ = measured(FakeStage(), calm)
    assert len(found) == 14
    for contestant in found.values():
        assert contestant.status == OK
        assert len(contestant.rule.frame_ms) % BLOCK_FRAMES == 0
        assert len(contestant.rule.frame_ms) >= 8


def test_blocks_are_interleaved(calm):
    """Nobody gets the second block before all had the first, and the order changes."""
    stage = FakeStage(captures=False)
    found, _ = measured(stage, calm, paths=("view",))
    shown = [sampling for sampling in stage.shown]
    count = len(found)
    first, second = shown[:count], shown[count : 2 * count]
    assert len(set(first)) == len(set(second)) == count
    assert first != second


def test_still_and_interactive_frames_are_not_mixed_up(calm):
    stage = FakeStage(captures=False)
    found, _ = measured(stage, calm, paths=("interactive",))
    assert all(interactive for _, _, interactive in stage.rendered)
    settle = SETTLE_FRAMES["interactive"]
    frames = sum(len(item.rule.frame_ms) for item in found.values())
    blocks = frames // BLOCK_FRAMES
    assert len(stage.rendered) == frames + blocks * settle


def test_errors_follow_the_picture(calm):
    found, pictures = measured(FakeStage(), calm, error=ErrorSettings(views=2))
    by_sampling = {
        (run.technique, run.integrator, run.step_voxels): contestant.error
        for run, contestant in found.items()
        if run.path == "view"
    }
    coarse = by_sampling["single-pass", "Midpoint", 2]
    fine = by_sampling["single-pass", "Midpoint", 0.5]
    # One channel of four differs, by 0.02 step^2.
    assert coarse.rmse == pytest.approx(0.08 / 2, rel=1e-4)
    assert fine.rmse == pytest.approx(0.005 / 2, rel=1e-4)
    assert fine.reference_uncertainty == pytest.approx(CHECK_ERROR / 2, rel=1e-2)
    assert fine.reference == "cell-exact float64"
    assert len(pictures.references) == 2


def test_reference_is_exact_and_checked_by_another_method(calm):
    stage = FakeStage()
    measured(stage, calm, paths=("view",))
    shown = [item for item in stage.shown if item.technique == "reference"]
    assert [item.reference_method for item in shown[:2]] == ["Cell Exact", "Midpoint"]
    assert {item.reference_method for item in shown[2:]} == {"Cell Exact"}
    assert shown[1].step_voxels == 4 * 0.03125
    assert {item.termination_threshold for item in shown} == {0}
    others = {item.termination_threshold for item in stage.shown} - {0}
    assert others == {calm.termination_threshold}
    assert stage.side == 16, "the picture size was restored after the check"


def test_fine_steps_may_be_the_reference(calm):
    stage = FakeStage()
    fine = ErrorSettings(views=1, reference="Fine Steps")
    found, pictures = measured(stage, calm, paths=("view",), error=fine)
    assert pictures.label == "single-pass Midpoint step 0.03125"
    never = [item for item in stage.shown if item.termination_threshold == 0]
    assert [item.step_voxels for item in never] == [0.03125, 0.015625, 0.03125]
    assert {item.technique for item in never} == {"single-pass"}


def test_errors_can_be_measured_on_another_picture_size(calm):
    stage = FakeStage()
    larger = ErrorSettings(views=1, image_size=(80, 60))
    found, pictures = measured(stage, calm, error=larger)
    assert pictures.references[0].shape == (32, 32, 4), "twice the stage's 16"
    assert all(item.error.image_size == (32, 32) for item in found.values())


def test_settings_of_a_run_are_shown(calm):
    stage = FakeStage(captures=False)
    varied = {"slices-threaded": {"slice_threads": (1, 4)}}
    measured(stage, calm, techniques=("slices-threaded",), technique_settings=varied)
    shown = {sampling.settings for sampling in stage.shown}
    assert shown == {(("slice_threads", 1),), (("slice_threads", 4),)}


def test_no_error_views_means_no_error_but_pictures(calm):
    found, pictures = measured(FakeStage(), calm, error=ErrorSettings(views=0))
    assert all(item.error.rmse is None for item in found.values())
    assert set(pictures.by_technique) == {"single-pass", "paraview-volume"}
    run, _ = pictures.by_technique["single-pass"]
    assert (run.path, run.integrator, run.step_voxels) == ("view", "Midpoint", 1)


def test_without_the_capture_proxy_times_remain(calm):
    found, pictures = measured(FakeStage(captures=False), calm)
    assert all(item.status == OK for item in found.values())
    assert "VolumeBenchmarkViewCapture" in pictures.note
    assert not pictures.by_technique


@pytest.mark.parametrize(
    "technique, status, reason",
    [
        ("opencl", UNSUPPORTED, "Volume OpenCL"),
        ("compute", FAILED, "did not compile"),
        ("slices", FAILED, "drew nothing"),
        ("multi-pass", FAILED, "RuntimeError: the driver is gone"),
    ],
)
def test_a_failing_technique_is_named_and_the_rest_goes_on(
    calm, technique, status, reason
):
    stage = FakeStage(broken="multi-pass")
    found, _ = measured(stage, calm, techniques=(technique, "paraview-volume"))
    for run, contestant in found.items():
        values = contestant.values()
        if run.technique == technique:
            assert values["status"] == status
            assert reason in values["reason"]
            assert "frame_ms" not in values
        else:
            assert values["status"] == OK


def test_a_broken_reference_leaves_errors_absent(calm):
    stage = FakeStage(broken="reference")
    found, pictures = measured(stage, calm, techniques=("paraview-volume",))
    assert "no reference" in pictures.note
    assert all(item.status == OK for item in found.values())
    assert all(item.error.rmse is None for item in found.values())


def test_ours_tells_samples_and_set_up_of_still_pictures_only(calm):
    found, _ = measured(FakeStage(), calm, paths=("view", "interactive"))
    for run, contestant in found.items():
        values = contestant.values()
        ours = run.technique != "paraview-volume"
        counted = run.path == "view" or not ours
        assert (values["samples_taken"] is not None) == counted
        assert values["setup_ms"].upload == (3.0 if ours else None)
        assert values["setup_ms"].grid is None, "what is no number is absent"
        assert values["left_out"] == (("lighting", "clipping") if ours else None)
        assert values["bytes_on_device"] == (4096 if ours else None)


def counts(red=7.0, green=2.0, blue=1.0):
    picture = np.zeros((2, 3, 4), np.float32)
    picture[0, 0] = (red, green, blue, 0.5)
    picture[1, 2] = (3, 0, 0, 0)
    return picture


def test_samples_are_summed_over_the_picture():
    assert sample_count(counts(), peer=False) == SampleCount(10, 2, 1)
    assert sample_count(counts(green=0.25), peer=True) == SampleCount(10)


@pytest.mark.parametrize(
    "picture",
    [counts(red=0.5), counts(green=0.5), counts(blue=np.nan), np.zeros((2, 2, 4))],
)
def test_a_picture_that_holds_no_counts_is_not_summed(picture):
    assert sample_count(picture, peer=False) is None
