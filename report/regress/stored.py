"""Comparison with a stored baseline."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from report.files import read_json
from report.measure.estimates import Estimate
from report.measure.benchmarks import Json
from report.measure.estimates import Estimates
from report.measure.measurement import Part
from report.measure.run import controls_of, state_of
from report.measure.timings import Origin, Row, rows_of
from report.regress.verdicts import RowVerdict, Times, Verdict, skipped
from report.schemas import check_schema

SCHEMA = 3
PROCESSES, UPDATE_PROCESSES = 6, 20
"""Of a round of a comparison, and of a baseline, all rows of which must settle."""

LIMIT, LIMIT_BEYOND_CACHE = 0.10, 0.20
"""Tolerated loss of speed on another day."""

SAME_STATE = 0.05
"""How far times of references, which never change, may move: their median before the machine counts as another one, on
which only speed-ups compare; a single one before a FAIL of its case is doubted."""

@dataclass(frozen=True)
class Measured:
    """A run as a baseline holds it."""

    rows: list[Row]
    hashes: dict[str, str]  # of inputs, by name
    state: Json
    controls: Json


def measured_from(facts: Json, samples: pd.DataFrame) -> Measured:
    """The rows that have a reference, peers omitted."""
    part, times = Part(facts), Estimates(samples)
    rows = [row for row in rows_of(facts, times, Origin("", "", ""))
            if row.speedup_vs_reference is not None and not row.peer]
    # The hash of the grey image as well: it is what edges are found in.
    hashes = {item["name"]: f"{item['hash']}-{item['grey_hash']}" for item in facts["inputs"]}
    return Measured(rows, hashes, state_of([(part, times)]), controls_of([(part, times)]))


def why_unfit(now: Measured) -> str:
    """Why a run cannot be a baseline; else ""."""
    unsettled = [row.name for row in now.rows if row.flags]
    return f"{len(unsettled)} rows did not settle, such as {unsettled[0]}" if unsettled else ""


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


def against_baseline(now: Measured, baseline: Json, cache_bytes: float, judge_threads: bool,
                     is_part: bool = False) -> list[RowVerdict]:
    """A verdict on every row of either, at the clock of now; where `is_part`, of now."""
    clock = now.state["cycle_ns"] / baseline["state"]["cycle_ns"]
    rows = {name: row | {key: clock * row[key] for key in ("time_ns", "reference_ns")}
            for name, row in baseline["rows"].items()}
    own = {row.name: row for row in now.rows if not row.is_reference}
    references = {(row.case, row.input): _reference_ns(row) / rows[name]["reference_ns"]
                  for name, row in own.items()
                  if name in rows and now.hashes[row.input] == rows[name]["input_hash"]}
    state = float(np.median([*references.values()] or [1]))
    found = [_verdict(row, rows.get(name), now, cache_bytes, judge_threads, state) for name, row in own.items()]
    return found + [skipped(name, "not measured in this run") for name in rows
                    if name not in own and not is_part]


def _row_json(row: Row, input_hash: str) -> Json:
    return {"input_hash": input_hash, "time_ns": row.time_ns, "reference_ns": _reference_ns(row)}


def _reference_ns(row: Row) -> float:
    assert row.speedup_vs_reference
    return row.time_ns * row.speedup_vs_reference


def _speedup_of(row: Json) -> float:
    return float(row["reference_ns"] / row["time_ns"])


def _change(before: Json, now: Json) -> float | None:
    logs = [np.log(_speedup_of(row) / _speedup_of(before[name]))
            for name, row in now.items() if name in before]
    return float(np.exp(np.mean(logs))) if logs else None


def _verdict(row: Row, before: Json | None, now: Measured, cache_bytes: float, judge_threads: bool,
             state: float) -> RowVerdict:
    """`state`: by what the machine is slower than before."""
    if before is None:
        return skipped(row.name, "new: there is nothing to compare with")
    if now.hashes[row.input] != before["input_hash"]:
        return skipped(row.name, "another image than in the baseline")
    if row.threads > 1 and not judge_threads:
        return skipped(row.name, "threads are judged with --judge-threads only")
    limit = LIMIT_BEYOND_CACHE if 2 * row.width * row.height > cache_bytes else LIMIT
    reference = _reference_ns(row)
    another = abs(np.log(state)) > SAME_STATE
    factor = reference / before["reference_ns"] if another else 1.0
    change = Estimate(*(factor * before["time_ns"] / ns
                        for ns in (row.time_ns, row.high_ns, row.time_ns)))
    verdict = Verdict.FAIL if change.value < 1 - limit else Verdict.PASS
    speedup = Estimate(reference / row.time_ns, *_bounds(row))
    result = RowVerdict(row.name, verdict, "", change, limit,
                        Times(before["time_ns"], before["reference_ns"]),
                        Times(row.time_ns, reference), speedup)
    doubt = _moved(before["reference_ns"], reference) or {
        "": "", "open": "its time did not settle", "control": "the controls of its case failed"}[row.flags]
    return result.doubted(doubt) if verdict == Verdict.FAIL and doubt else result


def _bounds(row: Row) -> tuple[float, float]:
    """Of the speed-up."""
    assert row.speedup_low and row.speedup_high
    return row.speedup_low, row.speedup_high


def _moved(before: float, now: float) -> str:
    if abs(np.log(now / before)) <= SAME_STATE:
        return ""
    return f"another state of the machine: the reference took {before:.4g} ns, now {now:.4g} ns"
