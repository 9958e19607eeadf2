"""Statistics of samples: one place for every estimate and interval that is published.

The unit of sampling is the process. For a row, a process gives the median over its epochs of
ln(time / time of the anchor beside it). All figures of a group come from these numbers:

    time of a row      = time of the anchor * exp(median over processes)
    speed-up of a row  = time of the reference / time of the row

so that every quotient of two published times is the published speed-up. Intervals are pairs of
order statistics, the 2nd and the 8th of nine processes, and assume nothing about distributions.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.stats import binom

COVERAGE = 0.95

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


@cache
def interval_ranks(count: int) -> tuple[int, int]:
    """Indices of the narrowest symmetric pair of `count` ordered values that covers their
    distribution's median with at least 95 %; the outermost pair below six values."""
    for low in range(count // 2 - 1, -1, -1):
        if 1 - 2 * float(binom.cdf(low, count, 0.5)) >= COVERAGE:
            return low, count - 1 - low
    return 0, count - 1


def estimate_of_logs(logs: ArrayLike, value: float | None = None) -> Estimate:
    """exp() of the median of `logs`, or `value`, with an interval that is widened to hold it."""
    ordered = np.sort(np.asarray(logs, float))
    low, high = (float(np.exp(ordered[rank])) for rank in interval_ranks(len(ordered)))
    middle = float(np.exp(np.median(ordered))) if value is None else value
    return Estimate(middle, min(low, middle), max(high, middle))


class GroupEstimates:
    """Times and speed-ups of one group, `logs[process, entry]` and `anchor_ns[process]`."""

    def __init__(self, logs: Floats, anchor_ns: Floats) -> None:
        self.logs = logs
        self.log_times = logs + np.log(anchor_ns)[:, None]
        self.times = np.median(anchor_ns) * np.exp(np.median(logs, axis=0))

    def time(self, entry: int) -> Estimate:
        """Nanoseconds of a call."""
        return estimate_of_logs(self.log_times[:, entry], float(self.times[entry]))

    def speedup(self, entry: int, base: int) -> Estimate:
        """How many times as fast as entry `base`."""
        ratio = float(self.times[base] / self.times[entry])
        return estimate_of_logs(self.logs[:, base] - self.logs[:, entry], ratio)
