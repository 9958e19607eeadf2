"""Curves of the series of sizes and of parameter sweeps, as Chart.js draws them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from report.formatting import NOTHING
from report.measure.timings import END_TO_END, Row
from report.page.operations import Rows, fastest, is_square, label, place, title
from report.sweeps.plans import BY_NAME
from report.sweeps.series import Series, lines_of, places_of, sweep_series

Curve = dict[str, Any]


@dataclass(frozen=True)
class Chart:
    """Nanoseconds per pixel over something; `curves` holds points [x, value, high, flags]."""

    group: str
    title: str
    x: str
    curves: tuple[Curve, ...]

    @property
    def places(self) -> list[Any]:
        """All places on the axis."""
        return places_of([point[0] for point in curve["points"]] for curve in self.curves)

    @property
    def table(self) -> list[list[str]]:
        """A line for each place, a cell for each curve."""
        return lines_of([{point[0]: f"{point[1]:.3g}{' !' if point[3] else ''}" for point in curve["points"]}
                         for curve in self.curves], NOTHING)


def chart_groups(rows: Rows, sweeps: Iterable[Row]) -> dict[str, list[Chart]]:
    """By what is varied."""
    groups: dict[str, list[Chart]] = {}
    for chart in (*size_chart(rows), *sweep_charts(sweeps)):
        groups.setdefault(chart.group, []).append(chart)
    return groups


def size_chart(rows: Rows) -> list[Chart]:
    """The fastest variant on one thread of each case on squares; none below two sizes."""
    squares = [row for row in rows.rows if is_square(row.input) and row.threads == 1
               and row.scope == END_TO_END and not (row.peer or row.is_reference)]
    curves = [{"label": label(case), "points": _by_size(row for row in squares if row.case == case)}
              for case in sorted({row.case for row in squares}, key=place)]
    curves = [curve for curve in curves if len(curve["points"]) > 1]
    return [Chart("image size", "The fastest variant of each operation", "side of the square, pixels",
                  tuple(curves))] if curves else []


def sweep_charts(rows: Iterable[Row]) -> list[Chart]:
    """One for each sweep and case."""
    by_chart: dict[tuple[str, str], list[Series]] = {}
    for series in sorted(sweep_series(rows), key=lambda one: place(one.case)):
        by_chart.setdefault((series.sweep, series.case), []).append(series)
    return [Chart(f"sweep {sweep}", title(case), BY_NAME[sweep].what, tuple(map(_curve, curves)))
            for (sweep, case), curves in by_chart.items()]


def _curve(series: Series) -> Curve:
    return {"label": series.label,
            "points": [[point.x, *_rounded(point.ns_per_pixel, point.high), point.flags]
                       for point in series.points]}


def _by_size(rows: Iterable[Row]) -> list[list[Any]]:
    by_side: dict[int, list[Row]] = {}
    for one in rows:
        by_side.setdefault(one.width, []).append(one)
    best = [row for side in sorted(by_side) if (row := fastest(by_side[side]))]
    return [[row.width, *_rounded(row.ns_per_pixel, row.high_ns / row.width / row.height), row.flags]
            for row in best]


def _rounded(*values: float) -> list[float]:
    return [float(f"{value:.4g}") for value in values]
