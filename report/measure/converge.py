"""Effort where it is needed: processes go on with what has not converged."""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Sequence

from report.measure.estimates import NEEDED, Floor, floor_of
from report.measure.sampler import Choice, Json, Sampler, Samples, seconds_of
from report.progress import Progress


def floors(samples: Samples, group: int) -> list[Floor]:
    """Of the entries of a group, the controls included."""
    return [floor_of(found) for found in
            ([process.groups[group][entry] for process in samples.processes
              if process.groups[group][entry]]
             for entry in range(len(samples.plan["groups"][group]["entries"])))]


def open_entries(samples: Samples) -> Choice:
    """What has not converged; all of it before there are enough processes."""
    plan: Json = samples.plan
    enough = len(samples.processes) >= NEEDED
    work = {index: [entry for entry in range(len(group["entries"]))
                    if not enough or not floors(samples, index)[entry].converged]
            for index, group in enumerate(plan["groups"])}
    return {index: entries for index, entries in work.items() if entries}


def measure_until_converged(jobs: Sequence[tuple[Sampler, Samples]], seconds: float,
                            on_process: Callable[[Samples], None] = lambda samples: None) -> None:
    """NEEDED processes of everything, then of what has not converged, as long as they fit the
    budget of seconds. All are given at one clock."""
    cycle = min(samples.plan["cycle_ns"] for _, samples in jobs)
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
    samples.processes.append(sampler.measure(
        samples.plan, len(samples.processes),
        lambda _: progress.set(time.monotonic() - progress.start), chosen))
    on_process(samples)
    return True
