"""One operation of the page: its table, which the plot is drawn from, and its lower bound."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from report.formatting import NOTHING, counted, duration, interval, scope_label, times
from report.measure.timings import Row
from report.page.families import FAMILIES, family
from report.page.operations import Headline, Rows, label, title
from report.page.pictures import Picture, Pictures


@dataclass(frozen=True)
class Cell:
    """Text, and the number by which the column is sorted, "" for words."""

    text: str
    value: str = ""


@dataclass(frozen=True)
class Line:
    """A row of the table; `data` are the attributes that switches and plot read."""

    data: dict[str, str]
    cells: tuple[Cell, ...]


@dataclass(frozen=True)
class Section:
    """An operation."""

    name: str
    label: str
    title: str
    picture: Picture | None
    bound: str
    header: tuple[str, ...]
    first_number: int
    lines: tuple[Line, ...]


Column = tuple[str, Callable[[Row], Cell]]


def sections(rows: Rows, pictures: Pictures) -> list[Section]:
    """In the order of the page."""
    names = list(dict.fromkeys(case.partition(":")[0] for case in rows.cases))
    return [_section(rows, name, pictures) for name in names]


def _section(rows: Rows, name: str, pictures: Pictures) -> Section:
    cases = [case for case in rows.cases if case.partition(":")[0] == name]
    own = [row for row in rows.rows if row.operation == name]
    copy = rows.copy(cases[0])
    own += [copy] if copy and copy not in own else []
    own.sort(key=lambda row: row.time_ns)
    columns = _columns(own)
    texts = sum(column[0] in WORDS for column in columns)
    lines = tuple(Line(_data(row, rows), tuple(value(row) for _, value in columns)) for row in own)
    picture = next((found for case in cases if (found := pictures.of_case(case))), None)
    bound = _bound(rows.headline(cases[0]))
    return Section(name, label(name), title(name), picture, bound,
                   tuple(words for words, _ in columns), texts, lines)


IMPLIED = ("Options", "Scope", "Image")
"""Columns that say what the switches say; hidden beside these."""

WORDS = ("Technique", "ISA", "Options", "Scope", "Image", "Flags")


def _columns(rows: list[Row]) -> list[Column]:
    """Those in which rows differ, and those that always matter."""
    found: list[Column] = [("Technique", lambda row: Cell(row.technique)),
                           ("ISA", lambda row: Cell(row.isa)),
                           ("Options", lambda row: Cell(options(row))),
                           ("Scope", lambda row: Cell(scope_label(row.scope))),
                           ("Image", lambda row: Cell(row.input)),
                           ("Flags", lambda row: Cell(row.flags)),
                           ("Threads", lambda row: Cell(str(row.threads), str(row.threads))),
                           ("Time", lambda row: Cell(duration(row.time_ns), _number(row.time_ns))),
                           ("Up to", lambda row: Cell(duration(row.high_ns),
                                                              _number(row.high_ns))),
                           ("Typical", lambda row: Cell(duration(row.typical_ns),
                                                        _number(row.typical_ns))),
                           ("ns/pixel", lambda row: Cell(f"{row.ns_per_pixel:.4f}",
                                                         _number(row.ns_per_pixel))),
                           ("Speed-up", lambda row: _ratio(_speedup(row, row.speedup_vs_reference))),
                           ("Speed-up interval", lambda row: Cell(
                               interval(_speedup(row, row.speedup_low), row.speedup_high),
                               _number(_speedup(row, row.speedup_low)))),
                           ("To peer", lambda row: _ratio(row.speedup_vs_peer))]
    optional: dict[str, set[Any]] = {"Options": {options(row) for row in rows}, "Image": {row.input for row in rows},
                "Flags": {row.flags for row in rows} | {""},
                "To peer": {row.speedup_vs_peer for row in rows} | {None}}
    return [column for column in found if len(optional.get(column[0], {1, 2})) > 1]


def _speedup(row: Row, value: float | None) -> float | None:
    """The reference has none."""
    return None if row.is_reference else value


def options(row: Row) -> str:
    """Border and limit in words."""
    words = [] if row.border != "keep" else ["border kept"]
    words += [] if row.max_iterations is None else [f"at most {counted(row.max_iterations, 'iteration')}"]
    return ", ".join(words) or ("border thinned" if row.border else "none")


def _data(row: Row, rows: Rows) -> dict[str, str]:
    return {"family": str(FAMILIES.index(family(row, rows.equal_peers))),
            "technique": row.technique, "isa": row.isa, "threads": str(row.threads),
            "options": options(row), "scope": scope_label(row.scope), "image": row.input,
            "ns": _number(row.time_ns), "high": _number(row.high_ns),
            "speedup": "" if row.speedup_vs_reference is None or row.is_reference
            else times(row.speedup_vs_reference)}


def _bound(line: Headline | None) -> str:
    """What a copy says about the library's choice."""
    if line is None or line.copy is None:
        return ""
    share = line.copy_share or 0.0
    what = {"read_bits": "packing the image and reading its words",
            "copy_bits": "packing the image, copying and unpacking it"}.get(
                line.copy.technique, "a copy of the image")
    best, kind = duration(line.best.time_ns), options(line.best)
    relation = "more than" if share > 1 else f"{100 * share:.0f} % of" if share >= 0.01 else "under 1 % of"
    return (f"To compare with: {what} takes {duration(line.copy.time_ns)}, {relation} the {best} "
            f"of the variant that the library chooses{'' if kind == 'none' else f', {kind}'}.")


def _ratio(value: float | None) -> Cell:
    return Cell(NOTHING if value is None else times(value), _number(value))


def _number(value: float | None) -> str:
    return "-1" if value is None else f"{value:.6g}"


