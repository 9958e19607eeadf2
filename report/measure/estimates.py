"""Statistics of samples: one place for every time and ratio that is published.

Beside each repetition of a row a probe runs before and after it: a few microseconds of independent additions, as many
as a core can do. A busy neighbour on the same core makes the probe slower, and so does a slower clock. A repetition
counts where it was quiet: neither of its probes took much longer than the fastest of the run, and both took about the same.
It counts as a multiple of its own two probes, which takes out the clock. Which repetitions count does not depend on
what they measured, so more of them bring no bias. Of a call longer than LONG the probes see the ends only: it counts where
one of them was quiet, as a multiple of that one.

    time of a row     = 10 % quantile of (repetition / mean of its probes), times the probe of the run
    speed-up of a row = time of the reference / time of the row

Intervals are by bootstrap over processes, the same processes for all rows, and wider where these are few.
docs/experiments.md has the figures.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pandas as pd
from scipy import stats

FASTEST = 0.005
"""The quantile that stands for the fastest probe of a run."""

GATE, AGREE = 1.06, 0.03
"""How long a quiet probe takes at most, over the fastest, and how far the two of a repetition may differ."""

LONG = 1e6
"""Nanoseconds."""

QUANTILE = 0.1

NEEDED, NEEDED_PROCESSES = 6, 3
"""Quiet repetitions of a row, and processes that have one, from which on its time is settled."""

RESAMPLES, LEVEL = 200, 0.95

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Estimate:
    """A value and its interval within a run; another run may find a value outside."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Time:
    """Of a row, in ns."""

    value: float
    low: float
    high: float
    typical: float
    """Median of all repetitions, quiet or not: what this machine gave during the run."""
    quiet: int
    """Repetitions that count."""
    processes: int
    settled: bool
    counted: int
    """Processes that have a repetition that counts."""
    draws: Array
    """Values by bootstrap; those of two rows of a run belong together."""


class Estimates:
    """Of the rows in `own`, or in all `samples` of a run, which share one clock. Columns: process, row, ns, before,
    after and cycle."""

    def __init__(self, samples: pd.DataFrame, own: pd.DataFrame | None = None) -> None:
        probes = samples[["before", "after"]].to_numpy()
        self.probe_ns = float(np.quantile(probes, FASTEST))
        quiet = self._is_quiet(samples)
        self.quiet = float(quiet.mean())
        at_that_clock = probes.min(axis=1) <= 1.01 * self.probe_ns
        self.cycle_ns = float(samples["cycle"][at_that_clock].median())
        table = samples if own is None else own
        probe = table[["before", "after"]]
        usual = table["ns"].groupby(table["row"]).transform("median") <= LONG
        relative = (table["ns"] / probe.mean(axis=1)).where(
            usual, table["ns"] / probe.min(axis=1).clip(self.probe_ns, GATE * self.probe_ns))
        quiet_end = probe.min(axis=1) < GATE * self.probe_ns
        table = table.assign(quiet=np.where(usual, self._is_quiet(table), quiet_end), relative=relative)
        self._rows = dict(iter(table.groupby("row", sort=False)))
        self._counts = _resampled(int(samples["process"].max()) + 1)
        self._found: dict[str, Time] = {}

    def _is_quiet(self, samples: pd.DataFrame) -> npt.NDArray[np.bool_]:
        before, after = samples["before"].to_numpy(), samples["after"].to_numpy()
        found: npt.NDArray[np.bool_] = ((np.maximum(before, after) < GATE * self.probe_ns) &
                                        (np.abs(before / after - 1) < AGREE))
        return found

    def __contains__(self, name: str) -> bool:
        return name in self._rows

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def time(self, name: str) -> Time:
        """Of a row or control."""
        if name not in self._found:
            self._found[name] = self._time(self._rows[name])
        return self._found[name]

    def _time(self, table: pd.DataFrame) -> Time:
        """Where too few repetitions were quiet, as many of the calmest count, at the clock of the run, and nothing is
        settled."""
        quiet = table[table["quiet"]]
        settled = len(quiet) >= NEEDED and quiet["process"].nunique() >= NEEDED_PROCESSES
        used = quiet if settled else table.loc[table[["before", "after"]].max(axis=1).nsmallest(NEEDED).index]
        relative = (used["relative"] if settled else used["ns"] / self.probe_ns).to_numpy()
        process = used["process"].to_numpy()
        draws = self.probe_ns * _quantiles(relative, self._counts[:, process])
        value = self.probe_ns * float(_quantiles(relative, np.ones((1, len(relative))))[0])
        counted = used["process"].nunique()
        return Time(value, *_interval(value, draws, counted), float(table["ns"].median()), len(quiet),
                    table["process"].nunique(), settled, counted, draws)


def ratio_of(above: Time, below: Time) -> Estimate:
    """Of two times of one run."""
    value = above.value / below.value
    return Estimate(value, *_interval(value, above.draws / below.draws, min(above.counted, below.counted)))


def _interval(value: float, draws: Array, processes: int) -> tuple[float, float]:
    """The spread of a bootstrap of n is too small by sqrt((n - 1) / n), and of few processes it is known only as well as
    Student's t says."""
    tail, count = (1 - LEVEL) / 2, max(2, processes)
    wider = stats.t.ppf(1 - tail, count - 1) / stats.norm.ppf(1 - tail) * (count / (count - 1)) ** 0.5
    low, high = np.quantile(draws / value, (tail, 1 - tail)) ** wider
    return value * min(1.0, float(low)), value * max(1.0, float(high))


def _resampled(processes: int) -> Array:
    """How often each process is drawn, for each of the resamples; the same for all rows."""
    drawn = np.random.default_rng(1).integers(processes, size=(RESAMPLES, processes))
    counts: Array = (drawn[:, :, None] == np.arange(processes)).sum(axis=1).astype(float)
    return counts


def _quantiles(values: Array, weights: Array) -> Array:
    """QUANTILE of the values for each line of weights; a line without any has that of all values."""
    order = np.argsort(values)
    share = np.cumsum(weights[:, order], axis=1)
    share[share[:, -1] == 0] = np.arange(1, len(values) + 1)
    found: Array = values[order][(share < QUANTILE * share[:, -1:]).sum(axis=1)]
    return found
