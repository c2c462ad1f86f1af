"""Pages in a browser: tables sort on a click, nothing is loaded, light and dark can be read."""

import re

import pytest
from browser import CHROMIUM, dump, written_by_page
from volumebench.html_table import html_table
from volumebench.page import page
from volumebench.tables import Table

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")

PROBE = """
<script>
const seen = {errors: []};
addEventListener("error", event => seen.errors.push(event.message));
addEventListener("load", () => {
  const heads = document.querySelectorAll("thead tr:last-child th");
  const column = index => Array.from(
    document.querySelectorAll("tbody tr"), row => row.cells[Math.min(index, row.cells.length - 1)].textContent.trim());
  seen.start = column(1);
  heads[1].click(); seen.up = column(1); seen.sort = heads[1].getAttribute("aria-sort");
  heads[1].click(); seen.down = column(1);
  heads[0].dispatchEvent(new KeyboardEvent("keydown", {key: "Enter"})); seen.words = column(0);
  seen.cleared = heads[1].getAttribute("aria-sort");
  const style = getComputedStyle(document.body);
  seen.text = style.color; seen.page = style.backgroundColor;
  seen.requests = performance.getEntriesByType("resource").map(item => item.name);
  const out = document.createElement("pre");
  out.id = "seen"; out.textContent = JSON.stringify(seen); document.body.append(out);
});
</script>
"""


def seen_in(tmp_path, body, *options):
    """Open a page in a browser; return what its probe saw."""
    file = tmp_path / "page.html"
    file.write_text(page("test", PROBE + body), encoding="utf-8")
    return written_by_page(dump(file, tmp_path, *options), "seen")


def table(*values):
    rows = tuple(
        (f"run {chr(99 - place)}", value) for place, value in enumerate(values)
    )
    return html_table(Table("Times", ("run", "ms"), rows, 1))


def test_a_click_sorts_numbers_by_value_and_absent_ones_last(tmp_path):
    seen = seen_in(tmp_path, table("9.5", "-", "10.25 (9 to 12)", "-3e-2", "1e3"))
    assert seen["errors"] == [] and seen["requests"] == []
    assert seen["start"] == ["9.5", "-", "10.25 (9 to 12)", "-3e-2", "1e3"]
    assert seen["up"] == ["-3e-2", "9.5", "10.25 (9 to 12)", "1e3", "-"]
    assert seen["down"] == ["1e3", "10.25 (9 to 12)", "9.5", "-3e-2", "-"]
    assert seen["sort"] == "ascending" and seen["cleared"] is None
    assert seen["words"] == sorted(seen["words"])


def test_columns_under_a_title_sort_and_verdicts_are_marked(tmp_path):
    rows = (("holds", "10", "2"), ("does not hold", "9", "3"))
    groups = (("", 1), ("compute", 2))
    markup = html_table(Table("T", ("verdict", "a", "b"), rows, 1, groups, True))
    assert '<span class="mark does-not-hold">does not hold</span>' in markup
    seen = seen_in(tmp_path, markup)
    assert seen["errors"] == []
    assert seen["start"] == ["10", "9"] and seen["up"] == ["9", "10"]


def test_rows_stay_under_their_scene(tmp_path):
    def row(*cells):
        return f"<tr>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"

    scene = '<tr><th class="scene" colspan="2">{}</th></tr>'
    rows = [scene.format("A"), row("x", 3), row("y", 1), scene.format("B"), row("z", 2)]
    seen = seen_in(
        tmp_path,
        f"<table><thead><tr><th>run</th><th>ms</th></tr></thead><tbody>{''.join(rows)}"
        "</tbody></table>",
    )
    assert seen["up"] == ["A", "1", "3", "B", "2"]
    assert seen["down"] == ["A", "3", "1", "B", "2"]


def brightness(color):
    return sum(map(float, re.findall(r"[\d.]+", color)[:3])) / 3


def test_text_can_be_read_in_light_and_dark(tmp_path):
    light = seen_in(tmp_path, table("1"))
    dark = seen_in(tmp_path, table("1"), "--blink-settings=preferredColorScheme=0")
    assert brightness(light["page"]) > 200 and brightness(light["text"]) < 80
    assert brightness(dark["page"]) < 50 and brightness(dark["text"]) > 180
