"""Comparing two results: verdicts, exit codes and what is written, on made-up results."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest
from volumebench.__main__ import main
from volumebench.bootstrap import geometric_mean, ratio_sample
from volumebench.compare import compare
from volumebench.error import ImageError
from volumebench.results import Context, FrameLog, record_of, times, write_results


def noisy_log(median_ms, seed, noise=0.05, frames=12, rounds=3, view_factor=3.0):
    """Frames of a path on which some views take `view_factor` times as long as others."""
    random = np.random.default_rng(seed)
    log = FrameLog()
    for index in range(frames * rounds):
        frame = index % frames
        view = 1 + (view_factor - 1) * frame / (frames - 1)
        ms = median_ms * view * random.lognormal(0, noise)
        log.extend(FrameLog([frame], [float(ms)], [None]))
    return log


def row(run, median_ms, seed, rmse=0.01, **more):
    error = ImageError(rmse=rmse, reference_uncertainty=1e-5)
    log = noisy_log(median_ms, seed, **more)
    return record_of(run, (8, 8, 8), "uint8", error=error, **times(log))


@pytest.fixture
def rows(study):
    return [row(run, 10.0, seed) for seed, run in enumerate(study.runs()[:12])]


def again(rows, factor=1.0, rmse=None, seed=1000):
    """The same runs, measured a second time."""
    return [
        row(
            old.run(),
            10.0 * factor,
            seed + index,
            rmse=old.error.rmse if rmse is None else rmse,
        )
        for index, old in enumerate(rows)
    ]


def verdicts(old, new):
    comparison = compare((Context(), old), (Context(), new))
    return comparison, [(item.speed, item.accuracy) for item in comparison.changes]


def test_a_second_measurement_of_the_same_is_no_regression(rows):
    for seed in range(20):
        comparison, found = verdicts(rows, again(rows, seed=1000 + 100 * seed))
        assert not comparison.is_regression(), found
        assert {speed for speed, _ in found} == {"undecided"}


def test_slower_and_faster_are_found_though_views_differ_threefold(rows):
    comparison, found = verdicts(rows, again(rows, 1.3))
    assert found == [("slower", "as accurate")] * 12 and comparison.is_regression()
    comparison, found = verdicts(rows, again(rows, 0.75))
    assert found == [("faster", "as accurate")] * 12
    assert not comparison.is_regression()


def test_one_slow_run_among_many_is_found(rows):
    new = again(rows)
    new[3] = row(rows[3].run(), 14.0, 77)
    comparison, _ = verdicts(rows, new)
    assert [item.new for item in comparison.of("slower")] == [new[3]]
    assert comparison.is_regression()


def test_what_noise_hides_is_undecided(study):
    run = study.runs()[0]
    loud = {"noise": 1.0, "rounds": 1}
    _, found = verdicts([row(run, 10, 1, **loud)], [row(run, 12, 2, **loud)])
    assert found[0][0] == "undecided"


def test_accuracy_counts_beyond_the_uncertainty_of_the_references(rows):
    def accuracy(rmse):
        return verdicts(rows[:1], again(rows[:1], rmse=rmse))[1][0][1]

    assert accuracy(0.02) == "less accurate" and accuracy(0.005) == "more accurate"
    assert accuracy(0.01005) == "as accurate"
    comparison, _ = verdicts(rows, again(rows, rmse=0.02))
    assert comparison.is_regression()


def test_a_row_that_is_no_longer_measured_is_a_regression(rows):
    failed = replace(rows[0], status="failed", reason="crashed")
    comparison, _ = verdicts(rows, [failed, *again(rows)[1:]])
    assert comparison.is_regression() and comparison.lost == (failed,)
    comparison, _ = verdicts([failed, *rows[1:]], again(rows))
    assert not comparison.is_regression() and len(comparison.won) == 1


def test_results_without_frames_say_where_their_noise_comes_from(rows):
    old = [replace(item, frame_log=None) for item in rows]
    comparison, found = verdicts(old, again(rows))
    assert {item.sample.basis for item in comparison.changes} == {"quartiles"}
    assert {speed for speed, _ in found} == {"undecided"}
    once = [replace(item, frames=1) for item in old]
    comparison, found = verdicts(once, again(rows, 5))
    assert {item.ratio.low for item in comparison.changes} == {None}
    assert {speed for speed, _ in found} == {"undecided"}


@pytest.mark.parametrize(
    "given, width",
    [
        ({}, 0.1),
        ({"frames": 36, "rounds": 1}, 0.1),
        ({"frames": 3, "rounds": 12}, 0.1),
        ({"frames": 6, "rounds": 1}, 0.25),
    ],
)
def test_the_interval_holds_the_true_ratio_about_as_often_as_it_says(
    study, given, width
):
    """Of 400 pairs with a true ratio of 1.1; views differ threefold, repeats by 5 %."""
    run = study.runs()[0]
    inside, widths = 0, []
    for seed in range(400):
        over, under = row(run, 11.0, 2 * seed, **given), row(
            run, 10.0, 2 * seed + 1, **given
        )
        ratio = ratio_sample(over, under).interval()
        inside += ratio.low <= 1.1 <= ratio.high
        widths.append(ratio.high / ratio.low - 1)
    assert 0.925 <= inside / 400 <= 0.99
    assert np.median(widths) < width


def test_the_mean_of_ratios_is_surer_than_each(rows):
    samples = [ratio_sample(new, old) for new, old in zip(again(rows, 1.2), rows)]
    mean, one = geometric_mean(samples), samples[0].interval()
    assert mean.value == pytest.approx(1.2, rel=0.03)
    assert mean.high - mean.low < 0.6 * (one.high - one.low)
    assert mean.low < mean.value < mean.high


@pytest.fixture
def files(tmp_path, rows):
    def write(name, records, context=Context(cpu="a", cores=2)):
        folder = tmp_path / name
        folder.mkdir()
        write_results(folder, context, records)
        return folder / "results.json"

    return write


def test_exit_codes_and_files(files, rows, tmp_path, capsys):
    old = files("old", rows)
    same, slow = files("same", again(rows)), files("slow", again(rows, 1.5))
    assert main(["--compare", str(old), str(same)]) == 0
    assert (tmp_path / "same" / "compare" / "compare.html").is_file()
    out = tmp_path / "out"
    assert main(["--compare", str(old), str(slow), "--out", str(out)]) == 1
    text = capsys.readouterr().out
    assert "12 slower" in text and "Slower\n" in text
    for name in ("compare.png", "compare.svg", "compare.csv", "compare.html"):
        assert (out / name).stat().st_size > 100
    table = list(csv.DictReader((out / "compare.csv").open()))
    assert len(table) == 12 and {line["speed"] for line in table} == {"slower"}
    assert float(table[0]["low"]) > 1.3


def test_another_machine_is_told(files, rows, capsys):
    old = files("old", rows)
    new = files("new", again(rows), Context(cpu="b", cores=2))
    main(["--compare", str(old), str(new)])
    assert "not the same machine: cpu was a and is b" in capsys.readouterr().out


def test_bad_input_is_one_line(files, rows, tmp_path, capsys):
    old = files("old", rows)
    (tmp_path / "bad.json").write_text('{"schema": 1')
    none = files("none", [replace(rows[0], dataset="other")])
    for new, expected in (
        (tmp_path / "absent.json", "cannot be read"),
        (tmp_path / "bad.json", "line 1"),
        (none, "no measured run in common"),
    ):
        assert main(["--compare", str(old), str(new)]) == 2
        message = capsys.readouterr().err
        assert message.count("\n") == 1 and expected in message
    assert main(["demo", "--compare", str(old), str(old)]) == 2
    assert main([]) == 2
    assert "either STUDY or --compare" in capsys.readouterr().err


def test_short_lists_stand_on_one_line(files, rows):
    path = files("old", rows)
    assert '"frame": [0, 1, 2,' in path.read_text()
    assert json.loads(path.read_text())["runs"][0]["frame_log"]["frame"][:3] == [
        0,
        1,
        2,
    ]
