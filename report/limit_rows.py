"""Reads limits.json, what bounds rows, where a run has it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from report.cases import Case, case_in
from report.errors import ReportError
from report.json_fields import Fields, read_object
from report.model import SCOPES, Study

FILE = "limits.json"
COPY_BITS = "copy_bits"
COPIES = ("copy", COPY_BITS, "read_bits")


@dataclass(frozen=True)
class Limit:
    """One call of a row: what it executes, how long it takes, and how long it must."""

    case: Case
    scope: str
    technique: str
    isa: str
    instructions: int
    instructions_per_cycle: float
    ns: float
    limit_ns: float
    percent: float
    per_row_and_iteration: float | None


@dataclass(frozen=True)
class Limits:
    """All rows whose instructions were counted, on one input."""

    input: str
    size: tuple[int, int]
    issue_width: float
    rows: tuple[Limit, ...]
    skipped: int
    by_callgrind: int  # of the rows; the others were counted by single steps


def load_limits(directory: Path) -> Limits | None:
    """None for runs without limits."""
    if not (directory / FILE).exists():
        return None
    fields = read_object(directory / FILE)
    fields.check_schema()
    shape = fields.child("input")
    return Limits(shape.text("name"), (shape.count("width", 1), shape.count("height", 1)),
                  fields.positive("issue_width"), tuple(map(_limit, fields.children("rows"))),
                  len(fields.listed("skipped")), sum(map(_is_by_callgrind, fields.children("rows"))))


def copy_ns(study: Study, limits: Limits, limit: Limit) -> float | None:
    """The time of a copy in the row's representation.

    A bit-packed row whose case has none is as well compared with any case's copy of
    packed bits: both take and leave the same memory.
    """
    rows = [row for case in (limit.case.name, *study.cases)
            for row in study.select(case, limits.input)
            if row.is_peer and row.name.scope == limit.scope]
    own = (row for row in rows
           if row.name.case == limit.case and row.name.technique in COPIES)
    packed = (row for row in rows
              if "bitpacked" in limit.technique and row.name.technique == COPY_BITS)
    return next((row.median_ns for row in (*own, *packed)), None)


def timed_ns(study: Study, limits: Limits, limit: Limit) -> float | None:
    """The time of the same row among the timings of the run, where it was measured apart."""
    variant = (limit.technique, limit.isa, 1)
    return next((row.median_ns for row in study.select(limit.case.name, limits.input)
                 if (row.name.variant, row.name.scope) == (variant, limit.scope)), None)


def _is_by_callgrind(row: Fields) -> bool:
    """Rows from before there was a choice name no method."""
    return row.has("method") and row.text("method") == "callgrind"


def _limit(row: Fields) -> Limit:
    scope = row.text("scope")
    if scope not in SCOPES:
        raise ReportError(f"{row.where}: scope is '{scope}'; it must be {' or '.join(SCOPES)}")
    key = row.renamed("instructions_per_row_and_iteration", "instructions_a_row_and_pass")
    per_cycle = row.renamed("instructions_per_cycle", "instructions_a_cycle")
    return Limit(case_in(row), scope, row.text("technique"), row.text("isa"),
                 row.count("instructions"), row.number(per_cycle),
                 row.positive("ns"), row.number("limit_ns"), row.number("percent_of_limit"),
                 row.number(key) if row.has(key) else None)
