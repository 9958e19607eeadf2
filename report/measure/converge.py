"""Effort where it is needed: processes go on with what has not converged."""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Sequence
from statistics import median

from report.errors import ReportError
from report.measure.estimates import NEEDED, Floor, floor_of
from report.measure.sampler import Choice, Sampler, Samples, seconds_of
from report.progress import Progress

SAME_WITHIN, FOUND = 0.03, 0.5
"""How near to 1 a row's ratio to itself must be, and what part of the injected slowdown must be found."""


def floors(samples: Samples, group: int) -> list[Floor]:
    """Of the entries of a group, the controls included."""
    return [floor_of(found) for found in
            ([process.groups[group][entry] for process in samples.processes
              if process.groups[group][entry]]
             for entry in range(len(samples.plan["groups"][group]["entries"])))]


def open_entries(samples: Samples) -> Choice:
    """What has not converged, and groups whose controls fail; all of it before there are enough
    processes."""
    work = {index: _open_in(samples, index) for index in range(len(samples.plan["groups"]))}
    return {index: entries for index, entries in work.items() if entries}


def _open_in(samples: Samples, index: int) -> list[int]:
    entries = samples.plan["groups"][index]["entries"]
    if len(samples.processes) < NEEDED or control_flag(samples, index):
        return list(range(len(entries)))
    return [number for number, floor in enumerate(floors(samples, index)) if not floor.converged]


def control_flag(samples: Samples, index: int) -> str:
    """"control" where the group's A/A control or its injected slowdown failed."""
    base, same, slowed, delay = _controls(samples, index)
    good = abs(base.time / same.time - 1) <= SAME_WITHIN and slowed.time - base.time >= FOUND * delay
    return "" if good else "control"


def control_ratios(samples: Samples, index: int) -> tuple[float, float]:
    """Speed of the A/A control and of the slowed row in a group over the row that they repeat."""
    base, same, slowed, _ = _controls(samples, index)
    return base.time / same.time, base.time / slowed.time


def _controls(samples: Samples, index: int) -> tuple[Floor, Floor, Floor, float]:
    """The row, the row again, the slowed one, and what it is slowed by."""
    entries, times = samples.plan["groups"][index]["entries"], floors(samples, index)
    base = next(number for number, entry in enumerate(entries) if entry["name"] == entries[-1]["name"])
    same, slowed = (next(number for number, entry in enumerate(entries) if entry["role"] == role)
                    for role in ("same", "slowed"))
    return times[base], times[same], times[slowed], entries[slowed]["delay_ns"]


def measure_until_converged(jobs: Sequence[tuple[Sampler, Samples]], seconds: float,
                            on_process: Callable[[Samples], None] = lambda samples: None) -> None:
    """NEEDED processes of everything, then of what has not converged, as long as they fit the
    budget of seconds. All are given at one clock."""
    if not any(samples.plan["groups"] for _, samples in jobs):
        reasons = sorted({row["reason"] for _, samples in jobs for row in samples.plan["skipped"]})
        raise ReportError(f"every row that matches is skipped: {'; '.join(reasons)}", 2)
    cycle = median(samples.plan["cycle_ns"] for _, samples in jobs)
    for _, samples in jobs:
        samples.plan["cycle_ns"] = cycle
    progress = Progress("measuring", seconds)
    try:
        while any([_advance(*job, seconds, progress, on_process)
                   for job in random.sample(jobs, len(jobs))]):
            pass
    finally:
        progress.close()


def _advance(sampler: Sampler, samples: Samples, seconds: float, progress: Progress,
             on_process: Callable[[Samples], None]) -> bool:
    """One more process, unless nothing is open or the budget is spent."""
    chosen = open_entries(samples)
    spent = time.monotonic() - progress.start
    fits = spent + seconds_of(samples.plan, chosen) <= seconds
    if not chosen or (not fits and len(samples.processes) >= NEEDED):
        return False
    samples.processes.append(sampler.measure(samples.plan, len(samples.processes), chosen,
                                             lambda: progress.set(time.monotonic() - progress.start)))
    on_process(samples)
    return True
