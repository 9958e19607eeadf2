"""Rows that are measured again, and again with a delay: what a group's differences are worth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from report.measure.benchmarks import AGAIN, SLOWED
from report.measure.estimates import Estimates, ratio_of

SAME_WITHIN, FOUND = 0.03, 0.5
"""How near to 1 a row's ratio to itself must be, and what part of the injected slowdown must be found."""

DELAY = 0.1
"""Of the slowed control, in times of its row."""


@dataclass(frozen=True)
class Control:
    """Speeds of the repeated row and of the slowed one over the row itself; None where they were not measured."""

    same: float | None
    slowed: float | None

    @property
    def flag(self) -> str:
        """"control" where one of them failed."""
        if self.same is None or self.slowed is None:
            return ""
        good = abs(self.same - 1) <= SAME_WITHIN and 1 / self.slowed - 1 >= FOUND * DELAY
        return "" if good else "control"


def control_of(group: Sequence[str], times: Estimates) -> Control:
    """Of the rows of a group."""
    base = next((name for name in group if all(name + what in times for what in ("", AGAIN, SLOWED))), None)
    if base is None:
        return Control(None, None)
    own = times.time(base)
    return Control(ratio_of(own, times.time(base + AGAIN)).value, ratio_of(own, times.time(base + SLOWED)).value)
