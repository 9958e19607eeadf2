"""Starts thinbench_benchmarks: once to verify rows, then fresh processes that measure them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from report.errors import ReportError

Json = dict[str, Any]

AGAIN, SLOWED = "/again", "/slowed"
"""What follows the name of a row where it is measured as a control."""


class Benchmarks:
    """The program of one build."""

    def __init__(self, program: Path) -> None:
        self.program = program

    def verify(self, options: Sequence[str], remarks: bool = True) -> Json:
        """Facts on the rows that equal their references. Raises ReportError where one differs or none is left.
        What is said about images is shown only with `remarks`."""
        with tempfile.TemporaryDirectory() as work:
            file = Path(work, "facts.json")
            done = subprocess.run([self.program, *options, "--facts", file], text=True, check=False,
                                  stderr=None if remarks else subprocess.PIPE)
            facts: Json = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        if done.returncode != 0:
            sys.stderr.write(done.stderr or "")
            what = "a variant differs from its reference" if facts else "nothing was measured"
            raise ReportError(f"{what}; see above", 2 if done.returncode == 2 else 1)
        _report_skipped(facts)
        return facts

    def measure(self, facts: Json, options: Sequence[str] = ()) -> pd.DataFrame:
        """What one fresh process finds: a line for each repetition of each row and control, with the columns row,
        ns, before, after and cycle. A row that fails has fewer lines or none, and of a process that ends early what it
        wrote counts."""
        with tempfile.TemporaryDirectory() as work:
            known, samples = Path(work, "facts.json"), Path(work, "samples.csv")
            known.write_text(json.dumps(facts), encoding="utf-8")
            done = subprocess.run([self.program, "--known", known, "--samples", samples, *options], check=False)
            if done.returncode != 0 and not (samples.exists() and os.path.getsize(samples)):
                raise ReportError("a measuring process failed; see the line above")
            return _times(pd.read_csv(samples), facts["rows"])


def _times(table: pd.DataFrame, rows: Json) -> pd.DataFrame:
    """Processor time where one thread works, as being interrupted does not count; the clock on the wall where
    several do."""
    table = table.dropna()  # the last line of a process that ended early may be cut
    table = table[table["row"].map(row_of).isin(rows)]
    threads = table["row"].map(lambda name: rows[row_of(name)]["threads"])
    ns = table["cpu_ns"].where(threads == 1, table["wall_ns"])
    return pd.DataFrame({"row": table["row"], "ns": ns, "before": table["probe_before_ns"],
                         "after": table["probe_after_ns"], "cycle": table["cycle_ns"]})


def row_of(name: str) -> str:
    """The row that a control repeats; of a row its own name."""
    return name.removesuffix(AGAIN).removesuffix(SLOWED)


_reported: set[str] = set()
"""Reasons."""


def _report_skipped(facts: Json) -> None:
    """Why rows are missing, each reason once, however often rows are verified."""
    reasons = {row["reason"] for row in facts["skipped"]} - _reported
    _reported.update(reasons)
    for reason in sorted(reasons):
        print(f"note: some rows are skipped: {reason}", file=sys.stderr, flush=True)


def groups_of(facts: Json) -> list[list[str]]:
    """Names of rows of one case on one input, which share a reference and controls."""
    found: dict[tuple[str, str], list[str]] = {}
    for name, row in facts["rows"].items():
        found.setdefault((row["case"], row["input"]), []).append(name)
    return list(found.values())


def with_rows(facts: Json, names: Iterable[str]) -> Json:
    """The same facts on these rows alone."""
    return facts | {"rows": {name: facts["rows"][name] for name in names}}
