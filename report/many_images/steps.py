"""What is measured once in each round, and the loop over rounds."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from report.errors import ReportError
from report.measure.estimates import Floor, floor_of
from report.progress import Progress

IMAGES, WORKERS, CALLS, CHUNKS = "images", "workers", "calls", "dask"
"""The experiments."""

IN_MEMORY = "in memory"

STAGES = ("decode", "compute", "encode")
"""Of a file."""

Figures = dict[str, list[float]]
"""Quantity to its epochs in one round. Every quantity is a time, so that the lowest counts."""


class Key(NamedTuple):
    """`x` is what the experiment varies; 0 for nothing."""

    experiment: str
    method: str
    x: int = 0


@dataclass(frozen=True)
class Step:
    """`digest` tells what the latest run computed; it must be that of `base`, a step before this one,
    which ratios refer to."""

    key: Key
    base: Key
    run: Callable[[], Figures]
    digest: Callable[[], str]


Samples = dict[Key, list[Figures]]


def measure(steps: list[Step], rounds: int) -> Samples:
    """Verifies every step, then runs in each round, in random order, what has not converged.

    A round takes the place of a process: this one holds arrays, OpenCV and dask's workers, which take
    seconds to start; what is a program of its own is started in each round."""
    seconds = _verify(steps)
    samples: Samples = {step.key: [] for step in steps}
    progress = Progress("measuring", rounds * sum(seconds.values()))
    for number in range(rounds):
        work = [step for step in steps if not _converged(samples[step.key])]
        for step in random.Random(number).sample(work, len(work)):
            samples[step.key].append(step.run())
            progress.advance(seconds[step.key])
    progress.close()
    return samples


def floors(rounds: list[Figures]) -> dict[str, Floor]:
    """Of each quantity of a step."""
    return {quantity: floor_of([[found[quantity]] for found in rounds]) for quantity in rounds[0]}


def _converged(rounds: list[Figures]) -> bool:
    return bool(rounds) and all(floor.converged for floor in floors(rounds).values())


def _verify(steps: list[Step]) -> dict[Key, float]:
    """How long each step took."""
    progress = Progress("verifying", len(steps))
    seconds, digests = {}, {}
    for step in steps:
        start = time.monotonic()
        step.run()
        seconds[step.key] = time.monotonic() - start
        digests[step.key] = step.digest()
        if digests[step.key] != digests[step.base]:
            raise ReportError(f"{step.key.method}: other pixels than {step.base.method}", 2)
        progress.advance(1)
    progress.close()
    return seconds
