"""Statistics of samples: one place for every estimate and interval that is published.

The unit of sampling is the process. For a row, a process gives the median over its quiet epochs of
ln(time / time of the anchor beside it). An epoch is quiet where the anchor beside it is at most 10 %
slower than it can be: the rest was measured beside a busy neighbour, which slows scalar and vector
code by different factors. All figures of a group come from these numbers:

    time of a row      = time of the anchor * exp(median over processes)
    speed-up of a row  = time of the reference / time of the row

so that every quotient of two published times is the published speed-up. Intervals are pairs of
order statistics, the 2nd and the 8th of nine processes, and assume nothing about distributions.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.stats import binom

COVERAGE = 0.95
QUIET_WITHIN, QUIET_QUANTILE, QUIET_PROCESSES = 0.10, 0.02, 0.1
"""How much slower (logarithm) a quiet anchor may be than it can be: than the 10 % quantile over
processes of its 2 % quantile. Not the lowest, since a process may have a lucky layout. On a virtual
machine whose neighbours came and went every few seconds, quiet epochs alone took the spread of
speed-ups between three runs from 15 % (median over rows) to 1.5 %."""

MIN_QUIET = 3
"""Processes with quiet epochs that an estimate needs."""

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
    """Times and speed-ups of one group from `logs[process, entry]`, NaN where a process has no
    quiet epoch, and `anchor_logs[process]`, ln(nanoseconds) of the anchor."""

    def __init__(self, logs: Floats, anchor_logs: Floats) -> None:
        self.logs = logs
        self.log_times = logs + anchor_logs[:, None]
        self.times = np.exp(np.nanmedian(anchor_logs) + np.nanmedian(logs, axis=0))

    def time(self, entry: int) -> Estimate:
        """Nanoseconds of a call."""
        return estimate_of_logs(_known(self.log_times[:, entry]), float(self.times[entry]))

    def speedup(self, entry: int, base: int) -> Estimate:
        """How many times as fast as entry `base`."""
        ratio = float(self.times[base] / self.times[entry])
        paired = _known(self.logs[:, base] - self.logs[:, entry])
        if len(paired) >= MIN_QUIET or base == entry:
            return estimate_of_logs(paired, ratio)
        ends = [estimate_of_logs(_known(self.logs[:, one])) for one in (base, entry)]
        return Estimate(ratio, min(ratio, ends[0].low / ends[1].high),
                        max(ratio, ends[0].high / ends[1].low))


@dataclass(frozen=True)
class QuietLogs:
    """What the processes of a run say of one group, after noise was taken away."""

    logs: Floats
    anchor_logs: Floats
    disturbed: frozenset[int]
    """Entries with too few quiet processes; all their epochs count."""


def quiet_logs(groups: Sequence[Mapping[str, Any]], anchor: int) -> QuietLogs:
    """`groups[process]` is what a process found, or empty."""
    anchors = [_together([entry["anchor"] for entry in group.get("entries", ())])
               for group in groups]
    fastest = [np.quantile(values, QUIET_QUANTILE) for values in anchors if len(values)]
    limit = float(np.quantile(fastest, QUIET_PROCESSES)) + QUIET_WITHIN
    count = max(len(group.get("entries", ())) for group in groups)
    logs, every = (np.full((len(groups), count), np.nan) for _ in range(2))
    for number, group in enumerate(groups):
        for index, entry in enumerate(group.get("entries", ())):
            found = np.array(entry["logs"] or [0]) / 1e4
            quiet = found[np.array(entry["anchor"] or [0]) / 1e4 <= limit]
            every[number, index] = np.median(found)
            logs[number, index] = np.median(quiet) if len(quiet) else np.nan
    few = np.sum(~np.isnan(logs), axis=0) < min(MIN_QUIET, len(groups))
    logs[:, few] = every[:, few]
    logs[:, anchor] = np.where(np.isnan(every[:, anchor]), np.nan, 0)
    quiet_anchors = [values[values <= limit] for values in anchors]
    centre = float(np.median(np.concatenate(quiet_anchors)))
    return QuietLogs(
        logs, np.array([np.median(values) if len(values) else centre for values in quiet_anchors]),
        frozenset(np.flatnonzero(few).tolist()) - {anchor})


def _together(anchors: Sequence[Sequence[int]]) -> Floats:
    return np.array([value for values in anchors for value in values], float) / 1e4


def _known(values: Floats) -> Floats:
    return values[~np.isnan(values)]
