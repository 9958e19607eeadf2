"""timings.csv: one tidy row for each measured row, whatever measured it. docs/measuring.md
describes every column."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from types import UnionType
from typing import Any, get_args, get_type_hints

import numpy as np

from report.errors import ReportError
from report.files import read_bytes
from report.measure.estimates import Estimate, GroupEstimates, QuietLogs, quiet_logs
from report.measure.sampler import Json, Samples

REFERENCE, END_TO_END, KERNEL = "reference", "end_to_end", "kernel"
UNSTEADY_WIDTH = 0.25
"""Relative width of the interval from which a row is flagged."""

BUSY_WIDTH, BUSY_LOAD = 0.10, 0.25
"""The same while other processes keep that many processors busy."""


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
    passes: int | None
    median_ns: float
    min_ns: float
    ns_per_pixel: float
    speedup_vs_reference: float | None
    verified: bool
    repetitions: int
    spread_percent: float
    peer: bool
    speedup_low: float | None
    speedup_high: float | None
    speedup_from: str
    plan_bytes: int | None
    border: str
    max_iterations: int | None
    run: str
    machine: str
    commit: str
    low: float
    high: float
    samples: int
    flags: str
    speedup_vs_peer: float | None
    peer_name: str
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


@dataclass(frozen=True)
class Origin:
    """Where rows come from: columns that all rows of a run share."""

    run: str
    machine: str
    commit: str
    sweep: str = ""


def rows_of(samples: Samples, origin: Origin) -> list[Row]:
    """The rows of all groups of a plan."""
    sizes = {item["name"]: item for item in samples.plan["inputs"]}
    equal_peers = {peer["technique"] for peer in samples.plan["peers"] if peer["equal_output"]}
    load = float(np.median([process.foreign_load for process in samples.processes]))
    rows: list[Row] = []
    for index, group in enumerate(samples.plan["groups"]):
        maker = _GroupRows(samples, index, origin, sizes, load)
        rows.extend(_with_peer(list(maker.rows(group)), equal_peers))
    return rows


class _GroupRows:
    """Makes the rows of one group."""

    def __init__(self, samples: Samples, index: int, origin: Origin, sizes: dict[str, Json],
                 load: float) -> None:
        self.samples, self.index, self.origin, self.sizes = samples, index, origin, sizes
        self.entries = samples.plan["groups"][index]["entries"]
        quiet = quiet_group(samples, index)
        self.disturbed = quiet.disturbed
        self.estimates = GroupEstimates(quiet.logs, quiet.anchor_logs)
        self.load = load
        self.bases = [number for number, entry in enumerate(self.entries)
                      if self._facts(entry)["technique"] == REFERENCE]

    def rows(self, group: Json) -> Iterator[Row]:
        """Without the controls."""
        for number, entry in enumerate(group["entries"]):
            if entry["role"] == "row":
                yield self._row(number, entry)

    def _facts(self, entry: Json) -> Json:
        facts: Json = self.samples.plan["rows"][entry["name"]]
        return facts

    def _row(self, number: int, entry: Json) -> Row:
        facts = self._facts(entry)
        size = self.sizes[facts["input"]]
        time = self.estimates.time(number)
        speedup = self.estimates.speedup(number, self.bases[0]) if self.bases else None
        found = [process.groups[self.index]["entries"][number]
                 for process in self.samples.processes if process.groups[self.index]]
        return Row(
            **{key: facts[key] for key in ("operation", "technique", "isa", "threads", "scope",
                                           "input", "plan_bytes", "border", "max_iterations",
                                           "peer")},
            width=size["width"], height=size["height"], passes=facts["counter"],
            median_ns=time.value, min_ns=min(one["ns"][0] for one in found),
            ns_per_pixel=time.value / (size["width"] * size["height"]),
            speedup_vs_reference=speedup.value if speedup else None, verified=True,
            repetitions=len(found), spread_percent=100 * time.width,
            speedup_low=speedup.low if speedup else None,
            speedup_high=speedup.high if speedup else None, speedup_from="paired",
            run=self.origin.run, machine=self.origin.machine, commit=self.origin.commit,
            low=time.low, high=time.high, samples=sum(max(len(one["logs"]), 1) for one in found),
            flags=self._flag(number, speedup or time), speedup_vs_peer=None, peer_name="",
            sweep=self.origin.sweep)

    def _flag(self, number: int, estimate: Estimate) -> str:
        if self.load > BUSY_LOAD and estimate.width > BUSY_WIDTH:
            return "inconclusive"
        disturbed = number in self.disturbed or self.disturbed.intersection(self.bases)
        return "unsteady" if disturbed or estimate.width > UNSTEADY_WIDTH else ""


def quiet_group(samples: Samples, index: int) -> QuietLogs:
    """Of all entries of a group, the controls included."""
    return quiet_logs([process.groups[index] for process in samples.processes],
                      samples.plan["groups"][index]["anchor"])


def disturbed_groups(samples: Samples) -> list[int]:
    """Those with a row of which too few processes were quiet."""
    return [index for index in range(len(samples.plan["groups"]))
            if quiet_group(samples, index).disturbed]


def _with_peer(rows: list[Row], equal_peers: set[str]) -> list[Row]:
    """Adds the ratio to the fastest peer with equal output, where there is one."""
    peers = [row for row in rows if row.peer and row.technique in equal_peers]
    if not peers:
        return rows
    best = min(peers, key=lambda row: row.median_ns)
    return [row if row.peer or row.scope != END_TO_END else
            replace(row, speedup_vs_peer=best.median_ns / row.median_ns, peer_name=best.technique)
            for row in rows]


def to_csv(rows: Iterable[Row]) -> str:
    """The header and one line for each row; empty where there is no value."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    names = [field.name for field in fields(Row)]
    writer.writerow(names)
    writer.writerows([_text(getattr(row, name)) for name in names] for row in rows)
    return stream.getvalue()


def read_csv(path: Path) -> list[Row]:
    """Raises ReportError where the file is no such table."""
    try:
        text = read_bytes(path).decode()
        lines = list(csv.DictReader(io.StringIO(text, newline=""), strict=True))
    except (ValueError, csv.Error) as error:
        raise ReportError(f"{path}: not a CSV file: {error}") from None
    return [_row_from(line, f"{path}: line {number}") for number, line in enumerate(lines, 2)]


def _text(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(int(value))
    return f"{value:.6g}" if isinstance(value, float) else str(value)


_TYPES = get_type_hints(Row)


def _row_from(line: dict[str, str], where: str) -> Row:
    try:
        return Row(**{field.name: _value(line[field.name], _TYPES[field.name])
                      for field in fields(Row)})
    except KeyError as error:
        raise ReportError(f"{where}: column {error} is missing") from None
    except (TypeError, ValueError) as error:
        raise ReportError(f"{where}: {error}") from None


def _value(text: str, kind: Any) -> Any:
    if isinstance(kind, UnionType):
        return _value(text, get_args(kind)[0]) if text else None
    return text == "1" if kind is bool else kind(text)
