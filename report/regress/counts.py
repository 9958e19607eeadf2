"""The exact layer: `thinbench-study instructions` counts and compares, this reads what it says."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from report.errors import ReportError
from report.files import read_json
from report.regress.verdicts import Layer, RowVerdict, Verdict

NOTHING_COMPARED = 4
MORE = ("(+", "too many to count", "iterations before")
"""What marks a row that takes over 1 % more instructions, or another number of iterations."""


@dataclass(frozen=True)
class Counts:
    """The layer's verdict and the counts themselves, by row."""

    layer: Layer
    instructions: dict[str, int] = field(default_factory=dict)


def not_compared(why: str) -> Counts:
    """Nothing to compare with."""
    return Counts(Layer(Verdict.SKIPPED, [], f"instructions are not compared: {why}"))


def count(program: Path, words: Sequence[str], out: Path) -> str:
    """Counts into a file. Returns why that was impossible, or ""."""
    done = _run(program, [*words, "--out", str(out)])
    return "" if done.returncode == 0 and out.exists() else _last_line(done.stderr)


def compare(program: Path, words: Sequence[str], before: Path) -> Counts:
    """This build's counts with those in a file. A file of another version, or a filter without
    rows on one thread, is nothing to compare; a build that cannot count is an error."""
    if not before.exists():
        return not_compared(f"there is no '{before}'; ./study regress --update writes it")
    with tempfile.TemporaryDirectory() as directory:
        out = Path(directory) / "counts.json"
        done = _run(program, [*words, "--out", str(out), "--against", str(before)])
        if not out.exists():
            return _why_not(done, before)
        if done.returncode not in (0, 1, NOTHING_COMPARED):
            raise ReportError(f"instructions cannot be compared: {_last_line(done.stderr)}")
        found = _instructions_in(out)
    known = [row for row in found if row in _instructions_in(before)]
    return Counts(layer_from(done.stdout, done.returncode, known), found)


def layer_from(text: str, status: int, names: Sequence[str]) -> Layer:
    """From the output and exit status of a comparison of these rows."""
    lines = text.strip().splitlines() or ["no row was counted before"]
    if status == NOTHING_COMPARED:
        return not_compared(lines[0].removeprefix("nothing compared: ")).layer
    remarks = dict(line.rsplit(": ", 1) for line in lines[:-1] if "/" in line)
    rows = [RowVerdict(name, Verdict.FAIL, remark) for name, remark in remarks.items()
            if any(mark in remark for mark in MORE)]
    failed = {row.name for row in rows}
    rows += [RowVerdict(name, Verdict.PASS, remarks.get(name, "")) for name in names
             if name not in failed]
    return Layer(Verdict.FAIL if status == 1 else Verdict.PASS, rows, lines[-1])


def _instructions_in(file: Path) -> dict[str, int]:
    return {row["row"]: row["instructions"] for row in read_json(file)["rows"]}


def _why_not(done: subprocess.CompletedProcess[str], before: Path) -> Counts:
    why = _last_line(done.stderr)
    if done.returncode == 2 or (done.returncode == 1 and why.startswith(f"'{before}' ")):
        return not_compared(why)
    raise ReportError(f"instructions cannot be counted: {why}")


def _run(program: Path, words: Sequence[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program, "instructions", *words], check=False, text=True,
                          capture_output=True)


def _last_line(text: str) -> str:
    lines = text.strip().splitlines() or ["it says nothing"]
    return lines[-1].removeprefix("thinbench: ")
