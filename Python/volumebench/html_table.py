"""Tables as markup."""

from html import escape

from .tables import Table


def html_table(table: Table | None) -> str:
    """Return a table with its title; nothing for none."""
    if table is None:
        return ""
    body = "".join(f"<tr>{_row(table, cells)}</tr>" for cells in table.rows)
    kind = ' class="grouped"' if table.groups else ""
    return (
        f'<h3>{escape(table.title)}</h3><div class="wide"><table{kind}><thead>{_groups(table)}'
        f"<tr>{_titles(table)}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def _groups(table: Table) -> str:
    """Return the row of titles that stand over several columns."""
    if not table.groups:
        return ""
    cells = (
        f'<th class="group" colspan="{count}">{escape(title)}</th>'
        for title, count in table.groups
    )
    return f'<tr>{"".join(cells)}</tr>'


def _titles(table: Table) -> str:
    return "".join(
        f"<th{_attribute(table, column)}>{escape(title)}</th>"
        for column, title in enumerate(table.header)
    )


def _row(table: Table, cells: tuple[str, ...]) -> str:
    return "".join(
        f"<td{_attribute(table, column)}>{_content(table, column, cell)}</td>"
        for column, cell in enumerate(cells)
    )


def _content(table: Table, column: int, cell: str) -> str:
    if not table.marked or column:
        return escape(cell)
    return f'<span class="mark {cell.replace(" ", "-")}">{escape(cell)}</span>'


def _attribute(table: Table, column: int) -> str:
    return "" if column < table.words else ' class="n"'
