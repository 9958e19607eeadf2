"""What a finished benchmark run consists of, and the statistics of one row."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from report.cases import Case
from report.controls import Controls
from report.run_options import RunOptions

REFERENCE = "reference"
BASELINE = "baseline"
KERNEL = "kernel"
END_TO_END = "end_to_end"
SCENE = "scene"
SCOPES = (END_TO_END, KERNEL)

NOISY_PERCENT = 5.0
"""A row whose quartiles lie further apart than this part of its median is flagged."""

_SWEEP_INPUT = re.compile(r"square_(\d+)")


def is_sweep_input(name: str) -> bool:
    """Tells the squares of the size sweep from the scene and from users' pictures."""
    return _SWEEP_INPUT.fullmatch(name) is not None


def input_order(name: str) -> tuple[int, int, str]:
    """Sort key of inputs: the scene, users' pictures by name, then squares by size."""
    square = _SWEEP_INPUT.fullmatch(name)
    if square:
        return (2, int(square.group(1)), name)
    return (0 if name == SCENE else 1, 0, name)


@dataclass(frozen=True)
class RowName:
    """The six fields that identify a row."""

    case: Case
    technique: str
    isa: str
    threads: int
    scope: str
    input: str

    def __str__(self) -> str:
        parts = (self.case.name, self.technique, self.isa, self.threads, self.scope, self.input)
        return "/".join(map(str, parts))

    @property
    def is_reference(self) -> bool:
        """True for the row that every speed-up of its case and input divides."""
        return (self.technique, self.isa, self.threads, self.scope) == (
            REFERENCE, BASELINE, 1, END_TO_END)

    @property
    def variant(self) -> tuple[str, str, int]:
        """Technique, instruction set and threads: what a kernel and an end-to-end row share."""
        return (self.technique, self.isa, self.threads)

    @property
    def variant_label(self) -> str:
        """The variant in words; the instruction set is left out where none was chosen."""
        how = [self.isa] if self.isa != BASELINE else []
        how += [f"{self.threads} threads"] if self.threads > 1 else []
        words = self.technique.replace("_", " ")
        return f"{words} ({', '.join(how)})" if how else words


@dataclass(frozen=True)
class PairedRatio:
    """A speed-up that was measured in pairs by several processes, with its interval."""

    ratio: float
    low: float
    high: float
    processes: int
    flags: tuple[str, ...] = ()

    @property
    def is_inconclusive(self) -> bool:
        """True if a control beside it failed: the ratio says nothing."""
        return "inconclusive" in self.flags


@dataclass(frozen=True)
class Row:
    """All repetitions of one variant on one input, with the time they are compared to."""

    name: RowName
    width: int
    height: int
    iterations: int | None
    samples_ns: tuple[float, ...]
    reference_ns: float
    is_peer: bool = False
    """True for other projects' code and lower bounds such as a copy: compared with, never quoted."""
    paired: PairedRatio | None = None
    """The speed-up as measured in pairs; rows of the size sweep have none."""
    plan_bytes: int | None = None
    """Memory that the variant holds; nothing is known of references and peers."""

    @property
    def pixels(self) -> int:
        """Pixels of the input, whatever its representation in memory."""
        return self.width * self.height

    @cached_property
    def median_ns(self) -> float:
        """Median over the repetitions: the time this report quotes."""
        return float(np.median(self.samples_ns))

    @property
    def min_ns(self) -> float:
        """The fastest repetition."""
        return min(self.samples_ns)

    @property
    def ns_per_pixel(self) -> float:
        """Median time divided by the pixels of the input."""
        return self.median_ns / self.pixels

    @property
    def speedup(self) -> float:
        """How many times as fast as the reference on the same case and input.

        As measured in pairs where it was; else the ratio of two medians.
        """
        if self.paired:
            return self.paired.ratio
        return self.reference_ns / self.median_ns

    @cached_property
    def spread_percent(self) -> float | None:
        """Interquartile range in percent of the median; None if there is one repetition.

        Quartiles, interpolated linearly, are used because a single interrupted
        repetition moves (max - min) / median by any amount and says nothing
        about the others.
        """
        if len(self.samples_ns) < 2:
            return None
        low, high = np.percentile(self.samples_ns, (25, 75))
        return float(100 * (high - low) / self.median_ns)

    @property
    def is_noisy(self) -> bool:
        """True if the repetitions disagree by more than NOISY_PERCENT."""
        return self.spread_percent is not None and self.spread_percent > NOISY_PERCENT


@dataclass(frozen=True)
class Input:
    """A picture that was timed."""

    name: str
    width: int
    height: int
    hash: str
    object_pixels: int


@dataclass(frozen=True)
class Skipped:
    """A row that was not run, and why."""

    row: str
    reason: str


@dataclass(frozen=True)
class Peer:
    """What a reader must know of a technique that is not this project's."""

    technique: str
    about: str
    equal_output: bool = False
    """True where it gives the very pixels of the case that it stands beside."""


@dataclass(frozen=True)
class Cache:
    """One level of data or unified cache."""

    level: int
    size_kib: int


@dataclass(frozen=True)
class Machine:
    """Where and with what the run was made."""

    fingerprint: str
    commit: str
    compiler: dict[str, str]
    libraries: dict[str, str]
    cpu_name: str
    cpu_flags: tuple[str, ...]
    caches: tuple[Cache, ...]
    isa_available: tuple[str, ...]
    facts: dict[str, str]
    """Further things worth printing, by their label."""
    run: RunOptions

    def isa_order(self, isa: str) -> tuple[int, str]:
        """Sort key of instruction sets: as the machine lists them, unknown ones last."""
        known = self.isa_available
        return (known.index(isa) if isa in known else len(known), isa)


@dataclass(frozen=True)
class Study:
    """One run, loaded, checked and sorted."""

    directory: Path
    machine: Machine
    rows: tuple[Row, ...]
    inputs: tuple[Input, ...]
    skipped: tuple[Skipped, ...]
    verified: int
    warnings: tuple[str, ...]
    peers: tuple[Peer, ...] = ()
    controls: Controls | None = None
    """None where no speed-up was measured in pairs."""

    @property
    def cases(self) -> list[str]:
        """Every case that was timed, by name: thinning first, nets that learn it last."""
        names = {row.name.case.name for row in self.rows}
        return sorted(names, key=lambda name: (name.startswith("net_"),
                                               not name.startswith("thin_"), name))

    @property
    def equal_peers(self) -> set[str]:
        """Peers whose times may be divided by a row's: they give the same pixels."""
        return {peer.technique for peer in self.peers if peer.equal_output}

    @property
    def has_pairs(self) -> bool:
        """True if any speed-up was measured in pairs."""
        return any(row.paired for row in self.rows)

    @property
    def pictures(self) -> list[str]:
        """Names of the timed inputs outside the size sweep, the scene first."""
        names = {row.name.input for row in self.rows}
        return sorted((n for n in names if not is_sweep_input(n)), key=input_order)

    def select(self, case: str, input_name: str) -> list[Row]:
        """The rows of one case on one input, in the order of the tables."""
        wanted = (case, input_name)
        return [r for r in self.rows if (r.name.case.name, r.name.input) == wanted]

    def sweep(self, case: str) -> list[Row]:
        """The rows of one case on the squares, from small to large."""
        return [r for r in self.rows
                if r.name.case.name == case and is_sweep_input(r.name.input)]


def table_order(row: Row) -> tuple:
    """Sort key of every table: case, input, scope, then fastest first."""
    name = row.name
    return (name.case.name, input_order(name.input), SCOPES.index(name.scope), row.median_ns,
            name.variant)
