"""Studies with sweeps: the runs they have, what is refused, and a whole one with made-up figures."""

import io
import json
from dataclasses import replace

import pytest
from fakes import FakeSession
from volumebench.__main__ import write_views
from volumebench.error import ImageError
from volumebench.errors import StudyError
from volumebench.orbit import orbit_pose
from volumebench.progress import Progress
from volumebench.runner import Runner, find_inputs, prepare_folder
from volumebench.study import Camera
from volumebench.study_file import STUDY_FOLDER, load_study
from volumebench.technique_settings import TECHNIQUE_SETTINGS, variant_text
from volumebench.techniques import PARAVIEW
from volumebench.work_precision import SAMPLE_INTEGRATORS

SWEEPS = [
    {
        "techniques": ["single-pass"],
        "paths": ["engine"],
        "step_voxels": [2, 1, 0.5, 0.25],
    },
    {
        "techniques": ["single-pass"],
        "paths": ["engine"],
        "integrators": ["Midpoint"],
        "step_voxels": [0.5],
        "settings": {"termination_threshold": [0, 0.01]},
    },
    {
        "techniques": ["single-pass"],
        "paths": ["engine", "view"],
        "integrators": ["Midpoint"],
        "step_voxels": [2, 0.5],
    },
    {"techniques": ["paraview-volume"], "paths": ["view"]},
    {
        "techniques": ["vtk-gpu"],
        "paths": ["engine"],
        "settings": {"sample_distance_voxels": [1, 0.5]},
    },
]


@pytest.fixture
def swept(document):
    document |= {
        "integrators": ["Left", "Midpoint"],
        "step_voxels": [1],
        "paths": ["engine", "view"],
        "sweeps": SWEEPS,
        "camera": {"path": "three-views", "frames": 3},
        "error": {"views": 3},
    }
    return document


@pytest.fixture
def study(write_json, study_file, swept):
    return load_study(write_json(swept))


def test_runs_are_the_sweeps_and_not_their_product(study):
    found = [
        (run.technique, run.path, run.integrator, run.step_voxels, dict(run.settings))
        for run in study.runs()
    ]
    ours = [
        ("single-pass", "engine", name, step, {})
        for name in ("Left", "Midpoint")
        for step in (2, 1, 0.5, 0.25)
    ]
    ours += [
        ("single-pass", "engine", "Midpoint", 0.5, {"termination_threshold": value})
        for value in (0, 0.01)
    ]
    ours += [("vtk-gpu", "engine", None, None, {"sample_distance_voxels": 1})]
    ours += [("vtk-gpu", "engine", None, None, {"sample_distance_voxels": 0.5})]
    ours += [("single-pass", "view", "Midpoint", step, {}) for step in (2, 0.5)]
    ours += [("paraview-volume", "view", None, None, {})]
    assert found == ours, "what two sweeps share is one run"


def test_other_techniques_leave_their_sweeps_out(study):
    runs = study.only(["vtk-gpu"]).runs()
    assert {run.technique for run in runs} == {"vtk-gpu"} and len(runs) == 2
    with pytest.raises(StudyError, match="no run is left"):
        study.only(["compute"])


def test_quick_may_have_sweeps_of_its_own(write_json, study_file, swept):
    swept["quick"] = {"sweeps": [SWEEPS[3]]}
    study = load_study(write_json(swept))
    assert [run.technique for run in study.quick().runs()] == ["paraview-volume"]


def with_sweep(**sweep):
    return lambda document: document.update(sweeps=[sweep])


@pytest.mark.parametrize(
    "change, expected",
    [
        (with_sweep(techniques=["compute"]), '"sweeps[0].techniques": "compute"'),
        (with_sweep(techniques=["single-pass"], settings={"colour": [1]}), "colour"),
        (
            with_sweep(
                techniques=["single-pass"], settings={"termination_threshold": [1]}
            ),
            "0 to 0.999999",
        ),
        (
            with_sweep(techniques=["vtk-gpu"], settings={"table_size": [64]}),
            '"sweeps[0].settings.vtk-gpu"',
        ),
        (with_sweep(steps=[1]), "steps"),
        (lambda document: document.update(sweeps=[]), "sweeps"),
        (
            lambda document: document["camera"].update(frames=4),
            "three-views has 3 frames, not 4",
        ),
    ],
)
def test_faults_of_sweeps_are_named(write_json, swept, change, expected):
    change(swept)
    with pytest.raises(StudyError) as caught:
        load_study(write_json(swept))
    assert expected in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "name, good, bad",
    [
        ("termination_threshold", [0, 0.001, 0.9], [-0.1, 1.0, "0.1", True]),
        ("table_size", [0, 64], [-1, 64.5, "64", 10**9]),
        ("jitter", [0, 1], [2, True, "1", 0.5]),
        ("jitter_seed", [0, 16777215], [-1, 16777216, 0.5, "1", True]),
        ("sample_distance_voxels", [0.0625, 1, 4.0], [0, 101, None]),
    ],
)
def test_numbers_are_settings_within_limits(name, good, bad):
    setting = TECHNIQUE_SETTINGS[name]
    assert all(setting.accepts(value) for value in good)
    assert not any(setting.accepts(value) for value in bad)


def test_a_run_is_told_to_the_filter_in_full():
    settings = (("table_size", 64), ("termination_threshold", 0.001))
    assert variant_text("compute", "Left", 0.0625, settings) == (
        "compute; integrator=Left; step_voxels=0.0625; table_size=64; "
        "termination_threshold=0.001"
    )
    assert variant_text("vtk-gpu", None, None, ()) == "vtk-gpu"


def test_three_views_look_along_x_along_z_and_obliquely():
    camera = Camera(path="three-views", frames=3)
    box = (0, 2, 0, 2, 0, 2)
    poses = [orbit_pose(frame, 3, box, camera) for frame in range(3)]
    away = [[p - c for p, c in zip(pose.position, pose.focal_point)] for pose in poses]
    assert away[0][0] > 1 and away[0][1:] == pytest.approx([0, 0])
    assert away[1][2] > 1 and away[1][:2] == pytest.approx([0, 0])
    assert min(away[2]) > 1


class ErrorSession(FakeSession):
    """Engine rows have errors and samples too: of second order, beside a peer of first order."""

    def run_engine(self, volume, function, runs, report):
        records, pictures = super().run_engine(volume, function, runs, report)
        return [self._with_error(record) for record in records], pictures

    @staticmethod
    def _with_error(record):
        step = record.step_voxels or 0.5
        exponent = 2 if record.integrator in SAMPLE_INTEGRATORS else 1
        error = ImageError(rmse=4e-3 * step**exponent, reference_uncertainty=1e-7)
        return replace(record, error=error, samples_taken=int(4000 / step))


@pytest.fixture
def folder(study, tmp_path):
    """The output folder of the study, measured by a session that makes its figures up."""
    target = tmp_path / "out"
    earlier = prepare_folder(study, target, False)
    inputs = find_inputs(study, None, target / "volumes")
    runner = Runner(study, inputs, target, earlier)
    study = replace(study, timing=replace(study.timing, relative_noise=1.0))
    runner.measure(ErrorSession(study), Progress(len(runner.missing), io.StringIO()))
    write_views(study, target, runner, runner.records)
    return target


def test_report_opens_with_the_sentence(folder):
    html = (folder / "report.html").read_text()
    sentence = html.partition('<p class="lead">')[2].partition("</p>")[0]
    assert sentence.startswith("At equal error, VolumeBench draws still pictures")
    assert "over 1 scene;" in sentence
    assert html.index('<p class="lead">') < html.index("<h2>")
    for title in ("Speed-up over ParaView Volume", "Samples at", "Order of"):
        assert title in html


def test_tables_of_a_sweep_are_printed(folder, capsys, study):
    from volumebench.results import read_results
    from volumebench.findings import sweep_findings

    _, records = read_results(folder / "results.json")
    text = sweep_findings(records).text()
    assert text.startswith("At equal error")
    assert "lemniscate, ramp, 40 x 30" in text


def test_samples_of_paraview_are_counted_in_the_timed_size(folder):
    rows = json.loads((folder / "results.json").read_text())["runs"]
    (row,) = [item for item in rows if item["technique"] == PARAVIEW]
    assert row["samples_taken"] == 1000 * 16


def test_figure_of_a_sweep_is_written(folder):
    picture = folder / "plots" / "error-time-lemniscate-ramp-40x30.png"
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_error_vs_time_covers_what_it_is_for():
    study = load_study(STUDY_FOLDER / "error-vs-time.json")
    for version in (study, study.quick()):
        runs = version.runs()
        assert {run.integrator for run in runs if run.technique == "single-pass"} == {
            *("Left", "Midpoint", "Segment", "PreIntegrated")
        }
        assert len({run.scene.transfer_function for run in runs}) >= 6
        assert {run.technique for run in runs} >= {PARAVIEW, "vtk-gpu", "slices"}
        varied = {name for run in runs for name, _ in run.settings}
        assert varied >= {"termination_threshold", "table_size", "slice_target"}
        for scene in version.scenes():
            count = sum(run.scene == scene for run in runs)
            assert count < 130, "one axis at a time, not their product"
        # Curves are densest at the steps that people use.
        for integrator in ("Midpoint", "Segment"):
            near = {
                run.step_voxels
                for run in runs
                if (run.technique, run.integrator) == ("single-pass", integrator)
            }
            assert near >= {1.5, 1.25, 1, 0.75, 0.5}
    steps = {run.step_voxels for run in study.runs() if run.step_voxels}
    assert (max(steps), min(steps)) == (4, 1 / 64)
    assert study.timing.minimum_frames >= 10
    data = {dataset.name for dataset in study.quick().datasets}
    assert data == {"waves", "lemniscate", "mri"}, "quick needs no --data"
