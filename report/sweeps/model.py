"""What a journal of sweeps holds: points, each with its samples."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from report.cases import Case
from report.intervals import median_bounds
from report.model import Machine

SWEEPS = ("density", "size", "threads", "depth", "enlarged", "isa")
REFERENCE = "reference"


@dataclass(frozen=True)
class Place:
    """What tells points apart: a row at a place of a sweep."""

    sweep: str
    x: float
    y: float | None
    case: Case
    technique: str
    isa: str
    threads: int


@dataclass(frozen=True)
class Point:
    """A place with what was measured there, end to end."""

    place: Place
    pixels: int
    proved_against: str
    clock: str
    samples: tuple[float, ...]
    """Nanoseconds a pixel, one of every round."""

    @cached_property
    def median(self) -> float:
        """Nanoseconds a pixel."""
        return float(np.median(self.samples))

    @cached_property
    def bounds(self) -> tuple[float, float]:
        """Between which the median lies: the 2nd and the 8th of nine ordered samples."""
        return median_bounds(self.samples)

    @property
    def words(self) -> str:
        """For whoever points at it in a figure."""
        low, high = self.bounds
        row = f"{self.place.case.name}, {self.place.technique}, {self.place.isa}"
        return f"{row}: {self.median:.4g} ns per pixel ({low:.4g} to {high:.4g})"


@dataclass(frozen=True)
class Journal:
    """One journal, whole or as far as it came."""

    name: str
    machine: Machine
    is_quick: bool
    rounds: int
    planned: int
    points: tuple[Point, ...]

    @property
    def is_partial(self) -> bool:
        """True if a point or a round is missing."""
        return (len(self.points) < self.planned
                or any(len(point.samples) < self.rounds for point in self.points))

    @property
    def compiler(self) -> str:
        """Such as GNU 12.2.0."""
        return f"{self.machine.compiler['id']} {self.machine.compiler['version']}"

    def of(self, sweep: str) -> list[Point]:
        """The points of one sweep, in the order of their places."""
        return sorted((point for point in self.points if point.place.sweep == sweep),
                      key=lambda point: (point.place.x, point.place.y or 0))


def cases_of(points: list[Point]) -> list[str]:
    """Cases with points, by name, thinning first."""
    names = {point.place.case.name for point in points}
    return sorted(names, key=lambda name: (not name.startswith("thin_"), name))
