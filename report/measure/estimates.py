"""Statistics of samples: one place for every time and ratio that is published.

A process gives the shortest epoch of each entry, over several layouts of its memory: its floor. The
estimate is the lowest floor on which NEEDED processes agree within TOLERANCE, each with addresses
of its own. Whatever disturbs a computer makes calls longer, never shorter, so floors come back where
medians do not; a lower floor that a few processes found was a lucky layout. docs/measuring.md has
the figures.

    time of a row      = its floor
    speed-up of a row  = floor of the reference / floor of the row

so that every quotient of two published times is the published speed-up.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

TOLERANCE, NEEDED = 0.02, 3

MAX_LUCKY = 1 / 12
"""Share of processes whose lower floors may be left out. More would be a burst that disturbed the
others."""


@dataclass(frozen=True)
class Estimate:
    """A value and its interval within a run; another run may find a value outside."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Floor:
    """Times of one entry, in the unit of its epochs."""

    time: float
    high: float
    """The highest of the NEEDED floors from `time` on, or of fewer: how well it comes back."""
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
    lucky = int(MAX_LUCKY * len(floors))
    agreed = next((run for run in (floors[i:i + NEEDED] for i in range(lucky + 1))
                   if run[-1] <= run[0] * (1 + TOLERANCE)), floors[:NEEDED])
    return Floor(agreed[0], agreed[-1],
                 float(np.median([np.median(times) for times in epochs])), len(floors))


def ratio_of(above: Floor, below: Floor) -> Estimate:
    """Of two times."""
    return Estimate(above.time / below.time, above.time / below.high, above.high / below.time)
