"""Opens pages in headless Chromium and tells what happens there."""

import json
import re
import shutil
import subprocess
from pathlib import Path

CHROMIUM = shutil.which("chromium")

WATCH = """
<script>
const watched = {errors: [], images: 0, broken: [], wide: 0};
addEventListener("error", event => watched.errors.push(event.message || "a resource"), true);
for (const kind of ["error", "warn"]) console[kind] = (...words) => watched.errors.push(words.join(" "));
addEventListener("load", () => {
  for (const image of document.images) {
    watched.images += 1;
    if (!image.complete || !image.naturalWidth) watched.broken.push(image.alt);
  }
  watched.requests = performance.getEntriesByType("resource").map(item => item.name)
    .filter(name => !name.startsWith("data:"));
  watched.wide = document.documentElement.scrollWidth - innerWidth;
  const out = document.createElement("pre");
  out.id = "watched"; out.textContent = JSON.stringify(watched); document.body.append(out);
});
</script>
"""


def dump(file: Path, folder: Path, *options: str) -> subprocess.CompletedProcess:
    """Return the page after its scripts have run, as text; `folder` is for Chromium's own files."""
    command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom"]
    return subprocess.run(
        [*command, f"--user-data-dir={folder / 'profile'}", *options, file.as_uri()],
        capture_output=True,
        text=True,
        timeout=180,
    )


def written_by_page(done: subprocess.CompletedProcess, name: str) -> dict:
    """Return the JSON that a page left in its element of this id."""
    found = re.search(rf'<pre id="{name}">(.*?)</pre>', done.stdout, re.S)
    assert found, done.stderr[-2000:]
    text = found.group(1).replace("&gt;", ">").replace("&lt;", "<")
    return json.loads(text.replace("&amp;", "&"))


def watched(page: Path, folder: Path) -> dict:
    """Open a page; return its errors, how many images it has and which of them are broken, what it
    asked the network for, and by how many pixels it is wider than the window."""
    html = page.read_text(encoding="utf-8")
    copy = folder / "watched.html"
    copy.write_text(html.replace("<head>", "<head>" + WATCH, 1), encoding="utf-8")
    return written_by_page(dump(copy, folder, "--window-size=1280,900"), "watched")


def screenshot(page: Path, folder: Path, height: int = 2000) -> Path:
    """Return a picture of the upper part of a page."""
    picture = folder / "page.png"
    command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu"]
    command += [f"--user-data-dir={folder / 'profile'}", f"--screenshot={picture}"]
    command += [f"--window-size=1280,{height}", page.as_uri()]
    subprocess.run(command, capture_output=True, check=True, timeout=180)
    return picture
