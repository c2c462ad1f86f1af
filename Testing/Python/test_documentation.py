"""The pages of ./run docs: built whole, without dead links, and true about properties and tests."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Documentation" / "Build"))

import reference  # noqa: E402
import web_pages  # noqa: E402

END_TO_END = ROOT / "Testing" / "EndToEnd"


@pytest.fixture(scope="module")
def plugin_xml() -> list[str]:
    return reference.plugin_xml()


def properties_in(text: str) -> set[str]:
    """Return the names of all properties that XML defines, by another way than the reference's."""
    return set(
        re.findall(
            r'<\w*(?:Vector|Input|Proxy)?Property\b[^>]*?\bcommand="[^"]+"', text
        )
    )


def test_every_property_of_every_proxy_is_in_the_reference(plugin_xml):
    page = reference.markdown(reference.proxies(plugin_xml))
    found = 0
    for text in plugin_xml:
        for start in properties_in(text):
            name = re.search(r'\bname="(\w+)"', start)
            if name:
                found += 1
                assert f"### `{name[1]}`" in page, f"{name[1]} is missing"
    assert found > 90, f"only {found} properties were looked for"


def test_everything_is_documented(plugin_xml):
    for proxy in reference.proxies(plugin_xml):
        assert len(proxy.text.split()) > 3, f"{proxy.name} says {proxy.text!r}"
        for one in proxy.properties:
            assert len(one.text.split()) > 3, f"{proxy.name}.{one.name}: {one.text!r}"


def test_reference_tells_values_and_techniques(plugin_xml):
    page = reference.markdown(reference.proxies(plugin_xml))
    entry = page.split("### `WorkGroupShape`")[1].split("###")[0]
    for part in ("advanced", "default `Auto`", "16x8", "Volume CUDA"):
        assert part in entry, entry
    assert "Volume Slices" not in entry, entry


def test_pages_are_built_with_all_they_show(tmp_path):
    pages = web_pages.build(tmp_path / "docs")
    assert len(pages) == len(web_pages.PAGES) + len(web_pages.GENERATED)
    for page in pages:
        text = page.read_text(encoding="utf-8")
        for link in re.findall(r'(?:href|src)="([^"#:]+)', text):
            assert (page.parent / link).is_file(), f"{page.name}: no {link}"
        assert "<h1" in text, page.name
    walk = (tmp_path / "docs" / "Documentation-walk.html").read_text()
    assert walk.count("<img") == 5, "the walk lacks pictures"


def test_a_dead_link_is_told(tmp_path):
    with pytest.raises(web_pages.DanglingLink, match="README.md: there is no away.md"):
        web_pages._link("README.md", "away.md", tmp_path)


def test_the_profiles_are_those_of_the_measurements():
    page = web_pages.profiles.markdown()
    for technique in ("single-pass", "multi-pass", "compute", "slices"):
        assert f"| {technique} | by itself |" in page, page
    assert re.search(
        r"\| single-pass \| by itself \| \d+ \| 1.00 \| 1.00 \|", page
    ), page


def test_every_technique_has_its_row_in_the_guide():
    rows = (ROOT / "Plugin" / "Techniques.cmake").read_text()
    guide = (ROOT / "Documentation" / "techniques.md").read_text()
    listed = re.findall(r"volumebench_technique\((\S+) [^)]*?LABEL \"([^\"]+)\"", rows)
    assert len(listed) > 5
    for name, label in listed:
        assert f"| {label} | `{name}` |" in guide, f"{label} has no row"


def names_of_tests() -> set[str]:
    """Return the names of all tests, without the parameters of those that have some."""
    names = set()
    for path in (ROOT / "Testing").rglob("*.cxx"):
        found = re.findall(
            r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),\s*(\w+)\)", path.read_text(), re.M
        )
        names |= {f"{suite}.{name}" for suite, name in found}
    for path in END_TO_END.rglob("*.py"):
        registered = (path.parent / "CMakeLists.txt").read_text()
        if re.search(rf"\b{path.stem}\b", registered):
            start = "gui_" if path.parent.name == "Gui" else ""
            names.add(f"EndToEnd.{start}{path.stem}")
    return names


def rows_of_peers() -> list[str]:
    text = (ROOT / "Documentation" / "peers.md").read_text()
    rows = [line for line in text.splitlines() if line.startswith("| ")][1:]
    assert len(rows) > 25
    return rows


def names_in(text: str) -> list[str]:
    return re.findall(r"`(\w+\.\w+)`", text)


def test_every_row_of_what_others_have_names_tests_that_there_are():
    known = names_of_tests()
    for row in rows_of_peers():
        named = names_in(row.split("|")[3])
        assert named, f"no test: {row}"
        for name in named:
            assert name in known, f"there is no test {name}: {row}"


def test_the_tests_named_there_are_built_and_run():
    build = ROOT / "build" / "dev"
    if not (build / "CTestTestfile.cmake").is_file():
        pytest.skip("there is no build/dev that could list its tests")
    command = ["ctest", "--test-dir", str(build), "--show-only=json-v1"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    # Prefix/Suite.Name/parameter, or EndToEnd.name.technique
    listed = {
        ".".join(part.split(".")[:2])
        for test in json.loads(done.stdout)["tests"]
        for part in test["name"].split("/")
    }
    assert len(listed) > 500, f"only {len(listed)} tests are built"
    for name in names_in((ROOT / "Documentation" / "peers.md").read_text()):
        assert name in listed, f"{name} does not run"


# What a program must have to be in the same league: each has its row.
LEAGUE = (
    "Emission and absorption", "Opacity that does not depend on the step", "per unit distance",
    "Maximum intensity", "Shading", "stop early", "control of step", "Lower quality while",
    "Full quality when still", "opaque geometry", "Crop box", "scalar types", "cell data",
    "Component, magnitude", "Uneven spacing", "Camera inside", "Perspective and parallel",
    "Several views", "larger than the device", "server apart", "ranks without seams",
    "ghost cells", "Several blocks", "without a display", "State files and traces",
)  # fmt: skip


def test_all_that_every_peer_has_is_in_the_table():
    titles = [row.split("|")[1] for row in rows_of_peers()]
    for part in LEAGUE:
        assert any(part in title for title in titles), f"no row about: {part}"
