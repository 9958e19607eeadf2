"""Reads what the paired speed-ups of a run were checked with."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from report.errors import ReportError
from report.json_fields import Fields, read_line

SAMPLES = "samples.jsonl"


@dataclass(frozen=True)
class Interval:
    """A ratio with its interval."""

    ratio: float
    low: float
    high: float


@dataclass(frozen=True)
class Controls:
    """What paired speed-ups were checked with: a row against itself, and one slowed by 10 %."""

    same: Interval
    slowed: Interval
    processes: int
    failed_groups: int
    verdict: str


def load_controls(directory: Path) -> Controls:
    """What the controls gave: the first line of the samples behind the speed-ups."""
    run = read_line(directory / SAMPLES)
    run.check_schema()
    if run.text("kind") != "run":
        raise ReportError(f"{run.where}: kind is '{run.text('kind')}'; the first line must be "
                          "of kind 'run', with the controls")
    return Controls(_interval(run.child("control_same")), _interval(run.child("control_slowed")),
                    run.count("processes", 1), run.count("groups_with_failed_control"),
                    run.text("verdict"))


def _interval(fields: Fields) -> Interval:
    return Interval(*(fields.positive(key) for key in ("ratio", "low", "high")))
