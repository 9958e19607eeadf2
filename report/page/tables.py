"""A finished table, the same for the page and for Markdown."""

from __future__ import annotations

from dataclasses import dataclass

from report.formatting import markdown_table


@dataclass(frozen=True)
class Table:
    """Cells are text; columns from `first_number` on are numbers."""

    title: str
    sentence: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    command: str = ""
    first_number: int = 1


def to_markdown(table: Table) -> str:
    """The table under its title and sentence."""
    numbers = frozenset(range(table.first_number, len(table.header)))
    lines = [f"## {table.title}", "", table.sentence, "",
             markdown_table(table.header, table.rows, numbers)]
    return "\n".join([*lines, f"Made by `{table.command}`.", ""] if table.command else lines)
