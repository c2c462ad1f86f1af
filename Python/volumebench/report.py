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
from .summary import (
    Line,
    headlines,
    in_scene,
    lines,
    million_samples,
    million_samples_per_second,
    missing_groups,
    number,
    sampling_text,
    scene_remarks,
    scenes_of,
)
from .tables import setting_tables, slow_table, stage_table
from .techniques import REFERENCE_TECHNIQUE, TECHNIQUES

UNEQUAL = (
    "<p><small>* not at equal error: no run was as accurate as the peer's</small></p>"
)
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
    scenes = [
        _scene_section(folder, scene, records, galleries.get(scene.title()))
        for scene in scenes_of(records)
    ]
    body = "\n".join(
        [
            head(study.name, study.description, context),
            _findings(folder, findings),
            _summary(records),
            f'<section class="read"><h2>How to read this</h2>{HOW_TO_READ}</section>',
            *scenes,
            _ceilings(context, records),
            _notes(study, records),
            _failures(records, notes),
            _settings(study, context),
        ]
    )
    title = f"VolumeBench: {study.name}"
    write_atomically(folder / "report.html", page(title, body))


def _summary(records: list[Record]) -> str:
    """The headline: per scene and path, the peer and each technique at its error."""
    shown = lines(records)
    if not shown:
        return "<section><h2>Result</h2><p>No run was measured.</p></section>"
    points = "".join(f"<li>{escape(text)}</li>" for text in headlines(records))
    return (
        f'<section><h2>Result</h2><ul class="headlines">{points}</ul><p>Each technique at the fastest setting whose error does not '
        "exceed the peer's, so the speed-up is at equal or better quality.</p>"
        f"{_line_table(shown, with_scene=True)}</section>"
    )


def _findings(folder: Path, findings: Findings | None) -> str:
    """The sentence to quote, and what the study tells over all scenes."""
    if findings is None:
        return ""
    remarks = "".join(f"<li>{escape(text)}</li>" for text in findings.remarks if text)
    figures = "".join(
        _figure(folder / PLOT_FOLDER / name, title) for name, title in findings.figures
    )
    tables = "".join(map(html_table, findings.given_tables()))
    return (
        f'<section><p class="lead">{escape(findings.sentence)}</p>{figures}{tables}'
        f"<ul>{remarks}</ul>{findings.how_to_read}</section>"
    )


def _line_table(shown: list[Line], with_scene: bool) -> str:
    titles = ["Path", "Technique", "Sampling"]
    figures = ["ms (quartiles)", "GPU ms", "FPS", "Msamples", "Msamples/s"]
    figures += [
        "RMSE",
        "99.9 %",
        "mean error",
        "SSIM",
        "&Delta;E &gt; 1",
        "FLIP",
        "FLIP 99 %",
    ]
    figures += ["Speed-up"]
    head = "".join(f"<th>{title}</th>" for title in titles)
    head += "".join(f'<th class="n">{title}</th>' for title in figures)
    rows = []
    previous = None
    for line in shown:
        scene = line.record.run().scene
        if with_scene and scene != previous:
            inside = in_scene([item.record for item in shown], scene)
            rows.append(_scene_row(scene, inside, len(titles) + len(figures)))
        previous = scene
        rows.append(f"<tr>{_cells(line)}</tr>")
    unequal = any(line.speed_up() and not line.matched for line in shown)
    return (
        f'<div class="wide"><table><thead><tr>{head}</tr></thead>'
        f'<tbody>{"".join(rows)}</tbody></table></div>'
        f"{UNEQUAL if unequal else ''}"
    )


def _scene_row(scene: Scene, records: list[Record], columns: int) -> str:
    remarks = "; ".join(scene_remarks(records))
    return (
        f'<tr><th class="scene" colspan="{columns}">{escape(scene.title())} '
        f"<small>{escape(remarks)}</small></th></tr>"
    )


def _cells(line: Line) -> str:
    record = line.record
    speed_up = line.speed_up()
    factor = ""
    if speed_up:
        factor = f"{speed_up:.1f}&times;"
        factor = f"<b>{factor}</b>" if line.matched else f"{factor} *"
    texts = [
        record.path,
        escape(TECHNIQUES[record.technique].title),
        escape(sampling_text(record)),
    ]
    spread = record.frame_ms
    quartiles = ""
    if spread.q1 is not None and spread.q3 is not None:
        quartiles = f" <small>({spread.q1:.1f}&ndash;{spread.q3:.1f})</small>"
    figures = [
        number(spread.median, ".1f") + quartiles,
        number(record.gpu_ms.median, ".1f"),
        number(record.fps, ".1f"),
        number(million_samples(record), ".2f"),
        number(million_samples_per_second(record), ".0f"),
        number(record.error.rmse, ".2e"),
        number(record.error.p999, ".2e"),
        number(record.error.mean, "+.1e"),
        number(record.error.ssim, ".4f"),
        number(record.error.delta_e_over_1_percent, ".1f", " %"),
        number(record.error.flip_mean, ".4f"),
        number(record.error.flip_p99, ".4f"),
        factor,
    ]
    text = "".join(f"<td>{cell}</td>" for cell in texts)
    return text + "".join(f'<td class="n">{cell}</td>' for cell in figures)


def _scene_section(
    folder: Path, scene: Scene, records: list[Record], gallery: Gallery | None
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
        html_table(stage_table(rows)),
        _all_rows(measured),
        "</section>",
    ]
    return "".join(parts)


def _all_rows(measured: list[Line]) -> str:
    if not measured:
        return ""
    table = _line_table(measured, with_scene=False)
    return f"<details><summary>All {len(measured)} measured rows</summary>{table}</details>"


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


def _settings(study: Study, context: Context) -> str:
    timing, error, camera = study.timing, study.error, study.camera
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
        "Error": f"{error.views} views, reference step {error.reference_step_voxels:g} voxel"
        + _size_text(error.image_size),
        "Ray termination": f"remaining transmittance {study.termination_threshold:g}",
        "Ray set-up": study.ray_set_up,
        "Lighting": _lighting_text(study),
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
