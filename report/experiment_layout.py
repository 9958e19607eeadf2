"""A table of the paper's experiments, the same for the page and for experiments.md."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from report.plot_style import Plot
from report.tables import markdown_line

TITLE = "The paper's experiments again"


@dataclass(frozen=True)
class Column:
    """A column's heading, and whether it is set like numbers."""

    label: str
    is_number: bool = True


@dataclass(frozen=True)
class Table:
    """A finished table with the sentences that say what it shows."""

    title: str
    sentence: str
    header: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]
    command: str
    verdict: str = ""
    """What follows from the table, if more than the sentence says."""
    plot: Plot | None = None
    words: tuple[tuple[str, str], ...] = ()
    """Words that stand in cells, each with what it means."""


def columns(texts: Sequence[str], numbers: Sequence[str]) -> tuple[Column, ...]:
    """Columns of text, followed by columns of numbers."""
    return tuple(Column(label, False) for label in texts) + tuple(map(Column, numbers))


def counted(number: int, noun: str) -> str:
    """A number with its noun, such as 1 seed or 3 seeds."""
    return f"{number:,} {noun}{'' if number == 1 else 's'}"


def to_experiments_markdown(tables: list[Table]) -> str:
    """All tables as Markdown, each under its sentences and above its command."""
    return "\n".join([f"# {TITLE}\n", *map(table_block, tables)])


def table_block(table: Table) -> str:
    """A table as Markdown, under its sentences and above its command."""
    lines = [f"## {table.title}", "", table.sentence, ""]
    lines += [table.verdict, ""] if table.verdict else []
    lines += [*(f"- {word}: {meaning}" for word, meaning in table.words), ""] if table.words else []
    lines += [markdown_table(table.header, table.rows).rstrip("\n")]
    if table.plot:
        lines += ["", f"![{table.plot.alt}](plots/{table.plot.stem}.svg)"]
    return "\n".join([*lines, "", f"Made by `{table.command}`.", ""])


def markdown_table(header: tuple[Column, ...], rows: tuple[tuple[str, ...], ...]) -> str:
    """Header, rule and rows."""
    rule = ["---:" if column.is_number else "---" for column in header]
    lines: list[Sequence[str]] = [[column.label for column in header], rule, *rows]
    return "".join(markdown_line(line) + "\n" for line in lines)
