"""The facts of the machine are those of results.json, and none of them ends a study."""

import json
from dataclasses import fields

from volumebench import machine
from volumebench.json_file import check_schema
from volumebench.results import Context, write_results


def test_facts_are_fields_of_the_context(tmp_path):
    facts = machine.machine_facts()
    assert set(facts) <= {field.name for field in fields(Context)}
    assert facts["cores"] >= 1 and facts["memory_gb"] > 0 and facts["kernel"]
    write_results(tmp_path, Context(**facts), [])
    document = json.loads((tmp_path / "results.json").read_text())
    check_schema(document, "results_schema.json", tmp_path / "results.json")
    assert document["context"]["kernel"] == facts["kernel"]


def test_without_a_checkout_there_is_no_commit(tmp_path, monkeypatch):
    monkeypatch.setattr(machine, "_REPOSITORY", tmp_path)
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    assert machine.machine_facts()["source"] is None


def test_what_the_machine_does_not_tell_is_none(tmp_path, monkeypatch):
    monkeypatch.setattr(machine, "_GOVERNOR", tmp_path / "absent")
    assert machine.machine_facts()["cpu_governor"] is None
