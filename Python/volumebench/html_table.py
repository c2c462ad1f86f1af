"""Tables as markup."""

from html import escape

from .tables import Table


def html_table(table: Table | None) -> str:
    """Return a table with its title; nothing for none."""
    if table is None:
        return ""

    def row(cells: tuple[str, ...], tag: str) -> str:
        return "".join(
            f"<{tag}>{escape(cell)}</{tag}>"
            if column < table.words
            else f'<{tag} class="n">{escape(cell)}</{tag}>'
            for column, cell in enumerate(cells)
        )

    body = "".join(f"<tr>{row(cells, 'td')}</tr>" for cells in table.rows)
    return (
        f'<h3>{escape(table.title)}</h3><div class="wide"><table><thead>'
        f"<tr>{row(table.header, 'th')}</tr></thead><tbody>{body}</tbody></table></div>"
    )
