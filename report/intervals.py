"""Ratios of two rows of one run, with an interval that supposes nothing of the noise."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb

from report.formatting import three_digits
from report.model import Row

COVERAGE = 0.95
"""Of each median, where there are repetitions enough; from six on there are."""


@dataclass(frozen=True)
class Interval:
    """A ratio of medians, and between which bounds it lies."""

    ratio: float
    low: float
    high: float

    @property
    def text(self) -> str:
        """Such as 1.25 (1.21 to 1.30)."""
        ends = f"{three_digits(self.low)} to {three_digits(self.high)}"
        return f"{three_digits(self.ratio)} ({ends})"


def time_ratio(above: Row, below: Row) -> Interval:
    """How many times as long the first row takes: bounds of one median over bounds of the other."""
    above_low, above_high = median_bounds(above.samples_ns)
    below_low, below_high = median_bounds(below.samples_ns)
    return Interval(above.median_ns / below.median_ns, above_low / below_high,
                    above_high / below_low)


def median_bounds(samples: tuple[float, ...]) -> tuple[float, float]:
    """Ordered values that hold the median between them with COVERAGE; else the outermost."""
    ordered = sorted(samples)
    skipped = 0
    while skipped + 1 < len(ordered) / 2 and _coverage(len(ordered), skipped + 1) >= COVERAGE:
        skipped += 1
    return ordered[skipped], ordered[-1 - skipped]


def _coverage(count: int, skipped: int) -> float:
    """The chance that the median lies within, with so many values left out at either end."""
    return 1 - 2 * sum(comb(count, k) for k in range(skipped + 1)) / 2**count
