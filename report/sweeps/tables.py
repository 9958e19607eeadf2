"""Sweeps as CSV, and the tables of levels and compilers."""

from __future__ import annotations

from report.errors import ReportError
from report.experiment_layout import Table, columns
from report.formatting import NOTHING
from report.intervals import Interval
from report.sweeps.model import Journal, Place, Point, cases_of
from report.tables import csv_text

CSV_HEADER = ("sweep", "x", "y", "operation", "technique", "isa", "threads", "pixels",
              "ns_per_pixel", "low", "high", "rounds", "clock", "proved_against", "compiler",
              "border", "max_iterations")


def to_csv(journals: list[Journal]) -> str:
    """A line a point: the median, and between which bounds it lies; y is empty where there is
    none. Columns are only ever added at the right."""
    return csv_text(CSV_HEADER, (
        (*_fields(point), journal.compiler, *point.place.case.columns) for journal in journals
        for point in sorted(journal.points, key=_order)))


def points_csv(points: list[Point]) -> str:
    """What a figure draws, as numbers."""
    header = [column for column in CSV_HEADER if column != "compiler"]
    return csv_text(header, ((*_fields(point), *point.place.case.columns)
                             for point in sorted(points, key=_order)))


def levels_table(points: list[Point], levels: tuple[str, ...]) -> Table | None:
    """The fastest technique of every level; None where no level was measured."""
    levels = tuple(level for level in levels
                   if any(point.place.isa == level for point in points))
    if not levels:
        return None
    return Table(
        "Instruction sets",
        "Nanoseconds per pixel of the fastest technique of each ISA, on the scene, end to end.",
        columns(["Case"], list(levels)),
        tuple((name, *(_fastest_text(points, name, level) for level in levels))
              for name in cases_of(points)),
        "./study sweeps --only isa")


def compiler_table(journals: list[Journal]) -> Table | None:
    """Two builds that were measured by turns, row beside row; None for fewer."""
    if len(journals) < 2:
        return None
    _check_same_machine(journals)
    one, other = sorted(journals, key=lambda journal: not journal.compiler.startswith("GNU"))[:2]
    theirs = {point.place: point for point in other.of("isa")}
    pairs = [(point, theirs[point.place]) for point in _highest_levels(one.of("isa"))
             if point.place in theirs]
    names = (one.compiler, other.compiler)
    return Table(
        "Compilers", f"The same code built by {names[0]} and by {names[1]}, processes by turns: "
        "every technique at its highest level, on the scene. Above 1 the second build takes "
        f"longer. Flags: {one.machine.compiler['flags']}.",
        columns(["Case", "Technique", "ISA"], [f"{names[0]}, µs", f"{names[1]}, µs",
                                                    "Second / first"]),
        tuple(_pair(first, second) for first, second in pairs),
        "./study sweeps --compiler clang")


def _order(point: Point) -> tuple:
    place = point.place
    return (place.sweep, place.case.name, place.x, place.y or 0, place.technique, place.isa)


def _fields(point: Point) -> list[object]:
    place, (low, high) = point.place, point.bounds
    return [place.sweep, f"{place.x:g}", "" if place.y is None else f"{place.y:g}",
            place.case.operation, place.technique, place.isa, place.threads,
            point.pixels, f"{point.median:.6g}", f"{low:.6g}", f"{high:.6g}", len(point.samples),
            point.clock, point.proved_against]


def fastest_of(points: list[Point], case: str, level: str) -> Point | None:
    """The fastest technique of an case on a level."""
    found = [point for point in points
             if (point.place.case.name, point.place.isa) == (case, level)]
    return min(found, key=lambda point: point.median, default=None)


def _fastest_text(points: list[Point], case: str, level: str) -> str:
    point = fastest_of(points, case, level)
    return f"{point.median:.4f} ({point.place.technique})" if point else NOTHING


def _check_same_machine(journals: list[Journal]) -> None:
    first = journals[0]
    for other in journals[1:]:
        for what, ours, its in (
                ("processor", first.machine.cpu_name, other.machine.cpu_name),
                ("processor's flags", first.machine.cpu_flags, other.machine.cpu_flags),
                ("commit", first.machine.commit, other.machine.commit)):
            if ours != its:
                raise ReportError(f"{other.name}: its {what} is not that of {first.name}; builds "
                                  "are compared on one machine and commit")


def _highest_levels(points: list[Point]) -> list[Point]:
    """Each technique at its highest level, by case, the fastest first."""
    highest: dict[tuple[str, str], Point] = {}
    for point in points:
        key = (point.place.case.name, point.place.technique)
        if key not in highest or point.place.x > highest[key].place.x:
            highest[key] = point
    order = cases_of(points)
    return sorted(highest.values(),
                  key=lambda point: (order.index(point.place.case.name), point.median))


def _pair(first: Point, second: Point) -> tuple[str, ...]:
    place: Place = first.place
    (first_low, first_high), (low, high) = first.bounds, second.bounds
    ratio = Interval(second.median / first.median, low / first_high, high / first_low)
    return (place.case.name, place.technique, place.isa,
            *(f"{point.median * point.pixels / 1e3:,.2f}" for point in (first, second)),
            ratio.text)
