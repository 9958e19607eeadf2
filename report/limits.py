"""Reads limits.json, what bounds rows, where a run has it, and sets it out as a table."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from report.errors import ReportError
from report.experiment_layout import Table, columns
from report.formatting import NOTHING, microseconds, scope_label
from report.json_fields import Fields, read_object
from report.model import SCOPES, Study

FILE = "limits.json"
TITLE = "Time against limit"
COPIES = ("copy", "copy_bits")
HEADER = columns(["Operation", "Scope", "Technique", "ISA"],
                 ["Instructions", "A cycle", "µs", "Limit µs", "Of limit", "A row and pass",
                  "Copy µs"])


@dataclass(frozen=True)
class Limit:
    """One call of a row: what it executes, how long it takes, and how long it must."""

    operation: str
    scope: str
    technique: str
    isa: str
    instructions: int
    instructions_a_cycle: float
    ns: float
    limit_ns: float
    percent: float
    a_row_and_pass: float | None


@dataclass(frozen=True)
class Limits:
    """All rows whose instructions were counted, on one input."""

    input: str
    size: tuple[int, int]
    issue_width: float
    rows: tuple[Limit, ...]
    skipped: int


def load_limits(directory: Path) -> Limits | None:
    """None for runs without limits."""
    if not (directory / FILE).exists():
        return None
    fields = read_object(directory / FILE)
    fields.check_schema()
    shape = fields.child("input")
    return Limits(shape.text("name"), (shape.count("width", 1), shape.count("height", 1)),
                  fields.positive("issue_width"), tuple(map(_limit, fields.children("rows"))),
                  len(fields.listed("skipped")))


def limits_table(study: Study, limits: Limits | None) -> Table | None:
    """The rows by operation and scope, the fastest first; None where nothing was counted."""
    if limits is None or not limits.rows:
        return None
    order = {name: place for place, name in enumerate(study.operations)}
    rows = sorted(limits.rows, key=lambda row: (
        order.get(row.operation, len(order)), SCOPES.index(row.scope), row.ns))
    return Table(TITLE, _sentence(limits), HEADER,
                 tuple(_cells(row, _copy_ns(study, limits, row)) for row in rows),
                 "thinbench instructions --limits")


def _limit(row: Fields) -> Limit:
    scope = row.text("scope")
    if scope not in SCOPES:
        raise ReportError(f"{row.where}: scope is '{scope}'; it must be {' or '.join(SCOPES)}")
    key = "instructions_a_row_and_pass"
    return Limit(row.text("operation"), scope, row.text("technique"), row.text("isa"),
                 row.count("instructions"), row.number("instructions_a_cycle"),
                 row.positive("ns"), row.number("limit_ns"), row.number("percent_of_limit"),
                 row.number(key) if row.has(key) else None)


def _sentence(limits: Limits) -> str:
    left_out = (f" {limits.skipped} rows execute too many to be counted, or do not run here."
                if limits.skipped else "")
    width, height = limits.size
    return (f"Instructions of one call on {limits.input}, {width} x {height} pixels, counted one "
            "by one; time and frequency were measured next to each other. The limit is the time "
            f"of a core that issues {limits.issue_width:g} instructions in every cycle, which is "
            "assumed and not measured; above 100 % the core issues more. The copy is one of the "
            f"same bytes, where it was timed on the same input.{left_out}")


def _copy_ns(study: Study, limits: Limits, limit: Limit) -> float | None:
    """The time of a copy in the row's representation."""
    return next((row.median_ns for row in study.select(limit.operation, limits.input)
                 if row.is_peer and row.name.technique in COPIES
                 and row.name.scope == limit.scope), None)


def _cells(row: Limit, copy_ns: float | None) -> tuple[str, ...]:
    each = row.a_row_and_pass
    return (row.operation, scope_label(row.scope), row.technique, row.isa,
            f"{row.instructions:,}", f"{row.instructions_a_cycle:.2f}", microseconds(row.ns),
            microseconds(row.limit_ns), f"{row.percent:.0f} %",
            NOTHING if each is None else f"{each:.1f}",
            NOTHING if copy_ns is None else microseconds(copy_ns))
