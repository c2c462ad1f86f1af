"""Studies that are killed, interrupted, crash, hang, or run out of disk lose nothing but that."""

import json
import os
import random
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from volumebench.errors import BenchError
from volumebench.journal import FILE as JOURNAL_FILE
from volumebench.journal import FolderLock, Journal, read_journal
from volumebench.results import FrameLog, read_results
from volumebench.study_file import load_study

PROGRAM = Path(__file__).with_name("long_run.py")
TIMING = {"minimum_frames": 8, "relative_noise": 1, "time_limit_s": 60}


@pytest.fixture
def long_study(write_json, document, study_file):
    """21 runs of 8 frames, each of which takes a few milliseconds."""
    document["timing"] = TIMING
    return write_json(document, "long.json")


def start(study, folder, *options, fault="none", limit_bytes=None):
    """Start a study whose session is made up; `fault` is what that does wrong."""
    environment = os.environ | {"VOLUMEBENCH_TEST_FAULT": fault}
    paths = [str(PROGRAM.parent), str(PROGRAM.parents[2] / "Python")]
    environment["PYTHONPATH"] = os.pathsep.join(paths)

    def limit():
        if limit_bytes is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit_bytes, limit_bytes))

    return subprocess.Popen(
        [sys.executable, str(PROGRAM), str(study), str(folder), *options],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=limit,
    )


def finish(study, folder, *options, **more):
    """Run a study to its end; return exit code and what it wrote on stderr."""
    process = start(study, folder, *options, **more)
    _, errors = process.communicate(timeout=120)
    return process.returncode, errors


def outcome(folder):
    """Return what must not depend on interruptions: each run, status, frames and error."""
    _, records = read_results(folder / "results.json")
    return [
        (row.run().key(), row.status, row.frames, row.frame_log.frame, row.error.rmse)
        for row in records
    ]


def test_killed_at_any_moment_a_study_ends_with_the_rows_of_an_unbroken_one(
    long_study, tmp_path
):
    assert finish(long_study, tmp_path / "whole")[0] == 0
    expected = outcome(tmp_path / "whole")
    assert len(expected) == 21 and {row[1] for row in expected} == {"ok"}
    moments = random.Random(20)
    folder, kept = tmp_path / "killed", [0]
    for _ in range(20):
        goal = frames_drawn(folder) + moments.randint(0, 18)
        process = start(long_study, folder, "--resume")
        while frames_drawn(folder) < goal and process.poll() is None:
            time.sleep(0.002)
        time.sleep(moments.uniform(0, 0.02))
        process.kill()
        process.communicate()
        kept.append(frames_kept(folder))
        if (folder / "results.json").exists():
            read_results(folder / "results.json")
    assert finish(long_study, folder, "--resume")[0] == 0
    assert outcome(folder) == expected
    assert not (folder / JOURNAL_FILE).exists()
    assert kept == sorted(kept) and len(set(kept)) > 8 and kept[-1] > 60, kept


def frames_drawn(folder):
    """Return the frames that were drawn in a folder, kept or not."""
    drawn = folder / "drawn"
    return len(drawn.read_text().split()) if drawn.exists() else 0


def frames_kept(folder):
    """Return the frames that the next run need not draw."""
    if not folder.is_dir():
        return 0
    measured = read_journal(folder)
    return sum(len(item.log.ms) for item in measured.progress.values())


def test_a_kill_loses_one_block_of_frames_at_most(long_study, tmp_path):
    process = start(long_study, tmp_path / "out")
    while frames_drawn(tmp_path / "out") < 60:
        time.sleep(0.01)
    process.kill()
    process.communicate()
    assert frames_drawn(tmp_path / "out") - frames_kept(tmp_path / "out") <= 3


def test_a_crash_takes_only_its_own_row(long_study, tmp_path):
    code, errors = finish(long_study, tmp_path, fault="crash")
    assert code == 0, errors
    _, records = read_results(tmp_path / "results.json")
    assert len(records) == 21
    failed = [row for row in records if row.status != "ok"]
    assert [(row.integrator, row.step_voxels) for row in failed] == [("Left", 1.0)]
    assert failed[0].status == "failed"
    assert "crashed: its process ended with SIGSEGV" in failed[0].reason
    assert "at work on frames" in failed[0].reason


def test_a_hang_takes_only_its_own_row(long_study, tmp_path):
    code, errors = finish(long_study, tmp_path, "--hang-limit", "5", fault="hang")
    assert code == 0, errors
    _, records = read_results(tmp_path / "results.json")
    failed = [row for row in records if row.status != "ok"]
    assert len(records) == 21 and len(failed) == 1
    assert "hung: no sign of life for 5 s" in failed[0].reason


def test_a_session_that_never_opens_is_one_clear_line(long_study, tmp_path):
    code, errors = finish(long_study, tmp_path, fault="no-session")
    assert code == 2, errors
    assert errors.strip() == "error: the plugin is not for this machine"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_keeps_what_was_measured(long_study, tmp_path, number):
    process = start(long_study, tmp_path)
    while frames_kept(tmp_path) < 40:
        time.sleep(0.02)
    process.send_signal(number)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted; --resume keeps" in errors and "Traceback" not in errors
    assert frames_kept(tmp_path) >= 40
    json.loads((tmp_path / "results.json").read_text())
    assert finish(long_study, tmp_path, "--resume")[0] == 0
    assert len(outcome(tmp_path)) == 21


def test_a_worker_ends_with_its_parent(long_study, tmp_path):
    process = start(long_study, tmp_path, fault="hang")
    while not (tmp_path / "worker").exists():
        time.sleep(0.02)
    worker = int((tmp_path / "worker").read_text())
    process.kill()
    process.communicate()
    for _ in range(500):
        if not Path(f"/proc/{worker}").exists() or is_zombie(worker):
            return
        time.sleep(0.02)
    pytest.fail("the worker outlived its parent")


def is_zombie(process):
    return (
        Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    )


def test_two_runs_in_one_folder_refuse_each_other(long_study, tmp_path):
    first = start(long_study, tmp_path)
    while frames_kept(tmp_path) < 1:
        time.sleep(0.02)
    code, errors = finish(long_study, tmp_path, "--resume")
    assert code == 2 and errors.count("\n") == 1
    assert f"another run measures into this folder (process {first.pid})" in errors
    assert first.wait(timeout=60) == 0
    assert len(outcome(tmp_path)) == 21


def test_a_killed_run_leaves_no_lock(tmp_path):
    code = (
        "import os, signal, sys; from pathlib import Path;"
        "from volumebench.journal import FolderLock;"
        "lock = FolderLock(Path(sys.argv[1])); os.kill(os.getpid(), signal.SIGKILL)"
    )
    path = os.pathsep.join([str(PROGRAM.parents[2] / "Python")])
    subprocess.run(
        [sys.executable, "-c", code, str(tmp_path)],
        env=os.environ | {"PYTHONPATH": path},
        check=False,
    )
    FolderLock(tmp_path).close()


def test_a_full_disk_is_one_clear_line_and_keeps_what_was_written(long_study, tmp_path):
    assert finish(long_study, tmp_path / "whole")[0] == 0
    folder = tmp_path / "full"
    code, errors = finish(long_study, folder, limit_bytes=6000)
    assert code == 2, errors
    line = errors.strip().splitlines()[-1]
    assert line.startswith("error: ") and "cannot be written: File too large" in line
    assert "Traceback" not in errors
    assert finish(long_study, folder, "--resume")[0] == 0
    assert outcome(folder) == outcome(tmp_path / "whole")


def test_a_device_that_is_full_is_told(tmp_path, monkeypatch, long_study):
    (tmp_path / JOURNAL_FILE).symlink_to("/dev/full")
    study = load_study(long_study)
    with pytest.raises(BenchError, match="journal.jsonl: cannot be written: No space"):
        Journal(tmp_path).frames(study.runs()[0], FrameLog([0], [1.0], [None]))


def test_an_unfinished_line_counts_for_nothing_and_a_damaged_one_is_named(
    long_study, tmp_path
):
    run = load_study(long_study).runs()[0]
    path = tmp_path / JOURNAL_FILE
    journal = Journal(tmp_path)
    for frame in range(3):
        journal.frames(run, FrameLog([frame], [1.0 + frame], [None]))
    journal.close()
    whole = path.read_bytes()
    path.write_bytes(whole[:-7])
    assert read_journal(tmp_path).of(run).log.ms == [1.0, 2.0]
    journal = Journal(tmp_path)
    journal.frames(run, FrameLog([9], [9.0], [2.5]))
    journal.close()
    assert read_journal(tmp_path).of(run).log == FrameLog(
        [0, 1, 9], [1.0, 2.0, 9.0], [None, None, 2.5]
    )
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(lines[0] + b"{broken\n" + lines[2])
    with pytest.raises(BenchError, match="line 2 is damaged"):
        read_journal(tmp_path)
