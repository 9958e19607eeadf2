"""Bars: the fastest technique of each instruction-set level."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.formatting import three_digits
from report.plot_speedups import look_of
from report.plot_style import (CARD, INK, WIDTH, Plot, hover, label_ticks, log_ticks, rendered,
                               title)
from report.sweeps.model import Point, cases_of
from report.sweeps.tables import fastest_of, points_csv

HEIGHT = 4.2
LEFT, RIGHT, TOP, BOTTOM = 0.75, 0.3, 0.9, 0.5
GROUP_WIDTH, BAR_WIDTH = 0.82, 0.15


def plot_levels(points: list[Point], levels: tuple[str, ...]) -> Plot | None:
    """Groups of bars by case, or None if no level was measured."""
    cases = cases_of(points)
    if not cases:
        return None
    levels = tuple(level for level in levels if any(p.place.isa == level for p in points))
    figure = Figure(figsize=(WIDTH, HEIGHT))
    axes = figure.subplots(gridspec_kw={"left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH,
                                        "top": 1 - TOP / HEIGHT, "bottom": BOTTOM / HEIGHT})
    title(figure, "Instruction-set levels, on the scene",
          "nanoseconds per pixel of the fastest technique of each level, on one thread; log scale, "
          "lower is faster")
    axes.set_yscale("log")
    low, high = _limits(points, cases, levels)
    axes.set_ylim(low, high)
    for number, level in enumerate(levels):
        found = [(place, point) for place, name in enumerate(cases)
                 if (point := fastest_of(points, name, level))]
        _draw_bars(axes, level, found, (number + 0.5) / len(levels) - 0.5, low)
    label_ticks(axes, "y", log_ticks(low, high), lambda value: f"{value:g}")
    axes.set_xlim(-0.5, len(cases) - 0.5)
    axes.set_xticks(range(len(cases)), cases)
    axes.grid(False, axis="x")
    axes.legend(frameon=False, fontsize=8, ncols=len(levels), loc="upper left")
    return rendered(figure, "sweep_isa", (
        "A level may use the techniques of those below it; a bar is the fastest that is compiled "
        "for the level itself. Levels that a technique lacks have no bar."),
        _alt(points, cases, levels), points_csv(points))


def _limits(points: list[Point], cases: list[str],
            levels: tuple[str, ...]) -> tuple[float, float]:
    """Room round the shown bars, and for the legend above them."""
    bounds = [point.bounds for name in cases for level in levels
              if (point := fastest_of(points, name, level))]
    return min(low for low, _ in bounds) / 1.6, max(high for _, high in bounds) * 2


def _draw_bars(axes: Axes, level: str, found: list[tuple[int, Point]], shift: float,
               bottom: float) -> None:
    """One bar in every group, `shift` of the group's width beside its middle."""
    colour, hatch = look_of(level)
    middles = [point.median for _, point in found]
    errors = [[point.median - point.bounds[0] for _, point in found],
              [point.bounds[1] - point.median for _, point in found]]
    bars = axes.bar([place + shift * GROUP_WIDTH for place, _ in found],
             [middle - bottom for middle in middles], bottom=bottom, width=BAR_WIDTH, color=colour,
             hatch=hatch, edgecolor=CARD, linewidth=0, label=level, yerr=errors, ecolor=INK,
             error_kw={"elinewidth": 1})
    for bar, (_, point) in zip(bars, found):
        hover(bar, point.words)


def _alt(points: list[Point], cases: list[str], levels: tuple[str, ...]) -> str:
    parts = []
    for name in cases:
        values = [f"{level} {three_digits(point.median)}" for level in levels
                  if (point := fastest_of(points, name, level))]
        parts.append(f"{name}: {', '.join(values)}")
    return f"Bars of nanoseconds per pixel by level. {'; '.join(parts)}."
