"""A study is expanded to the right runs, and every fault in it is told in one clear line."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from volumebench.errors import StudyError
from volumebench.stability_study import is_stability_study
from volumebench.study_file import STUDY_FOLDER, find_study, load_study
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


def test_a_server_is_used_where_it_is_asked_for(study):
    assert "remote" not in study.paths
    runs = replace(study, paths=("remote",)).runs()
    assert {run.technique for run in runs} == {"single-pass", "paraview-volume"}


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


def test_blend_modes_are_scenes_of_their_own(write_json, document):
    document["blend_modes"] = ["Composite", "Maximum"]
    study = load_study(write_json(document))
    assert len(study.runs()) == len({run.key() for run in study.runs()}) == 42
    titles = [scene.title() for scene in study.scenes()]
    assert titles == ["lemniscate, ramp, 40 x 30", "lemniscate, ramp, 40 x 30, Maximum"]
    stems = [scene.file_stem() for scene in study.scenes()]
    assert stems == ["lemniscate-ramp-40x30", "lemniscate-ramp-40x30-maximum"]


@pytest.fixture
def varied(document):
    document |= {
        "techniques": ["slices", "slices-threaded"],
        "technique_settings": {
            "slices-threaded": {
                "slice_threads": [4, 1],
                "slice_target": ["RGBA32F", "RGBA8"],
            }
        },
        "step_voxels": [1],
        "integrators": ["Midpoint"],
        "paths": ["engine"],
    }
    return document


def settings_by_scene(study):
    found: dict = {}
    for run in study.runs():
        if run.technique == "slices-threaded":
            found.setdefault(run.scene.image_size, []).append(dict(run.settings))
        else:
            assert run.settings == ()
    return found


def test_technique_settings_are_a_factor_of_their_technique(write_json, varied):
    study = load_study(write_json(varied))
    assert settings_by_scene(study)[40, 30] == [
        {"slice_threads": 4, "slice_target": "RGBA32F"},
        {"slice_threads": 4, "slice_target": "RGBA8"},
        {"slice_threads": 1, "slice_target": "RGBA32F"},
        {"slice_threads": 1, "slice_target": "RGBA8"},
    ]
    assert len({run.key() for run in study.runs()}) == len(study.runs()) == 5


def test_technique_settings_vary_in_the_named_scenes_only(write_json, varied):
    varied["image_sizes"] = [[40, 30], [80, 60]]
    varied["technique_settings_scenes"] = [{"image_size": [80, 60]}]
    found = settings_by_scene(load_study(write_json(varied)))
    assert found[40, 30] == [{"slice_threads": 4, "slice_target": "RGBA32F"}]
    assert len(found[80, 60]) == 4


def test_quick_is_what_the_study_says(write_json, varied):
    varied["image_sizes"] = [[40, 30], [50, 40], [80, 60]]
    varied["technique_settings_scenes"] = [{"image_size": [80, 60]}]
    varied["timing"] = {"minimum_frames": 50, "time_limit_s": 60}
    varied["quick"] = {"step_voxels": [2], "timing": {"time_limit_s": 1}}
    study = load_study(write_json(varied))
    quick = study.quick()
    assert quick.image_sizes == study.image_sizes
    assert (study.step_voxels, quick.step_voxels) == ((1,), (2,))
    assert (quick.timing.minimum_frames, quick.timing.time_limit_s) == (50, 1)
    assert study.only(["slices"]).quick().techniques == ("slices",)


def test_quick_picks_datasets_by_name(write_json, document):
    document["datasets"] = [{"name": "mri"}, {"name": "lemniscate"}]
    document["transfer_functions"] = {"mri": ["a"], "lemniscate": ["b"]}
    document["quick"] = {"datasets": ["lemniscate"]}
    scenes = load_study(write_json(document)).quick().scenes()
    assert [scene.dataset for scene in scenes] == ["lemniscate"]


def test_the_opengl_study_keeps_all_its_scenes_when_quick():
    study = load_study(find_study("opengl"))
    assert study.quick().scenes() == study.scenes()
    assert len(study.scenes()) == 12
    assert study.quick().timing.time_limit_s < study.timing.time_limit_s


def test_lighting_notes_and_error_size(write_json, document):
    document |= {"lighting": True, "lighting_damping": 0.1, "notes": ["Slow here."]}
    document["error"] = {"image_size": [20, 10]}
    study = load_study(write_json(document))
    assert (study.lighting, study.lighting_damping) == ((True,), 0.1)
    assert study.notes == ("Slow here.",)
    assert study.error_size(study.scenes()[0]) == (20, 10)
    assert json.loads(json.dumps(study.settings())) == study.settings()


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


def settings_of(technique, **settings):
    return changed("technique_settings", {technique: settings})


BALL = {"name": "ball"}


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
        (changed("paths", ["elsewhere"]), "paths[0]", "elsewhere"),
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
        (changed("blend_modes", ["Sum"]), "blend_modes[0]", "Sum"),
        (changed("lighting", "on"), "lighting", "on"),
        (changed("lighting_damping", 2), "lighting_damping", "2"),
        (changed("error", {"image_size": [0, 5]}), "error.image_size[0]", "0"),
        (changed("quick", {"techniques": ["slices"]}), "quick", "techniques"),
        (changed("quick", {"datasets": ["mri"]}), "quick.datasets", "mri"),
        (changed("quick", {"timing": {"speed": 1}}), "quick.timing", "speed"),
        (settings_of("slices", slice_threads=[1]), "slices", "slice_extent"),
        (settings_of("paraview-volume", slice_threads=[1]), "paraview-volume", "none"),
        (settings_of("warp", slice_threads=[1]), "technique_settings", "warp"),
        (settings_of("slices", slice_target=[]), "slice_target", "at least one"),
        (settings_of("slices", slice_target=["RGB"]), "slice_target", "'RGB'"),
        (settings_of("slices-threaded", slice_threads=[3]), "slice_threads", "3"),
        (settings_of("slices-threaded", slice_threads=[True]), "threads", "True"),
        (settings_of("compute", work_group_shape=["16"]), "shape", "16x8"),
        (
            changed("technique_settings_scenes", [{"dataset": "mri"}]),
            "technique_settings_scenes[0]",
            "dataset mri",
        ),
        (
            changed("datasets", [{"name": "bucky", "otherwise": "mri"}]),
            "otherwise",
            "lemniscate, ball",
        ),
        (
            changed("datasets", [{"name": "bucky", "otherwise": "ball"}, BALL]),
            "ball",
            "twice",
        ),
        (changed("datasets", [BALL | {"extent": 2}]), "extent", "ball"),
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
        if not is_stability_study(path):
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
