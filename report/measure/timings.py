"""timings.csv: one tidy row for each measured row, whatever measured it. results/README.md
describes every column."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import UnionType
from typing import Any, get_args, get_type_hints

import pandas as pd

from report.errors import ReportError
from report.files import read_bytes
from report.measure.benchmarks import Json, groups_of
from report.measure.controls import control_of
from report.measure.estimates import Estimate, Estimates, Time, ratio_of

REFERENCE, END_TO_END = "reference", "end_to_end"

@dataclass(frozen=True)
class Row:  # pylint: disable=too-many-instance-attributes
    """One line of timings.csv; the fields are its columns."""

    operation: str
    technique: str
    isa: str
    threads: int
    scope: str
    input: str
    width: int
    height: int
    iterations: int | None
    time_ns: float
    high_ns: float
    typical_ns: float
    ns_per_pixel: float
    speedup_vs_reference: float | None
    speedup_low: float | None
    speedup_high: float | None
    processes: int
    flags: str
    speedup_vs_peer: float | None
    peer_low: float | None
    peer_high: float | None
    peer_name: str
    peer: bool
    default: bool
    scalar: bool
    verified: bool
    border: str
    max_iterations: int | None
    run: str
    machine: str
    commit: str
    sweep: str

    @cached_property
    def case(self) -> str:
        """Operation and options, such as thin_guo_hall:keep or net_two_layer_linear:1."""
        keep = ":keep" if self.border == "keep" else ""
        limit = "" if self.max_iterations is None else f":{self.max_iterations}"
        return f"{self.operation}{keep}{limit}"

    @property
    def name(self) -> str:
        """As results are called everywhere: case/technique/isa/threads/scope/input."""
        return (f"{self.case}/{self.technique}/{self.isa}/{self.threads}/{self.scope}/"
                f"{self.input}")

    @property
    def is_reference(self) -> bool:
        """Whether it is the scalar reference."""
        return self.technique == REFERENCE

    @property
    def is_choice(self) -> bool:
        """Whether it is what a call of the library takes on one thread."""
        return self.default and self.threads == 1 and self.scope == END_TO_END


_TYPES = get_type_hints(Row)
"""By column."""


@dataclass(frozen=True)
class Origin:
    """Where rows come from: columns that all rows of a run share."""

    run: str
    machine: str
    commit: str
    sweep: str = ""


def rows_of(facts: Json, times: Estimates, origin: Origin) -> list[Row]:
    """All rows that were measured."""
    return [row for names in groups_of(facts)
            for row in _group_rows(facts, [name for name in names if name in times], times, origin)]


def _group_rows(facts: Json, names: list[str], times: Estimates, origin: Origin) -> Iterator[Row]:
    equal_peers = {peer["technique"] for peer in facts["peers"] if peer["equal_output"]}
    rows = facts["rows"]
    reference = next((times.time(name) for name in names if rows[name]["technique"] == REFERENCE), None)
    peer = min((name for name in names if rows[name]["peer"] and rows[name]["technique"] in equal_peers),
               key=lambda name: times.time(name).value, default=None)
    failed = control_of(names, times).flag
    for name in names:
        row = rows[name]
        own = row["peer"] or row["scope"] != END_TO_END
        over = None if own or peer is None else (times.time(peer), rows[peer]["technique"])
        yield _row(facts, row, times.time(name), reference, over, failed,
                   not row["peer"] or row["technique"] in equal_peers, origin)


def _row(facts: Json, row: Json, time: Time, reference: Time | None, peer: tuple[Time, str] | None, failed: str,
         verified: bool, origin: Origin) -> Row:
    size = next(item for item in facts["inputs"] if item["name"] == row["input"])
    speedup = ratio_of(reference, time) if reference else None
    over_peer = ratio_of(peer[0], time) if peer else None
    settled = time.settled and (reference is None or reference.settled)
    return Row(
        **{key: row[key] for key in ("operation", "technique", "isa", "threads", "scope", "input", "border",
                                     "max_iterations", "peer", "default", "scalar")},
        width=size["width"], height=size["height"], iterations=row["iterations"],
        time_ns=time.value, high_ns=time.high, typical_ns=time.typical,
        ns_per_pixel=time.value / (size["width"] * size["height"]), verified=verified,
        speedup_vs_reference=speedup.value if speedup else None,
        speedup_low=speedup.low if speedup else None,
        speedup_high=speedup.high if speedup else None, processes=time.processes,
        flags=failed if settled else "open",
        speedup_vs_peer=over_peer.value if over_peer else None,
        peer_low=over_peer.low if over_peer else None,
        peer_high=over_peer.high if over_peer else None, peer_name=peer[1] if peer else "",
        run=origin.run, machine=origin.machine, commit=origin.commit, sweep=origin.sweep)


def row_ratio(above: Row, below: Row) -> Estimate:
    """Of the times of two rows, from what the table says of them: wider than it need be."""
    return Estimate(above.time_ns / below.time_ns, above.time_ns / below.high_ns, above.high_ns / below.time_ns)


def to_csv(rows: Iterable[Row]) -> str:
    """The header and one line for each row; empty where there is no value."""
    table = pd.DataFrame([vars(row) for row in rows], columns=list(_TYPES))
    whole = {name: "Int64" for name, kind in _TYPES.items() if kind in (bool, int | None)}
    return str(table.astype(whole).to_csv(index=False, float_format="%.6g", lineterminator="\n"))


def read_csv(path: Path) -> list[Row]:
    """Raises ReportError where the file is no such table."""
    try:
        text = read_bytes(path).decode()
        lines = list(csv.DictReader(io.StringIO(text, newline=""), strict=True))
    except (ValueError, csv.Error) as error:
        raise ReportError(f"{path}: not a CSV file: {error}") from None
    return [_row_from(line, f"{path}: line {number}") for number, line in enumerate(lines, 2)]


def _row_from(line: dict[str, str | None], where: str) -> Row:
    missing = next((name for name in _TYPES if line.get(name) is None), None)
    if missing:
        raise ReportError(f"{where}: column {missing!r} is missing")
    try:
        row = Row(**{name: _value(line[name] or "", kind) for name, kind in _TYPES.items()})
    except (TypeError, ValueError) as error:
        raise ReportError(f"{where}: {error}") from None
    if not 0 < row.time_ns <= row.high_ns < math.inf:
        raise ReportError(f"{where}: expected times above 0, got time_ns {row.time_ns:g} and high_ns {row.high_ns:g}")
    return row


def _value(text: str, kind: Any) -> Any:
    if isinstance(kind, UnionType):
        return _value(text, get_args(kind)[0]) if text else None
    return text == "1" if kind is bool else kind(text)
