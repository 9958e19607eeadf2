"""Starts the sampler: one plan, then fresh processes in random order."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from report.errors import ReportError
from report.measure.load import LoadMeter

Json = dict[str, Any]

Choice = Mapping[int, Sequence[int]]
"""Entries of a plan, by group."""

Layouts = list[list[float]]
"""Nanoseconds of a call by layout and epoch; empty where an entry was not measured."""


@dataclass
class Process:
    """What one measuring process found."""

    seed: int
    groups: list[list[Layouts]]  # groups and entries in the order of the plan
    states: list[Json]  # of the machine, before and after
    foreign_load: float  # processors that other processes kept busy meanwhile


@dataclass
class Samples:
    """A plan and what its processes found."""

    plan: Json
    processes: list[Process] = field(default_factory=list)

    def to_json_lines(self) -> Iterator[str]:
        """One line for the plan, one for each process."""
        yield json.dumps({"plan": self.plan}, separators=(",", ":"))
        for process in self.processes:
            yield json.dumps(vars(process), separators=(",", ":"))

    @staticmethod
    def from_json_lines(lines: Sequence[str]) -> list[Samples]:
        """All plans of a file, each with its processes."""
        runs: list[Samples] = []
        for line in lines:
            data = json.loads(line)
            if "plan" in data:
                runs.append(Samples(data["plan"]))
            else:
                runs[-1].processes.append(Process(**data))
        return runs


class Sampler:
    """The program of one build."""

    def __init__(self, program: Path) -> None:
        self.program = program

    def plan(self, options: Sequence[str], remarks: bool = True) -> Json:
        """Verifies rows and plans them. Raises ReportError where a row differs or none is left. What is
        said about images is shown only with `remarks`."""
        done = subprocess.run([self.program, "plan", *options], stdout=subprocess.PIPE, text=True,
                              check=False, stderr=None if remarks else subprocess.PIPE)
        if done.returncode != 0:
            sys.stderr.write(done.stderr or "")
            what = "a variant differs from its reference" if done.stdout else "nothing was measured"
            raise ReportError(f"{what}; see above", 2 if done.returncode == 2 else 1)
        plan: Json = json.loads(done.stdout)
        _report_skipped(plan)
        return plan

    def measure(self, plan: Json, seed: int, chosen: Choice | None = None,
                on_result: Callable[[], None] = lambda: None) -> Process:
        """One fresh process. `chosen` are the entries to measure, by group; those of the others
        stay empty."""
        groups: list[list[Layouts]] = [[[] for _ in group["entries"]]
                                       for group in plan["groups"]]
        work = every_entry(plan) if chosen is None else chosen
        order = list(work)
        states: list[Json] = []
        load = LoadMeter()
        with subprocess.Popen([self.program, "measure", "--seed", str(seed)], text=True,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
            assert process.stdin and process.stdout
            with suppress(BrokenPipeError):  # it has failed, as its exit status says
                json.dump({"sources": plan["sources"], "cycle_ns": plan["cycle_ns"],
                           "groups": [_part(plan["groups"][index], work[index])
                                      for index in order]}, process.stdin)
                process.stdin.close()
            for line in process.stdout:
                if not line.endswith("\n"):
                    break  # it was stopped
                result = json.loads(line)
                if "group" not in result:
                    states.append(result)
                    continue
                index = order[result["group"]]
                for entry, times in zip(work[index], result["entries"]):
                    groups[index][entry].append(times)
                on_result()
        if process.returncode != 0:
            raise ReportError("a measuring process failed; see the line above")
        return Process(seed, groups, states, load.foreign())


_reported: set[str] = set()
"""Reasons."""


def _report_skipped(plan: Json) -> None:
    """Why rows are missing, each reason once, whatever the number of plans."""
    reasons = {row["reason"] for row in plan["skipped"]} - _reported
    _reported.update(reasons)
    for reason in sorted(reasons):
        print(f"note: some rows are skipped: {reason}", file=sys.stderr, flush=True)


def every_entry(plan: Json) -> Choice:
    """All that a plan holds."""
    return {index: list(range(len(group["entries"])))
            for index, group in enumerate(plan["groups"])}


def seconds_of(plan: Json, chosen: Choice | None = None) -> float:
    """How long one process takes for these entries."""
    work = every_entry(plan) if chosen is None else chosen
    return float(sum(plan["groups"][index]["entries"][entry]["seconds"]
                     for index, entries in work.items() for entry in entries))


def _part(group: Json, entries: Sequence[int]) -> Json:
    return group | {"entries": [group["entries"][entry] for entry in entries]}
