"""A whole study with a made-up session: rows, resume, failures, plots, pictures and report."""

import io
import json
import re
from dataclasses import replace
from types import SimpleNamespace

import pytest
from fakes import FakeSession, FakeStage
from volumebench.__main__ import main, write_views
from volumebench.errors import StudyError
from volumebench.group_watch import GroupWatch
from volumebench.progress import Progress, bar_line
from volumebench.results import read_results, record_of
from volumebench.runner import Runner, find_inputs, prepare_folder
from volumebench.study import Dataset, Timing
from volumebench.summary import headlines, lines
from volumebench.tables import text_tables


@pytest.fixture
def calm(study):
    timing = Timing(1, 4, 1.0, 60.0)
    return replace(study, timing=timing)


def run_study(study, folder, session=None, resume=False):
    earlier = prepare_folder(study, folder, resume)
    runner = Runner(
        study, find_inputs(study, None, folder / "volumes"), folder, earlier
    )
    session = session or FakeSession(study)
    runner.measure(session, Progress(len(runner.missing), io.StringIO()))
    runner.close()
    return runner, session


def test_all_rows_in_study_order(calm, tmp_path):
    runner, _ = run_study(calm, tmp_path / "out")
    context, records = read_results(tmp_path / "out" / "results.json")
    assert [record.run() for record in records] == calm.runs()
    assert all(record.status == "ok" for record in records)
    assert context.cores == 2 and runner.records == records


def test_resume_measures_only_what_is_missing(calm, tmp_path):
    run_study(calm.only(["single-pass"]), tmp_path)
    _, session = run_study(calm, tmp_path, resume=True)
    assert {run.technique for run in session.measured} == {"paraview-volume", "vtk-gpu"}
    _, records = read_results(tmp_path / "results.json")
    assert [record.run() for record in records] == calm.runs()


def test_resume_tells_settings_apart(calm, tmp_path):
    threads = {"slices-threaded": {"slice_threads": (1, 2)}}
    some = replace(calm, technique_settings=threads).only(["slices-threaded"])
    run_study(some, tmp_path)
    more = {"slices-threaded": {"slice_threads": (1, 2, 4)}}
    _, session = run_study(
        replace(some, technique_settings=more), tmp_path, resume=True
    )
    assert {run.settings for run in session.measured} == {(("slice_threads", 4),)}


def test_rows_of_a_stand_in_say_so(calm, tmp_path):
    ball = Dataset("ball", (8, 8, 8), stands_for="bucky")
    stand_in = calm.with_datasets({"lemniscate": ball})
    runner, _ = run_study(stand_in, tmp_path)
    assert {record.stand_in_for for record in runner.records} == {"bucky"}
    write_views(stand_in, tmp_path, runner, runner.records)
    assert "stands in for bucky" in (tmp_path / "report.html").read_text()
    assert "stands in for bucky" in text_tables(stand_in, runner.records)


def test_failed_rows_are_measured_again_on_resume(calm, tmp_path):
    broken = FakeSession(calm, engine_fault="no context")
    run_study(calm, tmp_path, broken)
    _, records = read_results(tmp_path / "results.json")
    assert {record.path for record in records if record.status == "failed"} == {
        "engine"
    }
    assert records[0].reason == "no context"
    _, session = run_study(calm, tmp_path, resume=True)
    assert {run.path for run in session.measured} == {"engine"}


def test_runs_of_path_remote_go_to_a_server_of_their_own(calm, tmp_path):
    paths = ("view", "interactive", "remote")
    runner, session = run_study(replace(calm, paths=paths), tmp_path)
    assert {run.path for run in session.served} == {"remote"}
    assert {record.path for record in runner.records} == set(paths)
    assert {record.status for record in runner.records} == {"ok"}


def test_without_resume_everything_is_measured_anew(calm, tmp_path):
    run_study(calm, tmp_path)
    _, session = run_study(calm, tmp_path)
    assert len(session.measured) == len(calm.runs())


def test_an_unreadable_volume_fails_its_rows_only(calm, tmp_path):
    session = FakeSession(calm, volume_fault="x.nrrd: truncated")
    runner, _ = run_study(calm, tmp_path, session)
    assert {record.reason for record in runner.records} == {"x.nrrd: truncated"}
    assert len(runner.records) == len(calm.runs())


def test_missing_inputs_are_told_before_anything_is_measured(calm, tmp_path):
    absent = replace(calm, transfer_functions={"lemniscate": ("absent",)})
    with pytest.raises(StudyError, match="absent"):
        find_inputs(absent, None, tmp_path)


def test_summary_compares_at_equal_error(calm, tmp_path):
    """Peer error 0.005 (view): Midpoint is 0.005 at step 0.5 only; ms there 85, peer 240."""
    runner, _ = run_study(calm, tmp_path)
    view = [line for line in lines(runner.records) if line.record.path == "view"]
    assert [line.record.technique for line in view] == [
        "paraview-volume",
        "single-pass",
    ]
    ours = view[1]
    assert (ours.record.integrator, ours.record.step_voxels) == ("Midpoint", 0.5)
    assert ours.matched
    assert ours.speed_up() == pytest.approx(241.5 / 86.5)
    assert view[0].speed_up() is None


def test_headline_of_each_path(calm, tmp_path):
    """Fake times: engine has no errors, so it has no fair speed-up and no headline."""
    runner, _ = run_study(calm, tmp_path)
    found = headlines(runner.records)
    assert [text.partition(":")[0] for text in found] == ["view", "interactive"]
    assert "2.8 times the frame rate of ParaView Volume" in found[0]


def test_summary_marks_what_is_not_at_equal_error(calm, tmp_path):
    coarse = replace(calm, step_voxels=(2.0, 1.5))
    runner, _ = run_study(coarse, tmp_path)
    view = [line for line in lines(runner.records) if line.record.path == "view"]
    assert not view[1].matched
    assert "* not at equal error" in text_tables(coarse, runner.records)


@pytest.fixture
def finished(calm, tmp_path):
    with_failure = calm.only(["single-pass", "opencl", "paraview-volume", "vtk-gpu"])
    runner, _ = run_study(with_failure, tmp_path)
    write_views(with_failure, tmp_path, runner, runner.records)
    return tmp_path


def test_report_is_self_contained(finished):
    html = (finished / "report.html").read_text()
    assert not re.findall(r'(?:src|href)="(?!data:)', html)
    assert html.count("data:image/png;base64,") == 7
    for text in ("How to read this", "Machine and settings", "ParaView Volume"):
        assert text in html


def test_report_and_table_name_rows_that_are_missing(finished, calm):
    html = (finished / "report.html").read_text()
    assert "unsupported" in html and "Volume OpenCL" in html
    _, records = read_results(finished / "results.json")
    assert "unsupported: OpenCL" in text_tables(calm, records)


def test_plots_and_pictures_are_written(finished):
    names = {path.name for path in finished.rglob("*.png")}
    stem = "lemniscate-ramp-40x30"
    assert names == {
        f"error-time-{stem}.png",
        f"fps-{stem}.png",
        f"{stem}-truth.png",
        *(
            f"{stem}-{name}{kind}.png"
            for name in ("single-pass", "paraview-volume")
            for kind in ("", "-difference")
        ),
    }
    for path in finished.rglob("*.png"):
        assert path.read_bytes().startswith(b"\x89PNG")


def test_report_escapes_text(calm, tmp_path):
    named = replace(calm, description="<script>alert(1)</script>")
    runner, _ = run_study(named, tmp_path)
    write_views(named, tmp_path, runner, runner.records)
    assert "<script>alert" not in (tmp_path / "report.html").read_text()


def test_a_study_without_pictures_still_reports(calm, tmp_path):
    session = FakeSession(calm, FakeStage(captures=False))
    runner, _ = run_study(calm, tmp_path, session)
    write_views(calm, tmp_path, runner, runner.records)
    assert "VolumeBenchmarkViewCapture" in (tmp_path / "report.html").read_text()
    assert not list(tmp_path.glob("plots/error-time*"))


def test_old_pictures_do_not_enter_a_new_report(finished, calm):
    prepare_folder(calm, finished, resume=False)
    assert not (finished / "pictures" / "index.json").exists()


@pytest.mark.parametrize(
    "arguments, expected",
    [
        ([], "STUDY"),
        (["absent-study"], "absent-study"),
        (["demo", "--fast"], "--fast"),
        (["demo", "--techniques", "warp"], "known: single-pass"),
        (["demo", "--techniques", ","], "no run is left"),
        (["demo", "--data", "no-such-folder"], "no-such-folder"),
    ],
)
def test_bad_command_lines_are_one_line(arguments, expected, capsys):
    assert main(arguments) == 2
    message = capsys.readouterr().err
    assert message.startswith("error: ") and message.count("\n") == 1
    assert expected in message


def test_unwritable_output_folder_is_told_first(study_file, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert main([str(study_file), "--out", str(tmp_path / "file" / "out")]) == 2
    assert "not writable" in capsys.readouterr().err


def test_resume_of_a_finished_study_needs_no_session(calm, tmp_path, capsys):
    folder = tmp_path / "out"
    path = tmp_path / "study.json"
    document = json.loads(path.read_text())
    document["timing"] = {
        "warm_up_frames": 1,
        "minimum_frames": 4,
        "relative_noise": 1.0,
        "time_limit_s": 60.0,
    }
    path.write_text(json.dumps(document))
    run_study(calm, folder)
    assert main([str(path), "--out", str(folder), "--resume"]) == 0
    assert "21 rows, 0 without a measurement" in capsys.readouterr().out


def test_rows_that_are_kept_count_once_in_the_progress(calm, tmp_path):
    """Two of four runs of the scene are kept when all four are said to be three quarters done."""
    runs = calm.runs()[:4]
    shown = []
    progress = Progress(8, io.StringIO())
    progress.show = lambda title, partial: shown.append(
        progress.finished_runs + partial
    )
    keeper = SimpleNamespace(folder=tmp_path, keep=lambda record: None)
    watch = GroupWatch(keeper, runs, None, progress)
    assert watch.next_request() == runs
    watch.take([record_of(run, None, None) for run in runs[:2]])
    watch(3.0)
    assert shown == [3.0]
    assert watch.next_request() == runs[2:], "a new process begins with the others"
    watch(1.0)
    assert shown == [3.0, 3.0]


def test_progress_bar_shows_share_and_remaining_time():
    assert "50 %  00:10 left  mri" in bar_line(0.5, 10, "mri")
    assert "--:--" in bar_line(0, 1, "mri")
    stream = io.StringIO()
    progress = Progress(4, stream)
    progress.finish(1)
    progress.show("mri", 1)
    assert "50 %" in stream.getvalue()
