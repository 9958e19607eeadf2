"""Sweeps as curves for the page and as Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from report.formatting import markdown_table
from report.measure.run import TIMINGS, Run
from report.measure.timings import Row, read_csv
from report.page.sentences import choice_text, warning_text
from report.sweeps.plans import BY_NAME, SWEEPS, Place, curve_of

DIRECTORY = "sweeps"
"""Below the directory of a run."""

NO_REFERENCE = ("density", "isa")
"""Its times are too few, or not of an ISA."""


@dataclass(frozen=True)
class Point:
    """Nanoseconds per pixel at one place of the axis; the place of the sweep of ISAs is a name."""

    x: Place
    ns_per_pixel: float
    high: float
    flags: str


@dataclass(frozen=True)
class Series:
    """One curve of the plot of a case."""

    sweep: str
    case: str
    label: str
    points: tuple[Point, ...]


def load_sweep_rows(directory: Path) -> list[Row]:
    """Of the sweeps that belong to a run; empty where there are none."""
    path = directory / DIRECTORY / TIMINGS
    return read_csv(path) if path.exists() else []


def sweep_series(rows: Iterable[Row]) -> list[Series]:
    """In the order of SWEEPS, points in the order of the axis."""
    found: dict[tuple[str, str, str], list[Point]] = {}
    for row in rows:
        if row.sweep in BY_NAME and not (row.is_reference and row.sweep in NO_REFERENCE):
            found.setdefault((row.sweep, row.case, curve_of(row)), []).append(_point(row))
    series = [Series(*key, tuple(_ordered(points))) for key, points in found.items()]
    order = [sweep.name for sweep in SWEEPS]
    return sorted(series, key=lambda one: order.index(one.sweep))


def worst_places(rows: Iterable[Row], scene: Iterable[Row]) -> str:
    """The noise on which the library's choice takes longest per pixel, beside the scene where `scene` has its time."""
    timed = {row.case: row.ns_per_pixel for row in scene if row.is_choice and row.input == "scene"}
    by_case: dict[str, list[Row]] = {}
    for row in rows:
        if row.sweep == "density" and row.is_choice:
            by_case.setdefault(row.case, []).append(row)
    lines = []
    for case, own in by_case.items():
        worst = max(own, key=lambda row: row.ns_per_pixel)
        times = f"{worst.ns_per_pixel / timed[case]:.3g}" if case in timed else ""
        lines.append([f"`{case}`", worst.input, f"{worst.ns_per_pixel:.3g}", times])
    return markdown_table(("operation", "worst noise", "ns/pixel", "times the scene"), lines, frozenset((2, 3)))


def sweeps_markdown(run: Run, scene: Iterable[Row] = ()) -> str:
    """A section for each sweep, a table for each case: places down, curves across. `scene`: the rows of the study."""
    series = sweep_series(run.rows)
    parts = ["# Parameter sweeps\n\nNanoseconds per pixel, end to end, on one thread unless a sweep says otherwise; "
             f"`!` marks flagged rows. timings.csv has the intervals. {choice_text(run.rows)}\n\n"
             f"{warning_text(run)}"[:-1]]
    for name in dict.fromkeys(one.sweep for one in series):
        own = [one for one in series if one.sweep == name]
        parts.append(f"## {name}\n")
        if name == "density":
            parts.append(worst_places(run.rows, scene))
        for case in dict.fromkeys(one.case for one in own):
            parts.append(_table(BY_NAME[name].what, [one for one in own if one.case == case]))
    return "\n".join(parts)


def _point(row: Row) -> Point:
    pixels = row.width * row.height
    return Point(BY_NAME[row.sweep].place(row), row.ns_per_pixel, row.high_ns / pixels,
                 row.flags)


def _ordered(points: list[Point]) -> list[Point]:
    """Names stay in the order of the rows."""
    return sorted(points, key=lambda point: 0 if isinstance(point.x, str) else point.x)


def _table(what: str, curves: list[Series]) -> str:
    lines = lines_of([{point.x: f"{point.ns_per_pixel:.3g}{' !' if point.flags else ''}" for point in one.points}
                      for one in curves])
    table = markdown_table(["", *(one.label for one in curves)], lines, frozenset(range(1, len(curves) + 1)))
    return f"**{curves[0].case}** by {what}\n\n{table}"


def places_of(curves: Iterable[Iterable[Place]]) -> list[Place]:
    """All places on the axis; names stay in their order."""
    found = list(dict.fromkeys(place for curve in curves for place in curve))
    return found if any(isinstance(place, str) for place in found) else sorted(found)


def lines_of(curves: Sequence[Mapping[Place, str]], missing: str = "") -> list[list[str]]:
    """A line for each place, a cell for each curve."""
    return [[place if isinstance(place, str) else f"{place:g}", *(curve.get(place, missing) for curve in curves)]
            for place in places_of(curves)]
