"""Comparison with a stored baseline: speed-ups over the reference, in the same state of the
machine."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from report.files import read_json
from report.measure.estimates import Estimate
from report.measure.run import controls_of, state_of
from report.measure.sampler import Json, Samples
from report.measure.timings import BUSY_LOAD, Origin, Row, rows_of
from report.regress.verdicts import RowVerdict, Times, Verdict, judge, skipped
from report.schemas import check_schema

SCHEMA = 2
PROCESSES = 9
LIMIT, LIMIT_BEYOND_CACHE = 0.10, 0.20
"""Tolerated loss of speed on another day."""

SAME_STATE = 0.05
"""How far the times of reference, copy and chain of additions may move. On a quiet machine the last
two stay within 1 % and 2.5 % from process to process; a busy neighbour on the same physical core
doubles both."""

BUSY = f"other processes keep more than {BUSY_LOAD} processors busy"


@dataclass(frozen=True)
class Measured:
    """A run as a baseline holds it."""

    rows: list[Row]
    hashes: dict[str, str]  # of inputs, by name
    state: Json
    controls: Json


def measured_from(samples: Samples) -> Measured:
    """The rows that have a reference, peers omitted."""
    rows = [row for row in rows_of(samples, Origin("", "", ""))
            if row.speedup_vs_reference is not None and not row.peer]
    # The hash of the grey image as well: it is what edges are found in.
    hashes = {item["name"]: f"{item['hash']}-{item['grey_hash']}"
              for item in samples.plan["inputs"]}
    return Measured(rows, hashes, state_of([samples]), controls_of([samples]))


def why_unfit(now: Measured) -> str:
    """Why a run can neither be a baseline nor be compared with one; else ""."""
    if not now.controls["passed"]:
        return "a control failed"
    return BUSY if now.state["foreign_load"] > BUSY_LOAD else ""


def baseline_from(now: Measured, machine: Json, filter_: str, reason: str,
                  previous: Json | None) -> Json:
    """The document, with the history of the previous one."""
    rows = {row.name: _row_json(row, now.hashes[row.input]) for row in now.rows
            if not row.is_reference}
    event = {"commit": machine["commit"], "date": machine["date"], "reason": reason,
             "change": _change(previous["rows"], rows) if previous else None}
    return {"schema": SCHEMA, "kind": "baseline", "fingerprint": machine["fingerprint"],
            "commit": machine["commit"], "date": machine["date"], "filter": filter_,
            "state": now.state, "controls": now.controls, "rows": rows,
            "history": [*(previous["history"] if previous else []), event]}


def read_baseline(path: Path) -> Json | None:
    """None where there is no such file."""
    if not path.exists():
        return None
    baseline: Json = read_json(path)
    check_schema("baseline", baseline, str(path))
    return baseline


def against_baseline(now: Measured, baseline: Json, cache_bytes: float,
                     judge_threads: bool) -> list[RowVerdict]:
    """A verdict on every row of either."""
    known = {row.name for row in now.rows}
    doubt = why_unfit(now) or _state_difference(baseline["state"], now.state)
    new_neighbours = _groups_that_differ(baseline["rows"], known, now.rows)
    found = [_verdict(row, baseline["rows"].get(row.name), now, cache_bytes, judge_threads)
             for row in now.rows if not row.is_reference]
    found = [_doubted(row, doubt, new_neighbours) for row in found]
    return found + [skipped(name, "not measured in this run") for name in baseline["rows"]
                    if name not in known]


def group_of(name: str) -> str:
    """Case and input: what is measured in common rounds."""
    fields = name.split("/", 5)
    return f"{fields[0]}/{fields[5]}"


def _row_json(row: Row, input_hash: str) -> Json:
    speedup = _speedup(row)
    return {"input_hash": input_hash, "median_ns": row.median_ns,
            "reference_ns": row.median_ns * speedup.value, "speedup": vars(speedup)}


def _speedup(row: Row) -> Estimate:
    assert row.speedup_vs_reference and row.speedup_low and row.speedup_high
    return Estimate(row.speedup_vs_reference, row.speedup_low, row.speedup_high)


def _change(before: Json, now: Json) -> float | None:
    logs = [np.log(row["speedup"]["value"] / before[name]["speedup"]["value"])
            for name, row in now.items() if name in before]
    return float(np.exp(np.mean(logs))) if logs else None


def _verdict(row: Row, before: Json | None, now: Measured, cache_bytes: float,
             judge_threads: bool) -> RowVerdict:
    if before is None:
        return skipped(row.name, "new: there is nothing to compare with")
    if now.hashes[row.input] != before["input_hash"]:
        return skipped(row.name, "another image than in the baseline")
    if row.threads > 1 and not judge_threads:
        return skipped(row.name, "threads are judged with --judge-threads only")
    speedup, base = _speedup(row), before["speedup"]["value"]
    change = Estimate(speedup.value / base, speedup.low / base, speedup.high / base)
    beyond_cache = 2 * row.width * row.height > cache_bytes
    limit = LIMIT_BEYOND_CACHE if beyond_cache else LIMIT
    times = Times(row.median_ns, row.median_ns * speedup.value)
    verdict = RowVerdict(row.name, judge(change, limit), "", change, limit,
                         Times(before["median_ns"], before["reference_ns"]), times, speedup)
    moved = _moved("the reference", before["reference_ns"], times.reference or 0)
    return verdict.doubted(moved) if moved else verdict


def _moved(what: str, before: float, now: float) -> str:
    if abs(np.log(now / before)) <= SAME_STATE:
        return ""
    return f"another state of the machine: {what} took {before:.4g} ns, now {now:.4g} ns"


def _state_difference(before: Json, now: Json) -> str:
    if before["foreign_load"] > BUSY_LOAD:
        return "the baseline was measured on a busy machine"
    return (_moved("an addition", before["chain_ns"], now["chain_ns"])
            or _moved("a copy of 64 KiB", before["copy_ns"], now["copy_ns"]))


def _groups_that_differ(before: Iterable[str], known: set[str], rows: list[Row]) -> set[str]:
    references = {row.name for row in rows if row.is_reference}
    return {group_of(name) for name in set(before) ^ (known - references)}


def _doubted(row: RowVerdict, doubt: str, new_neighbours: set[str]) -> RowVerdict:
    if row.verdict == Verdict.SKIPPED:
        return row
    if doubt:
        return row.doubted(doubt)
    if row.verdict == Verdict.FAIL and group_of(row.name) in new_neighbours:
        return row.doubted("measured beside other rows than in the baseline")
    return row
