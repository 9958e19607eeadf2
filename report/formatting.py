"""How numbers and names are written for people: one place, so that all outputs agree."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.measure.timings import END_TO_END, REFERENCE, Row

NOTHING = "\N{EN DASH}"


def three_digits(value: float) -> str:
    """About three digits and never an exponent, such as 1.25, 38.1 or 4,120."""
    digits = 2 if value < 9.995 else 1 if value < 99.95 else 0
    return f"{value:,.{digits}f}"


def times(factor: float | None) -> str:
    """A ratio, such as 38.1×."""
    return NOTHING if factor is None else f"{three_digits(factor)}×"


def duration(ns: float) -> str:
    """A time in the largest unit of which it is at least one, such as 61.9 µs."""
    for unit, scale in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if ns >= 0.9999 * scale:
            return f"{three_digits(ns / scale)} {unit}"
    return f"{three_digits(ns)} ns"


def interval(low: float | None, high: float | None) -> str:
    """Such as 251\N{EN DASH}258."""
    return "" if low is None or high is None else f"{three_digits(low)}\N{EN DASH}{three_digits(high)}"


def speedup_text(row: Row) -> str:
    """Over the plain reference, with its interval, such as 254× (251\N{EN DASH}258)."""
    if row.speedup_vs_reference is None or row.is_reference:
        return NOTHING
    bounds = interval(row.speedup_low, row.speedup_high)
    return times(row.speedup_vs_reference) + (f" ({bounds}{flag_text(row, ', ')})" if bounds else "")


def flag_text(row: Row, before: str = " ") -> str:
    """What is doubtful about a row, or nothing."""
    return f"{before}{row.flags}" if row.flags else ""


def variant(row: Row) -> str:
    """Technique, instruction set and threads, such as lut, baseline, 2 threads."""
    if row.technique == REFERENCE:
        return "plain reference"
    threads = f", {row.threads} threads" if row.threads > 1 else ""
    return f"{row.technique}{'' if row.isa == 'native' else f', {row.isa}'}{threads}"


def scope_label(scope: str) -> str:
    """The scope in words."""
    return "end to end" if scope == END_TO_END else scope.replace("_", " ")


def counted(number: int, noun: str) -> str:
    """A number with its noun, such as 1 seed or 3 seeds."""
    return f"{number:,} {noun}{'' if number == 1 else 's'}"


def markdown_table(header: Sequence[str], rows: Sequence[Sequence[str]],
                   numbers: frozenset[int] = frozenset()) -> str:
    """Columns whose index is in `numbers` are set flush right."""
    rule = ["---:" if index in numbers else "---" for index in range(len(header))]
    lines: list[Sequence[str]] = [header, rule, *rows]
    return "".join(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in line)} |\n"
                   for line in lines)


def templates(package: Path) -> Environment:
    """The pages in a directory of this package."""
    return Environment(loader=FileSystemLoader(package / "templates"), autoescape=True, undefined=StrictUndefined,
                       trim_blocks=True, lstrip_blocks=True)
