"""The exact layer: `thinbench-study instructions` counts, this compares."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from report.errors import ReportError
from report.files import read_json
from report.measure.benchmarks import Json
from report.regress.verdicts import Layer, RowVerdict, Verdict, layer_of, skipped
from report.schemas import check_schema

TOLERANCE = 0.01
"""Counts below this part of a change are the same: memory may lie a little differently."""

SINGLE_STEPS, TOO_MANY_STEPS = "single_steps", "more steps than are counted"
"""A method of counting, and why a row was skipped; both as bench/counts/row_counts.hpp has them."""


@dataclass(frozen=True)
class Counts:
    """The layer's verdict and the counts themselves, by row."""

    layer: Layer
    instructions: dict[str, int] = field(default_factory=dict)


def not_compared(why: str) -> Counts:
    """Nothing to compare with."""
    return Counts(Layer(Verdict.SKIPPED, [], f"instructions are not compared: {why}"))


def count(program: Path, words: Sequence[str]) -> Json:
    """What a build counts. Raises ReportError where it cannot."""
    with tempfile.TemporaryDirectory() as directory:
        out = Path(directory) / "counts.json"
        done = subprocess.run([program, "instructions", *words, "--out", str(out)], check=False,
                              text=True, capture_output=True)
        if done.returncode != 0 or not out.exists():
            lines = done.stderr.strip().splitlines() or ["it says nothing"]
            raise ReportError(f"instructions cannot be counted: {lines[-1]}",
                              done.returncode or 1)
        return read_counts(out)


def read_counts(file: Path) -> Json:
    """The document in a file."""
    document: Json = read_json(file)
    check_schema("counts", document, str(file))
    return document


def compare(before: Json, now: Json, is_part: bool = False) -> Counts:
    """Rows that both documents have; unless the second is a part, also those that are gone. FAIL is over 1 % more, or
    another number of iterations, which no speed of a kernel explains."""
    why_not = _difference_of(before, now)
    if why_not:
        return not_compared(why_not)
    old = {row["row"]: row for row in before["rows"]}
    rows = [_verdict(old[row["row"]], row, (before, now)) for row in now["rows"]
            if row["row"] in old]
    rows += [_too_long(old[row["row"]], now["max_steps"]) for row in now["skipped"]
             if row["row"] in old and row["reason"] == TOO_MANY_STEPS]
    known = old.keys() if is_part else {row["row"] for row in (*now["rows"], *now["skipped"])}
    rows += [skipped(name, "this build has no such row") for name in sorted(old.keys() - known)]
    compared = [row for row in rows if row.verdict != Verdict.SKIPPED]
    if not compared:
        return not_compared("no row was counted in the same way before")
    failed = sum(row.verdict == Verdict.FAIL for row in compared)
    summary = (f"instructions: {len(compared)} rows compared, {failed} of them FAIL, "
               f"{sum(bool(row.reason) for row in compared) - failed} take fewer (tolerance 1 %)")
    return Counts(layer_of(rows, summary), {row["row"]: row["instructions"] for row in now["rows"]})


def _difference_of(before: Json, now: Json) -> str:
    """What keeps the documents from being compared."""
    for name, value in now["build"].items():
        if before["build"].get(name) != value:
            return f"the counts before are of another {name.replace('_', ' ')}"
    return "" if before["input"] == now["input"] else "the counts before are of another input"


def _verdict(old: Json, row: Json, documents: tuple[Json, Json]) -> RowVerdict:
    name, was, is_now = row["row"], old["instructions"], row["instructions"]
    methods = {(one["method"], one["method"] != SINGLE_STEPS and document["valgrind"])
               for one, document in zip((old, row), documents)}
    if len(methods) > 1:
        return skipped(name, "counted by another method or valgrind before")
    iterations = [one.get("iterations") for one in (old, row)]
    if None not in iterations and iterations[0] != iterations[1]:
        return RowVerdict(name, Verdict.FAIL, f"{iterations[0]} iterations before, "
                                              f"{iterations[1]} now")
    if abs(is_now - was) <= TOLERANCE * was:
        return RowVerdict(name, Verdict.PASS)
    return RowVerdict(name, Verdict.FAIL if is_now > was else Verdict.PASS,
                      f"{was:,} instructions before, {is_now:,} now ({100 * (is_now / was - 1):+.1f} %)")


def _too_long(old: Json, max_steps: int) -> RowVerdict:
    """A row that was counted before and has become too long for it."""
    if old["method"] != SINGLE_STEPS or old["instructions"] > max_steps:
        return skipped(old["row"], "counted with other limits before")
    return RowVerdict(old["row"], Verdict.FAIL,
                      f"{old['instructions']:,} instructions before, now too many to count")
