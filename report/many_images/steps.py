"""What is measured once in each round, and the loop over rounds."""

from __future__ import annotations

import hashlib
import random
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import cv2

from report.errors import ReportError
from report.progress import Progress

Figures = dict[str, float]
"""Quantity to value."""


class Key(NamedTuple):
    """`x` is what the experiment varies; 0 for nothing."""

    experiment: str
    method: str
    x: int = 0


@dataclass(frozen=True)
class Step:
    """`run` takes the number of the round. `digest` tells what the latest run computed; it must be
    that of `base`, a step before this one, which ratios refer to."""

    key: Key
    base: Key
    run: Callable[[int], Figures]
    digest: Callable[[], str]


Samples = dict[Key, list[Figures]]


def measure(steps: list[Step], rounds: int) -> Samples:
    """Verifies every step, then runs all of them in each round, in random order."""
    seconds = _verify(steps)
    samples: Samples = {step.key: [] for step in steps}
    progress = Progress("measuring", rounds * sum(seconds.values()))
    for number in range(rounds):
        for step in random.Random(number).sample(steps, len(steps)):
            samples[step.key].append(step.run(number))
            progress.advance(seconds[step.key])
    progress.close()
    return samples


def _verify(steps: list[Step]) -> dict[Key, float]:
    """How long each step took."""
    progress = Progress("verifying", len(steps))
    seconds, digests = {}, {}
    for step in steps:
        start = time.monotonic()
        step.run(0)
        seconds[step.key] = time.monotonic() - start
        digests[step.key] = step.digest()
        if digests[step.key] != digests[step.base]:
            raise ReportError(f"{step.key.method}: other pixels than {step.base.method}", 2)
        progress.advance(1)
    progress.close()
    return seconds


def digest_of_images(directory: Path) -> str:
    """Of the names and pixels of all PNG files."""
    found = hashlib.sha256()
    for path in sorted(directory.glob("*.png")):
        found.update(path.name.encode())
        found.update(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE).tobytes())
    return found.hexdigest()
