"""A self-contained report.html: figures, tables, pictures and failures, readable offline."""

from dataclasses import asdict
from html import escape
from pathlib import Path

from .calibration import ceiling_table, profile_table
from .findings import Findings
from .gallery import FOLDER as PICTURE_FOLDER
from .gallery import Gallery, read_galleries
from .html_table import html_table
from .json_file import write_atomically
from .page import head, page
from .plot import FOLDER as PLOT_FOLDER
from .plot import error_plot_file, fps_plot_file, inlined
from .plot_style import PATH_TITLES
from .report_style import HOW_CEILINGS_ARE_READ, HOW_TO_READ
from .results import Context, Record
from .study import COMPOSITE, Scene, Study
from .notes import SLOW_FACTOR, all_notes
from .report_rows import line_table
from .summary import (
    Line,
    counted,
    headlines,
    in_scene,
    is_peer,
    lines,
    missing_groups,
    scene_remarks,
    scenes_of,
    shared_settings,
    shared_text,
)
from .tables import feature_table, setting_tables, slow_table, stage_table
from .techniques import REFERENCE_TECHNIQUE, TECHNIQUES

UNLESS = ", unless the settings of a row say otherwise"
_CONTEXT_TITLES = {
    "date": "Date (UTC)",
    "host": "Host",
    "cpu": "Processor",
    "cores": "Cores",
    "gl_renderer": "OpenGL renderer",
    "gl_version": "OpenGL version",
    "paraview": "ParaView",
    "vtk": "VTK",
    "plugin": "Plugin",
    "build_type": "Build type",
    "cuda_device": "CUDA device",
    "opencl_device": "OpenCL device",
    "os": "System",
    "kernel": "Kernel",
    "memory_gb": "Memory (GB)",
    "cpu_governor": "Governor of the processor's clock",
    "load_average": "Load before measuring",
    "source": "Sources",
}


def write_report(
    folder: Path,
    study: Study,
    context: Context,
    records: list[Record],
    notes: list[str],
    findings: Findings | None = None,
) -> None:
    """Write report.html with everything inlined."""
    galleries = {gallery.scene: gallery for gallery in read_galleries(folder)}
    shared = shared_settings(records)
    scenes = [
        _scene_section(folder, scene, records, galleries.get(scene.title()), shared)
        for scene in scenes_of(records)
    ]
    body = "\n".join(
        [
            head(study.name, study.description, context),
            _findings(folder, findings),
            _summary(records, shared) if study.paper is None else "",
            f'<section class="read"><h2>How to read this</h2>{HOW_TO_READ}</section>',
            *scenes,
            _ceilings(context, records),
            _notes(study, records),
            _failures(records, notes),
            _settings(study, context, records),
        ]
    )
    title = f"VolumeBench: {study.name}"
    write_atomically(folder / "report.html", page(title, body))


def _summary(records: list[Record], shared: frozenset[str]) -> str:
    """The headline: per scene and path, the peer and each technique at its error."""
    shown = lines(records)
    if not shown:
        return "<section><h2>Result</h2><p>No run was measured.</p></section>"
    items = "".join(f"<li>{escape(text)}</li>" for text in headlines(records))
    points = _list(items, ' class="headlines"')
    words = (
        "Each technique at the fastest setting whose error does not exceed the peer's, so the "
        "speed-up is at equal or better quality."
    )
    if not any(is_peer(line.record) for line in shown):
        words = (
            "Each technique at the step nearest to a voxel, with the first of its settings: no "
            "peer was measured whose error they could be held against."
        )
    return (
        f"<section><h2>Result</h2>{points}<p>{words}</p>"
        f"{line_table(shown, True, shared)}</section>"
    )


def _findings(folder: Path, findings: Findings | None) -> str:
    """The sentence to quote, and what the study tells over all scenes."""
    if findings is None:
        return ""
    remarks = "".join(f"<li>{escape(text)}</li>" for text in findings.remarks if text)
    figures = "".join(
        f"<h3>{escape(title)}</h3>{_figure(folder / PLOT_FOLDER / name, title)}"
        for name, title in findings.figures
    )
    tables = "".join(map(html_table, findings.given_tables()))
    words = f"{_list(remarks)}{findings.how_to_read}"
    parts = [figures, tables, words]
    if findings.tables_first:
        parts = [tables, words, figures]
    return (
        f'<section><p class="lead">{escape(findings.sentence)}</p>'
        f"{''.join(parts)}</section>"
    )


def _list(items: str, attribute: str = "") -> str:
    """Return list items as a list; nothing where there are none."""
    return f"<ul{attribute}>{items}</ul>" if items else ""


def _scene_section(
    folder: Path,
    scene: Scene,
    records: list[Record],
    gallery: Gallery | None,
    shared: frozenset[str],
) -> str:
    rows = in_scene(records, scene)
    dims = next((row.dims for row in rows if row.dims), None)
    size = " &times; ".join(str(count) for count in dims) if dims else "not read"
    scalar_type = next((row.scalar_type for row in rows if row.scalar_type), "")
    doubt = max((row.error.reference_uncertainty or 0 for row in rows), default=0)
    remarks = [f"; {escape(text)}" for text in scene_remarks(rows)]
    if doubt:
        remarks.append(f"; uncertainty of the reference {doubt:.1e} RMSE")
    blending = "" if scene.blend_mode == COMPOSITE else f" &middot; {scene.blend_mode}"
    blending += " &middot; shaded" if scene.lighting else ""
    measured = [Line(row, None, False) for row in rows if row.frame_ms.median]
    parts = [
        f"<section><h2>{escape(scene.dataset)} &middot; "
        f"{escape(scene.transfer_function)}{blending}</h2>",
        f'<p class="machine">{size} {escape(scalar_type)}, picture '
        f"{scene.image_size[0]} &times; {scene.image_size[1]}{''.join(remarks)}</p>",
        _figure(folder / PLOT_FOLDER / error_plot_file(scene), "Error against time"),
        _pictures(folder, gallery),
        _figure(folder / PLOT_FOLDER / fps_plot_file(scene), "Frames per second"),
        *(html_table(table) for table in setting_tables(rows)),
        html_table(stage_table(rows, shared)),
        _details(
            f"All {len(measured)} measured rows",
            line_table(measured, False, shared) if measured else "",
        ),
        _details(
            "What the kernels were made for, and what was left out of them",
            html_table(feature_table(rows)),
        ),
        "</section>",
    ]
    return "".join(parts)


def _details(title: str, content: str) -> str:
    """Return what opens on a click; nothing where there is no content."""
    if not content:
        return ""
    return f"<details><summary>{title}</summary>{content}</details>"


def _figure(path: Path, title: str) -> str:
    if not path.is_file():
        return ""
    return f'<img class="plot" alt="{escape(title)}" src="{inlined(path)}">'


def _pictures(folder: Path, gallery: Gallery | None) -> str:
    if gallery is None:
        return ""
    cards = []
    for picture in gallery.pictures:
        card = _card_image(folder, picture.file, picture.title)
        card += (
            f"<figcaption><b>{escape(picture.title)}</b><br>{escape(picture.caption)}"
        )
        card += "</figcaption>"
        if picture.difference_file:
            card += _card_image(folder, picture.difference_file, "Difference")
            card += "<figcaption>its difference to the reference, amplified "
            card += f"{gallery.factor} times</figcaption>"
        cards.append(f"<figure>{card}</figure>")
    return f'<div class="pictures">{"".join(cards)}</div>'


def _card_image(folder: Path, name: str, title: str) -> str:
    path = folder / PICTURE_FOLDER / name
    if not path.is_file():
        return ""
    return f'<img alt="{escape(title)}" src="{inlined(path)}">'


def _ceilings(context: Context, records: list[Record]) -> str:
    table = ceiling_table(context, records)
    if table is None:
        return ""
    tables = html_table(table) + html_table(profile_table(context, records))
    return f"<section><h2>Ceilings of the machine</h2>{tables}{HOW_CEILINGS_ARE_READ}</section>"


def _notes(study: Study, records: list[Record]) -> str:
    found = all_notes(study, records)
    items = "".join(f"<li>{escape(text)}</li>" for text in found)
    title = TECHNIQUES[REFERENCE_TECHNIQUE].title
    return (
        f"<section><h2>Notes</h2><p>Each technique whose frame takes more than {SLOW_FACTOR:g} "
        f"times as long as that of {title} in a scene, at the same sampling, is told here with "
        "its samples and stages, which say where the time goes.</p>"
        f"{f'<ul>{items}</ul>' if items else '<p>There is none.</p>'}"
        f"{html_table(slow_table(records))}</section>"
    )


def _failures(records: list[Record], notes: list[str]) -> str:
    rows = [
        f"<li><b>{group.status}</b>: {escape(group.text())}</li>"
        for group in missing_groups(records)
    ]
    rows += [f"<li>{escape(note)}</li>" for note in notes]
    text = (
        f"<ul>{''.join(rows)}</ul>" if rows else "<p>None: every run was measured.</p>"
    )
    return f"<section><h2>Rows without a measurement</h2>{text}</section>"


def _settings(study: Study, context: Context, records: list[Record]) -> str:
    timing, error, camera = study.timing, study.error, study.camera
    own = {name for record in records for name in record.settings}
    entries = {
        _CONTEXT_TITLES[name]: "not used" if value is None else value
        for name, value in asdict(context).items()
        if name != "calibration"
    }
    entries |= {
        "Paths": "; ".join(PATH_TITLES[path] for path in study.paths),
        "Camera": f"{camera.path}, {camera.frames} frames a revolution, elevation "
        f"{camera.elevation_degrees:g} degrees, zoom {camera.zoom:g}",
        "Stop rule": f"at least {timing.minimum_frames} frames, noise of the mean "
        f"{100 * timing.relative_noise:g} %, at most {timing.time_limit_s:g} s a run",
        "Error": f"{counted(error.views, 'view')}, reference step {error.reference_step_voxels:g} voxel"
        + _size_text(error.image_size),
        "Ray termination": f"remaining transmittance {study.termination_threshold:g}"
        + UNLESS * ("termination_threshold" in own),
        "Ray set-up": study.ray_set_up + UNLESS * ("ray_set_up" in own),
        "Lighting": _lighting_text(study),
        "Settings of all rows": shared_text(records) or "none that all share",
    }
    rows = "".join(
        f"<tr><th>{escape(name)}</th><td>{escape(str(value))}</td></tr>"
        for name, value in entries.items()
    )
    return f"<section><h2>Machine and settings</h2><table>{rows}</table></section>"


def _size_text(size: tuple[int, int] | None) -> str:
    return f", on pictures of {size[0]} x {size[1]} pixels" if size else ""


def _lighting_text(study: Study) -> str:
    if not any(study.lighting):
        return "none"
    return (
        "with and without " * (len(study.lighting) > 1)
        + f"gradient shading, damping {study.lighting_damping:g}"
    )
