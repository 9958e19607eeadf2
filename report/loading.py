"""Reads timings.json, machine.json and rows.json of one run, and refuses what cannot be trusted."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from report.cases import Case, case_named, checked_border, isa_label, place_of_peer
from report.controls import load_controls
from report.errors import ReportError
from report.json_fields import Fields, read_object
from report.machine import load_machine, run_warnings
from report.model import (SCOPES, Input, PairedRatio, Peer, Row, RowName, Skipped, Study,
                          table_order)
from report.provenance import check_provenance
from report.speedups import load_speedups

NAME_FORM = "case/technique/isa/threads/scope/input"
NANOSECONDS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}

Repetitions = dict[RowName, list[Fields]]
References = dict[tuple[Case, str], float]


def load_study(directory: Path) -> Study:
    """Everything the report needs to know about the run in `directory`."""
    if not directory.is_dir():
        raise ReportError(f"{directory}: no such directory; give one that holds timings.json")
    timings = read_object(directory / "timings.json")
    machine = load_machine(read_object(directory / "machine.json"))
    rows_file = read_object(directory / "rows.json")
    rows_file.check_schema()
    _refuse_failures(rows_file)
    inputs = tuple(_load_input(fields) for fields in rows_file.children("inputs"))
    check_provenance(directory, machine, timings, inputs)
    speedups = load_speedups(directory)
    timed = _load_rows(timings)
    _check_sizes(timed, inputs)
    _check_pairs(speedups, timed)
    rows = [replace(row, paired=speedups.get(row.name)) for row in timed]
    return Study(
        directory=directory, machine=machine, rows=tuple(sorted(rows, key=table_order)),
        inputs=inputs,
        skipped=tuple(Skipped(fields.text("row"), fields.text("reason"))
                      for fields in rows_file.children("skipped")),
        verified=rows_file.count("verified"), warnings=run_warnings(timings),
        peers=_load_peers(rows_file), controls=load_controls(directory) if speedups else None)


def parse_name(text: str, where: str, border: str = "") -> RowName:
    """Splits a benchmark's name; what Google Benchmark appends to the six fields is dropped.

    `border` is the row's label, which older runs lack.
    """
    fields = text.split("/")[:6]
    if len(fields) < 6 or not all(field.strip() and field.isprintable() for field in fields):
        raise ReportError(f"{where}: malformed name '{text}'; it must be {NAME_FORM}")
    case_name, technique, isa, threads, scope, input_name = fields
    case = case_named(case_name, border)
    if case is None:
        raise ReportError(f"{where}: malformed name '{text}': case is '{case_name}'; it must be "
                          "operation, operation:keep, operation:N or operation:keep:N")
    if not (threads.isascii() and threads.isdigit() and int(threads) > 0):
        raise ReportError(f"{where}: malformed name '{text}': threads is '{threads}'; "
                          "it must be a whole number above zero")
    if scope not in SCOPES:
        raise ReportError(f"{where}: malformed name '{text}': scope is '{scope}'; "
                          f"it must be {' or '.join(SCOPES)}")
    return RowName(case, technique, isa_label(isa), int(threads), scope, input_name)


def _load_rows(timings: Fields) -> list[Row]:
    repetitions: Repetitions = defaultdict(list)
    for entry in _iterations(timings):
        border = checked_border(entry.data.get("label", ""), entry.where)
        repetitions[parse_name(entry.text("name"), timings.where, border)].append(entry)
    if not repetitions:
        raise ReportError(f"{timings.where}: no rows; at least one benchmark of run_type "
                          "'iteration' is needed (no aggregates-only output, no empty filter)")
    samples = {name: tuple(_time_ns(name, entry) for entry in entries)
               for name, entries in repetitions.items()}
    references = {(name.case, name.input): float(np.median(times))
                  for name, times in samples.items() if name.is_reference}
    return [_make_row(_placed(name, references), entries, samples[name], references, timings.where)
            for name, entries in repetitions.items()]


def _placed(name: RowName, references: References) -> RowName:
    """Beside the case whose pixels it gives, where that was timed."""
    case = place_of_peer(name.case, name.technique)
    return replace(name, case=case) if (case, name.input) in references else name


def _iterations(timings: Fields) -> Iterator[Fields]:
    """The single repetitions; the library's own aggregates are passed over."""
    for entry in timings.children("benchmarks"):
        if entry.data.get("error_occurred"):
            reason = entry.data.get("error_message", "no message")
            raise ReportError(f"{timings.where}: benchmark '{entry.text('name')}' failed: "
                              f"{reason}; a report needs a run without errors")
        if entry.data.get("run_type") != "aggregate":
            yield entry


def _time_ns(name: RowName, entry: Fields) -> float:
    """Processor time for one thread, which other processes hardly disturb; else wall time."""
    unit = entry.text("time_unit")
    if unit not in NANOSECONDS:
        raise ReportError(f"{entry.where}: time_unit is '{unit}'; "
                          f"it must be one of {', '.join(NANOSECONDS)}")
    return NANOSECONDS[unit] * entry.positive("cpu_time" if name.threads == 1 else "real_time")


def _make_row(name: RowName, entries: list[Fields], samples_ns: tuple[float, ...],
              references: References, where: str) -> Row:
    for entry in entries:
        if entry.data.get("verified") != 1:
            raise ReportError(f"{where}: row {name} was not verified: its counter 'verified' is "
                              f"{entry.data.get('verified')}; it must be 1")
    reference_ns = references.get((name.case, name.input))
    if reference_ns is None:
        needed = f"{name.case.name}/reference/baseline/1/end_to_end/{name.input}"
        raise ReportError(f"{where}: row {name} has nothing to be compared to; a row {needed} "
                          "is needed")
    shapes = {_shape(entry) for entry in entries}
    if len(shapes) > 1:
        raise ReportError(f"{where}: row {name}: the repetitions disagree on (width, height, "
                          f"iterations): {sorted(shapes, key=str)}; they must be equal")
    return Row(name, *shapes.pop(), samples_ns=samples_ns, reference_ns=reference_ns,
               is_peer=entries[0].data.get("peer") == 1,
               plan_bytes=entries[0].count("plan_bytes") if entries[0].has("plan_bytes") else None)


def _shape(entry: Fields) -> tuple[int, int, int | None]:
    key = entry.renamed("counted_iterations", "passes")
    iterations = entry.count(key) if entry.has(key) else None
    return entry.count("width", 1), entry.count("height", 1), iterations


def _load_peers(rows_file: Fields) -> tuple[Peer, ...]:
    """Runs from before there were peers have none; older ones do not say which are equal."""
    if not rows_file.has("peers"):
        return ()
    return tuple(Peer(fields.text("technique"), fields.text("about"),
                      fields.data.get("equal_output", fields.text("technique") == "opencv") is True)
                 for fields in rows_file.children("peers"))


def _load_input(fields: Fields) -> Input:
    return Input(fields.text("name"), fields.count("width", 1), fields.count("height", 1),
                 fields.text("hash"), fields.count("object_pixels"))


def _refuse_failures(rows_file: Fields) -> None:
    failed = rows_file.count("failed")
    if failed:
        raise ReportError(f"{rows_file.where}: failed is {failed}: a variant differed from the "
                          "reference; it must be 0 before times are reported")


def _check_pairs(speedups: dict[RowName, PairedRatio], rows: list[Row]) -> None:
    """A speed-up of a row that was not timed comes from another run."""
    strange = speedups.keys() - {row.name for row in rows}
    if strange:
        raise ReportError(f"speedups.csv: row {min(map(str, strange))} is not in timings.json; "
                          "all files must come from one run")


def _check_sizes(rows: list[Row], inputs: tuple[Input, ...]) -> None:
    """A row timed on another size than its input has would be a wrong ns per pixel."""
    known = {item.name: (item.width, item.height) for item in inputs}
    for row in rows:
        size, right = (row.width, row.height), known.get(row.name.input)
        if right is None:
            raise ReportError(f"timings.json: row {row.name}: rows.json has no input "
                              f"'{row.name.input}'; its size and hash are needed")
        if size != right:
            raise ReportError(f"timings.json: row {row.name} says {size[0]} x {size[1]} pixels; "
                              f"rows.json says {right[0]} x {right[1]} for this input")
