"""Builds the documentation as web pages: `./run docs`. Needs no network, ParaView or display.

Usage: web_pages.py FOLDER. The pages are the repository's Markdown files, the reference of properties and
the measured profiles. A link to a file that is not there is an error.
"""

import re
import shutil
import sys
from html import escape
from pathlib import Path

import markdown
import profiles
import reference

ROOT = Path(__file__).resolve().parents[2]
# In the order of the menu: file and title.
PAGES = {
    "README.md": "VolumeBench",
    "Documentation/walk.md": "Your volume in ParaView",
    "Documentation/techniques.md": "Techniques",
    "Documentation/first-study.md": "A first study",
    "Documentation/hpc.md": "Clusters",
    "Documentation/peers.md": "What others have",
    "Python/README.md": "Studies",
    "Data/README.md": "Volumes",
    "Data/Measurements/README.md": "Measurements",
    "Documentation/developers.md": "How it works",
    "CONTRIBUTING.md": "Contributing",
    "Shaders/README.md": "Kernels",
    "CHANGELOG.md": "Changes",
}
GENERATED = {"reference.md": "Properties", "profiles.md": "Measured profiles"}
STYLE = """
body { margin: 0; font: 16px/1.5 sans-serif; color: #1c2330; display: flex; }
nav { flex: 0 0 13rem; min-height: 100vh; background: #f2f4f8; padding: 1.5rem 1rem; box-sizing: border-box; }
nav a { display: block; padding: .15rem .4rem; color: #28548c; text-decoration: none; }
nav a.here { font-weight: bold; color: #1c2330; }
main { max-width: 56rem; padding: 1.5rem 2.5rem; min-width: 0; }
img { max-width: 100%; border: 1px solid #d6dbe4; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
td, th { border: 1px solid #d6dbe4; padding: .3rem .6rem; text-align: left; vertical-align: top; }
code, pre { background: #f2f4f8; font-size: .92em; }
pre { padding: .8rem; overflow-x: auto; }
"""


class DanglingLink(Exception):
    """A page points to nothing."""


def page_of(path: str) -> str:
    """Return a page's file in the built folder."""
    return (
        "index.html" if path == "README.md" else path.replace("/", "-")[:-3] + ".html"
    )


def build(folder: Path) -> list[Path]:
    """Write all pages, and the files that they show, into a folder; return the pages."""
    if folder.exists():
        shutil.rmtree(folder)
    folder.mkdir(parents=True)
    texts = {path: (ROOT / path).read_text(encoding="utf-8") for path in PAGES}
    texts["reference.md"] = reference.markdown(
        reference.proxies(reference.plugin_xml())
    )
    texts["profiles.md"] = profiles.markdown()
    written = []
    for path, text in texts.items():
        target = folder / page_of(path)
        target.write_text(_page(path, text, folder), encoding="utf-8")
        written.append(target)
    return written


def _page(path: str, text: str, folder: Path) -> str:
    body = markdown.markdown(text, extensions=["tables", "fenced_code", "toc"])
    body = re.sub(
        r'\b(href|src)="([^"#:]+)(#[^"]*)?"',
        lambda found: f'{found[1]}="{_link(path, found[2], folder)}{found[3] or ""}"',
        body,
    )
    titles = {**PAGES, **GENERATED}
    menu = "".join(
        f'<a href="{page_of(one)}"{" class=here" if one == path else ""}>{escape(title)}</a>'
        for one, title in titles.items()
    )
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        f"<title>{escape(titles[path])} - VolumeBench</title><style>{STYLE}</style></head>"
        f"<body><nav>{menu}</nav><main>{body}</main></body></html>\n"
    )


def _link(page: str, link: str, folder: Path) -> str:
    """Return a link's address in the built folder, and copy there what is no page."""
    if link in GENERATED or Path(link).name in GENERATED:
        return page_of(Path(link).name)
    target = (ROOT / page).parent.joinpath(link).resolve()
    inside = target.is_relative_to(ROOT)
    if not inside or not target.exists():
        raise DanglingLink(f"{page}: there is no {link}")
    name = str(target.relative_to(ROOT))
    if name in PAGES:
        return page_of(name)
    copy = folder / name.replace("/", "-")
    if target.is_file():
        shutil.copyfile(target, copy)
    else:
        raise DanglingLink(f"{page}: {link} is a folder; name a file")
    return copy.name


if __name__ == "__main__":
    try:
        pages = build(Path(sys.argv[1]))
    except DanglingLink as error:
        sys.exit(f"web_pages.py: {error}")
    print(f"{len(pages)} pages: {pages[0]}")
