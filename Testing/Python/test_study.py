"""A study is expanded to the right runs, and every fault in it is told in one clear line."""

import json
from pathlib import Path

import pytest
from volumebench.errors import StudyError
from volumebench.study import STUDY_FOLDER, find_study, load_study
from volumebench.techniques import techniques_of_plugin


def fault_of(path: Path) -> str:
    with pytest.raises(StudyError) as caught:
        load_study(path)
    message = str(caught.value)
    assert "\n" not in message
    assert str(path) in message
    return message


def test_full_factorial_with_peers_once(study):
    runs = study.runs()
    by_path = {path: [run for run in runs if run.path == path] for path in study.paths}
    for path, peer in (
        ("engine", "vtk-gpu"),
        ("view", "paraview-volume"),
        ("interactive", "paraview-volume"),
    ):
        ours = [run for run in by_path[path] if run.technique == "single-pass"]
        peers = [run for run in by_path[path] if run.technique != "single-pass"]
        assert len(ours) == 6
        assert [(run.technique, run.integrator, run.step_voxels) for run in peers] == [
            (peer, None, None)
        ]
    assert len({run.key() for run in runs}) == len(runs) == 21


def test_order_of_runs_follows_the_study(study):
    ours = [run for run in study.runs() if run.path == "engine"][:6]
    assert [(run.integrator, run.step_voxels) for run in ours] == [
        ("Midpoint", 2),
        ("Midpoint", 1),
        ("Midpoint", 0.5),
        ("Left", 2),
        ("Left", 1),
        ("Left", 0.5),
    ]


def test_defaults(study):
    assert study.camera.elevation_degrees == 20
    assert study.error.reference_step_voxels == 0.03125
    assert study.termination_threshold == 0.001
    assert study.ray_set_up == "Box"


def test_transfer_functions_per_dataset(write_json, document):
    document["datasets"] = [{"name": "mri"}, {"name": "lemniscate"}]
    document["transfer_functions"] = {"mri": ["a", "b"], "lemniscate": ["c"]}
    scenes = load_study(write_json(document)).scenes()
    assert [(scene.dataset, scene.transfer_function) for scene in scenes] == [
        ("mri", "a"),
        ("mri", "b"),
        ("lemniscate", "c"),
    ]


def test_quick_keeps_extremes_and_shortens(write_json, document):
    document["image_sizes"] = [[100, 100], [400, 300], [200, 200]]
    document["timing"] = {"minimum_frames": 50, "time_limit_s": 60}
    document["error"] = {"views": 6}
    quick = load_study(write_json(document)).quick()
    assert quick.step_voxels == (2, 0.5)
    assert quick.image_sizes == ((100, 100), (400, 300))
    assert quick.techniques == tuple(document["techniques"])
    assert quick.timing.minimum_frames < 50
    assert quick.timing.time_limit_s < 60
    assert quick.error.views == 1


def test_only_replaces_techniques(study):
    chosen = study.only(["slices", "vtk-gpu", "slices"])
    assert chosen.techniques == ("slices", "vtk-gpu")
    with pytest.raises(StudyError, match='unknown technique "fast".*single-pass'):
        study.only(["fast"])
    with pytest.raises(StudyError, match="no run is left"):
        study.only([])


def test_malformed_json_names_line_and_column(write_json):
    message = fault_of(write_json('{"schema": 1,\n  "name": }'))
    assert "line 2, column 11" in message


@pytest.mark.parametrize(
    "text, expected",
    [
        ('{"schema": 1, "schema": 1}', '"schema" appears twice'),
        ('{"schema": NaN}', "not a finite number"),
        ('{"schema": 1e999}', "not a finite number"),
        ("", "line 1, column 1"),
        ("[]", "object"),
    ],
)
def test_json_that_is_no_study(write_json, text, expected):
    assert expected in fault_of(write_json(text))


def test_text_that_is_not_utf8(tmp_path):
    path = tmp_path / "latin.json"
    path.write_bytes(b'{"name": "\xe9"}')
    assert "not UTF-8" in fault_of(path)


def test_missing_file_and_folder(tmp_path):
    assert "No such file" in fault_of(tmp_path / "absent.json")
    assert "directory" in fault_of(tmp_path)


def without(key):
    return lambda document: document.pop(key)


def changed(key, value):
    return lambda document: document.update({key: value})


@pytest.mark.parametrize(
    "change, key, value",
    [
        (without("name"), "name", "required"),
        (without("techniques"), "techniques", "required"),
        (changed("schema", 2), "schema", "1"),
        (changed("colour", 1), "colour", "unexpected"),
        (changed("name", "a/b"), "name", "a/b"),
        (changed("name", "../up"), "name", "../up"),
        (changed("datasets", []), "datasets", "at least one"),
        (changed("datasets", [{"name": "mri", "dims": [8, 8, 8]}]), "dims", "mri"),
        (changed("datasets", [{"name": "lemniscate"}] * 2), "lemniscate", "twice"),
        (
            changed("datasets", [{"name": "lemniscate", "dims": [8, 8]}]),
            "dims",
            "[8, 8]",
        ),
        (
            changed("datasets", [{"name": "lemniscate", "dims": [8, 1, 8]}]),
            "dims[1]",
            "1",
        ),
        (changed("transfer_functions", {}), "transfer_functions", "object"),
        (changed("transfer_functions", {"mri": ["a"]}), "transfer_functions", "mri"),
        (changed("techniques", ["single-pass", "warp"]), "techniques", "warp"),
        (changed("techniques", "single-pass"), "techniques", "list"),
        (changed("integrators", ["Simpson"]), "integrators[0]", "Simpson"),
        (changed("step_voxels", [1, 0]), "step_voxels[1]", "0"),
        (changed("step_voxels", [1, -1]), "step_voxels[1]", "-1"),
        (changed("step_voxels", [1, "x"]), "step_voxels[1]", "x"),
        (changed("step_voxels", []), "step_voxels", "at least one"),
        (changed("step_voxels", [1, 1.0]), "step_voxels", "different"),
        (changed("image_sizes", [[500, 0]]), "image_sizes[0][1]", "0"),
        (changed("image_sizes", [[500, 500.5]]), "image_sizes[0][1]", "500.5"),
        (changed("image_sizes", [[99999, 5]]), "image_sizes[0][0]", "16384"),
        (changed("image_sizes", [[500]]), "image_sizes[0]", "[500]"),
        (changed("paths", ["remote"]), "paths[0]", "remote"),
        (changed("camera", {"path": "orbit-q"}), "camera.path", "orbit-y"),
        (changed("camera", {"frames": 0}), "camera.frames", "at least 1"),
        (changed("camera", {"zoom": 0}), "camera.zoom", "from 0.1"),
        (
            changed("camera", {"elevation_degrees": 90}),
            "camera.elevation_degrees",
            "89",
        ),
        (changed("timing", {"minimum_frames": 0}), "timing.minimum_frames", "1"),
        (changed("timing", {"time_limit_s": 0}), "timing.time_limit_s", "above 0"),
        (changed("timing", {"relative_noise": 2}), "timing.relative_noise", "2"),
        (changed("error", {"views": 37}), "error.views", "36"),
        (changed("error", {"views": -1}), "error.views", "-1"),
        (
            changed("error", {"reference_step_voxels": 0}),
            "error.reference_step_voxels",
            "0",
        ),
        (changed("termination_threshold", 1), "termination_threshold", "1"),
        (changed("ray_set_up", "Sphere"), "ray_set_up", "Rasterised"),
    ],
)
def test_each_fault_names_key_and_value(write_json, document, change, key, value):
    change(document)
    message = fault_of(write_json(document))
    assert key in message
    assert value in message


def test_unknown_technique_lists_the_known(write_json, document):
    document["techniques"] = ["warp"]
    message = fault_of(write_json(document))
    for known in ("single-pass", "opencl", "vtk-fixed-point"):
        assert known in message


def test_techniques_without_a_path_are_refused(write_json, document):
    document["techniques"], document["paths"] = ["vtk-gpu"], ["view"]
    assert "no run is left" in fault_of(write_json(document))


def test_find_study_by_name_and_its_error():
    assert find_study("demo") == STUDY_FOLDER / "demo.json"
    with pytest.raises(StudyError, match='"nothing-such".*demo'):
        find_study("nothing-such")


def test_every_study_of_the_package_is_valid():
    for path in STUDY_FOLDER.glob("*.json"):
        assert load_study(path).runs()
        assert json.loads(path.read_text())["description"]


def test_a_new_row_of_the_plugin_list_is_known():
    text = (
        "# volumebench_technique(no CLASS No LABEL ...)\n"
        'volumebench_technique(single-pass CLASS SinglePass LABEL "Volume Single Pass")\n'
        'volumebench_technique(warp CLASS Warp\n  LABEL "Volume Warp March" REQUIRES X)\n'
    )
    assert techniques_of_plugin(text) == {
        "single-pass": "Single Pass",
        "warp": "Warp March",
    }
