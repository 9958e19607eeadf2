"""A measurement: what is measured, round after round, kept so that an interrupted one can go on."""

from __future__ import annotations

import json
import random
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import pandas as pd

from report.errors import ReportError
from report.files import read_bytes, to_json, write_file
from report.measure.benchmarks import Benchmarks, Json, with_rows
from report.measure.estimates import NEEDED_PROCESSES
from report.progress import Progress

UNFINISHED = "unfinished"
"""Directory of what an interrupted measurement can go on with, in that of the run."""
PLAN = "plan.json"

COLUMNS = ("process", "row", "ns", "before", "after", "cycle")


@dataclass
class Part:
    """Rows that are measured together by the same processes: of some images, or of a sweep."""

    facts: Json
    sweep: str = ""
    options: list[str] = field(default_factory=list)
    """For the measuring program."""
    seconds: float = 0.0
    """That the latest process took."""
    tables: list[pd.DataFrame] = field(default_factory=list)
    """One for each process."""

    @property
    def samples(self) -> pd.DataFrame:
        """Of all processes."""
        return (pd.concat(self.tables, ignore_index=True) if self.tables
                else pd.DataFrame({name: [] for name in COLUMNS}))


class Measurement:
    """Parts, in a directory. `key` is what must be equal for a measurement to go on."""

    def __init__(self, directory: Path, key: Json, parts: list[Part]) -> None:
        self.directory, self.key, self.parts = directory / UNFINISHED, key, parts

    @staticmethod
    def begin(directory: Path, key: Json, make: Callable[[], list[Part]]) -> Measurement:
        """Raises ReportError where there is an interrupted one; else `make` verifies what is to be measured."""
        if (directory / UNFINISHED).exists():
            raise ReportError(f"'{directory}' holds an interrupted measurement: continue it with --resume, delete "
                              f"'{directory / UNFINISHED}', or choose another --out")
        parts = make()
        one = Measurement(directory, key, parts)
        if not any(part.facts["rows"] for part in parts):
            reasons = sorted({row["reason"] for part in parts for row in part.facts["skipped"]})
            raise ReportError(f"every row that matches is skipped: {'; '.join(reasons)}", 2)
        write_file(one.directory / PLAN, to_json({"key": key, "parts": [
            {"facts": part.facts, "sweep": part.sweep, "options": part.options} for part in parts]}))
        return one

    @staticmethod
    def resume(directory: Path, key: Json) -> Measurement:
        """What was interrupted there. Raises ReportError where there is nothing, or something else."""
        path = directory / UNFINISHED / PLAN
        try:
            plan = json.loads(read_bytes(path))
            parts = [Part(**part) for part in plan["parts"]]
            old = plan["key"]
        except (ValueError, TypeError, LookupError, RecursionError):
            raise ReportError(f"{path}: cannot be continued; delete it, or choose another --out") from None
        for name, value in key.items():
            if old.get(name) != value:
                raise ReportError(f"{path}: {name} was {old.get(name)!r} and is now {value!r}; --resume needs the same")
        one = Measurement(directory, key, parts)
        for number, part in enumerate(parts):
            for process in range(1_000_000):
                file = one._file(number, process)
                if not file.exists():
                    break
                try:
                    part.tables.append(pd.read_csv(file))
                except ValueError:
                    raise ReportError(f"{file}: is no table; delete '{path.parent}', or choose another --out") from None
        return one

    def run(self, benchmarks: Benchmarks, seconds: float) -> bool:
        """Fresh processes of all parts, in rounds of random order, as many as fit the budget, and at least so many
        that times can settle. False where Ctrl-C ended it."""
        progress = Progress("measuring", seconds)
        try:
            while self._round(benchmarks, seconds, progress):
                pass
        except KeyboardInterrupt:
            return False
        finally:
            progress.close()
        return True

    def _round(self, benchmarks: Benchmarks, seconds: float, progress: Progress) -> bool:
        """Whether one more fitted."""
        spent = time.monotonic() - progress.start
        rounds = min(len(part.tables) for part in self.parts)
        if rounds >= NEEDED_PROCESSES and spent + sum(part.seconds for part in self.parts) > seconds:
            return False
        for number in random.sample(range(len(self.parts)), len(self.parts)):
            if len(self.parts[number].tables) == rounds:
                self._process(number, benchmarks)
                spent = time.monotonic() - progress.start
                progress.set(spent, max(seconds, spent + self._needed_seconds()))
        return True

    def _needed_seconds(self) -> float:
        """What the processes take that must still run, by each part's last one."""
        return sum(part.seconds * max(NEEDED_PROCESSES - len(part.tables), 0) for part in self.parts)

    def _process(self, number: int, benchmarks: Benchmarks) -> None:
        part = self.parts[number]
        start, process = time.monotonic(), len(part.tables)
        table = benchmarks.measure(part.facts, part.options + ["--checked"] * (process > 0))
        table.insert(0, "process", process)
        write_file(self._file(number, process), table.to_csv(index=False).encode())
        part.tables.append(table)
        part.seconds = time.monotonic() - start

    def _file(self, part: int, process: int) -> Path:
        return self.directory / f"{part}-{process}.csv"

    def close(self) -> None:
        """The measurement is complete."""
        for file in self.directory.iterdir():
            file.unlink()
        self.directory.rmdir()


def measured(benchmarks: Benchmarks, facts: Json, processes: int, rows: Sequence[str] | None = None,
             options: Sequence[str] = ()) -> pd.DataFrame:
    """So many processes on these rows, or all, without a directory."""
    chosen = facts if rows is None else with_rows(facts, rows)
    tables = [benchmarks.measure(chosen, options).assign(process=number) for number in range(processes)]
    return pd.concat(tables, ignore_index=True)
