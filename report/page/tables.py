"""A finished table, the same for the page and for Markdown."""

from __future__ import annotations

from collections.abc import Sequence
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


LATEX = {"\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "%": r"\%", "_": r"\_", "&": r"\&",
         "#": r"\#", "$": r"\$", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
         "µ": r"\textmu{}", "×": r"$\times$", "\N{EN DASH}": "--"}


def to_latex(header: Sequence[str], rows: Sequence[Sequence[str]], layout: str) -> str:
    """Plain tabular that needs no package; `layout` has a letter for each column."""
    def line(cells: Sequence[str]) -> str:
        return " & ".join(cell.translate(str.maketrans(LATEX)) for cell in cells) + r" \\"
    return "\n".join([rf"\begin{{tabular}}{{{layout}}}", r"\hline", line(header), r"\hline",
                      *map(line, rows), r"\hline", r"\end{tabular}", ""])
