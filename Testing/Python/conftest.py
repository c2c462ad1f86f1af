"""Puts the package on the path and offers small studies and records to all tests."""

import json
import sys
from pathlib import Path

import pytest

for folder in ("Python", "Testing/Support"):
    sys.path.insert(0, str(Path(__file__).resolve().parents[2] / folder))


def minimal_document() -> dict:
    return {
        "schema": 1,
        "name": "small",
        "datasets": [{"name": "lemniscate", "dims": [8, 8, 16]}],
        "transfer_functions": ["ramp"],
        "techniques": ["single-pass", "paraview-volume", "vtk-gpu"],
        "integrators": ["Midpoint", "Left"],
        "step_voxels": [2, 1, 0.5],
        "image_sizes": [[40, 30]],
    }


def ramp_document() -> dict:
    return {
        "schema": 1,
        "name": "ramp",
        "domain": "normalized",
        "opacity": [[0, 0], [0.5, 0.25], [1, 1]],
        "color": [[0, 0, 0, 1], [1, 1, 0, 0]],
        "unit_distance_voxels": 2,
    }


@pytest.fixture
def document() -> dict:
    return minimal_document()


@pytest.fixture
def write_json(tmp_path):
    """Write a JSON document, or text as it is, and return its path."""

    def write(content, name: str = "study.json") -> Path:
        path = tmp_path / name
        text = content if isinstance(content, str) else json.dumps(content)
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.fixture
def study_file(write_json, document):
    """A valid study with its transfer function beside it."""
    write_json(ramp_document(), "ramp.json")
    return write_json(document)


@pytest.fixture
def study(study_file):
    from volumebench.study_file import load_study

    return load_study(study_file)
