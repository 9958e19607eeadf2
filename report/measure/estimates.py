"""Statistics of samples: one place for every time and ratio that is published.

A process gives the shortest epoch of each entry, over several layouts of its memory: its floor. The
estimate is the lowest floor of all processes, once it has converged: once NEEDED processes came
within TOLERANCE of it, each with addresses of its own. Whatever disturbs a computer makes calls
longer, never shorter, so floors come back where medians do not: docs/measuring.md has the figures.

    time of a row      = its floor
    speed-up of a row  = floor of the reference / floor of the row

so that every quotient of two published times is the published speed-up.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.stats import binom

COVERAGE = 0.95
TOLERANCE, NEEDED = 0.02, 3

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Estimate:
    """A value and the interval that holds it."""

    value: float
    low: float
    high: float

    @property
    def width(self) -> float:
        """Relative width of the interval."""
        return (self.high - self.low) / self.value


@dataclass(frozen=True)
class Floor:
    """Times of one entry, in the unit of its epochs."""

    time: float
    high: float
    """The floor of the NEEDED-th process from below, or of the last one: how well it comes back."""
    typical: float
    """Median over processes of their medians: what this machine gave during the run."""
    processes: int

    @property
    def converged(self) -> bool:
        """Whether enough processes found the same."""
        return self.processes >= NEEDED and self.high <= self.time * (1 + TOLERANCE)


def floor_of(processes: Sequence[Sequence[Sequence[float]]]) -> Floor:
    """`processes[process][layout][epoch]`; every process has at least one epoch."""
    epochs = [[time for layout in layouts for time in layout] for layouts in processes]
    floors = sorted(min(times) for times in epochs)
    return Floor(floors[0], floors[min(NEEDED, len(floors)) - 1],
                 float(np.median([np.median(times) for times in epochs])), len(floors))


def ratio_of(above: Floor, below: Floor) -> Estimate:
    """Of two times."""
    return Estimate(above.time / below.time, above.time / below.high, above.high / below.time)


@cache
def interval_ranks(count: int) -> tuple[int, int]:
    """Indices of the narrowest symmetric pair of `count` ordered values that covers their
    distribution's median with at least 95 %; the outermost pair below six values."""
    for low in range(count // 2 - 1, -1, -1):
        if 1 - 2 * float(binom.cdf(low, count, 0.5)) >= COVERAGE:
            return low, count - 1 - low
    return 0, count - 1


def estimate_of_logs(logs: ArrayLike) -> Estimate:
    """exp() of the median of paired differences, with its interval; for comparisons of builds."""
    ordered = np.sort(np.asarray(logs, float))
    low, high = (float(np.exp(ordered[rank])) for rank in interval_ranks(len(ordered)))
    return Estimate(float(np.exp(np.median(ordered))), low, high)
