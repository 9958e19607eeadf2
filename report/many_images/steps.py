"""What is measured once in each round, and the loop over rounds."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import pandas as pd

from report.errors import ReportError
from report.progress import Progress

IMAGES, WORKERS, CALLS, CHUNKS = "images", "workers", "calls", "dask"
"""The experiments."""

IN_MEMORY = "in memory"

STAGES = ("decode", "compute", "encode")
"""Of a file."""

QUANTITIES = (*(f"{stage}_ms" for stage in STAGES), "total_ms", "ms_per_image", "ms_per_call", "ns_per_pixel")

Figures = dict[str, list[float]]
"""Quantity to its epochs in one round. Every quantity is a time."""


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


def measure(steps: list[Step], rounds: int) -> pd.DataFrame:
    """Verifies every step, then runs all in each round, in random order. A line for each epoch; the column row is
    row_of() of step and quantity.

    A round takes the place of a process: this one holds arrays, OpenCV and dask's workers, which take
    seconds to start; what is a program of its own is started in each round. There is no probe, so that every epoch
    counts as quiet."""
    seconds = _verify(steps)
    lines: list[tuple[int, str, float]] = []
    progress = Progress("measuring", rounds * sum(seconds.values()))
    for number in range(rounds):
        for step in random.Random(number).sample(steps, len(steps)):
            lines += [(number, row_of(step.key, quantity), epoch)
                      for quantity, epochs in step.run().items() for epoch in epochs]
            progress.advance(seconds[step.key])
    progress.close()
    return pd.DataFrame(lines, columns=["process", "row", "ns"]).assign(before=1.0, after=1.0, cycle=1.0)


def row_of(key: Key, quantity: str) -> str:
    """The name of a quantity of a step in a table of samples."""
    return f"{key.experiment}/{key.method}/{key.x}/{quantity}"


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
