"""Sweeps of some datasets, series and starts: what they expand to, and their faults in one line."""

import pytest
from test_study import fault_of
from volumebench.study_file import STUDY_FOLDER, load_study


def sweeping(document: dict) -> dict:
    names = ["a", "b"]
    document["datasets"] = [{"name": name, "generator": "shell"} for name in names]
    document["techniques"] = ["single-pass", "vtk-gpu"]
    document["sweeps"] = [
        {"techniques": ["single-pass"], "datasets": ["a"], "step_voxels": [1, 2]},
        {"techniques": ["single-pass"], "datasets": ["b"], "step_voxels": [4]},
        {"techniques": ["vtk-gpu"]},
    ]
    document["paths"] = ["engine"]
    document["integrators"] = ["Midpoint"]
    return document


def test_a_sweep_may_be_of_some_datasets(write_json, document):
    study = load_study(write_json(sweeping(document)))
    found = [
        (run.scene.dataset, run.technique, run.step_voxels) for run in study.runs()
    ]
    assert found == [
        *(("a", "single-pass", 1), ("a", "single-pass", 2), ("a", "vtk-gpu", None)),
        *(("b", "single-pass", 4), ("b", "vtk-gpu", None)),
    ]


@pytest.mark.parametrize("part", ["", "quick."])
@pytest.mark.parametrize("key", ["sweeps", "series"])
def test_datasets_of_sweeps_and_series_are_checked(write_json, document, part, key):
    sweeping(document)
    item = {"datasets": ["a", "c"]}
    if key == "series":
        item |= {"title": "T", "factor": "edge"}
    target = document.setdefault("quick", {}) if part else document
    target[key] = [item]
    assert f'"{part}{key}[0].datasets": "c"' in fault_of(write_json(document))


def test_a_quick_study_may_lack_datasets_of_a_series(write_json, document):
    sweeping(document)
    document["series"] = [{"title": "T", "factor": "edge", "datasets": ["a", "b"]}]
    document["quick"] = {"datasets": ["b"]}
    quick = load_study(write_json(document)).quick()
    assert {run.scene.dataset for run in quick.runs()} == {"b"}


def test_a_start_is_read_and_its_faults_are_named(write_json, document):
    start = {
        "datasets": [{"name": "a", "generator": "shell", "dims": [8, 8, 8]}],
        "transfer_function": "ramp",
        "techniques": ["single-pass", "paraview-volume"],
        "image_size": [40, 30],
    }
    document["start"] = start
    study = load_study(write_json(document))
    assert study.start.datasets[0].dims == (8, 8, 8)
    assert study.start.image_size == (40, 30) and study.start.repeats == 5
    assert study.settings()["start"]["datasets"][0]["dims"] == [8, 8, 8]
    start["techniques"] = ["vtk-gpu"]
    assert '"vtk-gpu" is not drawn in a ParaView view' in fault_of(write_json(document))
    start["techniques"] = ["single-pass"]
    start["datasets"][0]["extent"] = 2
    assert '"extent" does not apply to "shell"' in fault_of(write_json(document))


def test_speed_covers_what_it_is_for():
    """Three volumes, each sparse, translucent and opaque; coarse and fine steps; thresholds."""
    study = load_study(STUDY_FOLDER / "speed.json")
    for version in (study, study.quick()):
        scenes = version.scenes()
        assert len(scenes) == 9 and version.error.views == version.camera.frames == 3
        for kind in ("sparse", "translucent", "opaque"):
            assert sum(kind in scene.transfer_function for scene in scenes) == 3
        for technique in ("opencl", "single-pass"):
            own = [run for run in version.runs() if run.technique == technique]
            assert {run.integrator for run in own} == {"Midpoint", "Segment"}
        runs = [run for run in version.runs() if run.technique != "paraview-volume"]
        varied = {setting for run in runs for setting in run.settings}
        assert ("skipping", False) in varied, "what skipping saves is told as well"
        assert any(name == "termination_threshold" for name, _ in varied)
        assert {run.path for run in version.runs()} == {"view"}
        assert {item.dims for item in version.start.datasets} == {(256, 256, 256)}
    steps = {run.step_voxels for run in study.runs() if run.step_voxels}
    assert (max(steps), min(steps)) == (3, 0.125)


def test_scaling_covers_what_it_is_for():
    study = load_study(STUDY_FOLDER / "scaling.json")
    edges = {item.dims[0] for item in study.datasets}
    assert edges == {64, 128, 256, 512, 1024}
    shares = {item.share for item in study.datasets}
    assert (min(shares), max(shares)) == (0.01, 1)
    sizes = {scene.image_size[0] for scene in study.scenes()}
    assert sizes >= {256, 512, 1024, 2048}
    assert {series.factor for series in study.series} == {"edge", "pixels", "share"}
    assert any(series.rmse for series in study.series)
    for version in (study, study.quick()):
        runs = version.runs()
        for series in version.series:
            own = [run for run in runs if run.scene.dataset in series.datasets]
            assert len({run.scene for run in own}) > 1, series.title
            if series.rmse is None:
                sampling = (series.integrator, series.step_voxels)
                fit = [
                    run for run in own if (run.integrator, run.step_voxels) == sampling
                ]
                assert {run.scene for run in fit} == {run.scene for run in own}
