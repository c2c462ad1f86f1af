"""What the HTML pages of all studies share: the frame of a page and its line on the machine."""

from html import escape

from .report_style import SCRIPT, STYLE
from .results import Context


def page(title: str, body: str, style: str = "") -> str:
    """Return a self-contained page; `title` is text, `body` and further `style` are markup."""
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(title)}</title><style>{STYLE}{style}</style></head>\n"
        f"<body>{body}<script>{SCRIPT}</script></body></html>\n"
    )


def head(name: str, description: str, context: Context) -> str:
    """Return the head of a study's page, with the machine it was measured on."""
    machine = " &middot; ".join(
        escape(str(part))
        for part in (
            context.gl_renderer,
            context.cpu,
            f"{context.cores} cores" if context.cores else None,
            f"ParaView {context.paraview}" if context.paraview else None,
            context.date,
        )
        if part
    )
    return (
        f'<header><p class="kicker">VolumeBench</p><h1>{escape(name)}</h1>'
        f"<p>{escape(description)}</p>"
        f'<p class="machine">{machine}</p></header>'
    )
