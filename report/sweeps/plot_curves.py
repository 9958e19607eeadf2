"""Curves with bands: time by size, depth and enlargement, speed-up by threads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import blended_transform_factory

from report.formatting import kibibytes, three_digits
from report.model import Cache
from report.plot_style import (BLUE, CYCLE, GREEN, MARKERS, MUTED, ORANGE, PURPLE, WIDTH, Plot,
                               label_ticks, log_ticks, rendered, title)
from report.sweeps.model import Point, cases_of
from report.sweeps.tables import points_csv

LEFT, RIGHT, TOP, BOTTOM = 0.7, 0.25, 1.2, 0.6
PANEL_HEIGHT, BETWEEN = 2.2, 0.95
BAND = 0.25
KINDS = (BLUE, ORANGE, GREEN, PURPLE)


@dataclass(frozen=True)
class Curve:
    """Values with bounds, ready to be drawn."""

    label: str
    x: list[float]
    middle: list[float]
    low: list[float]
    high: list[float]


def plot_sizes(points: list[Point], caches: tuple[Cache, ...]) -> Plot | None:
    """A panel for each case, or None if no size was measured."""
    cases = cases_of(points)
    if not cases:
        return None
    figure, panels = _panels(len(cases), 2)
    title(figure, "Image size, powers of two and awkward ones",
          "nanoseconds per pixel of the library's choice and the best scalar row on one thread; both "
          "axes log, lower is faster")
    sides = {point.place.x for point in points}
    for axes, case in zip(panels, cases):
        own = [point for point in points if point.place.case.name == case]
        _draw(axes, [_times(own, kind) for kind in _kinds(own)], KINDS)
        _log_axes(axes, [side for side in sides if _is_power(side)], sides)
        _mark_caches(axes, caches)
        axes.set_title(case, pad=16)
        axes.set_xlabel("side of the square, pixels")
        axes.legend(frameon=False, fontsize=8, loc="best")
    return rendered(figure, "sweep_size", (
        "Squares cut from the scene laid out like tiles. Hollow marks are sides that are no power "
        "of two. Dotted lines mark where one image of bytes fills a cache. The row kernel ends at "
        "512 pixels."), _alt("image size", points), points_csv(points))


def plot_depths(points: list[Point]) -> Plot | None:
    """One panel with a curve for each case, or None if no depth was measured."""
    if not points:
        return None
    side = round(points[0].pixels**0.5)
    return _curves_of_cases(points, "sweep_depth", f"Depth of strokes, {side} x {side} pixels", (
        "nanoseconds per pixel of the library's choice on one thread, a quarter of the image foreground "
        "in squares; both axes log, lower is faster"), "side of a foreground square, pixels", (
        "Foreground squares of growing side. Each iteration takes a layer off, so that deep squares "
        "take more of them; skeleton_scan takes one."), "side of squares")


def plot_enlargements(points: list[Point]) -> Plot | None:
    """The same over how many times the scene is enlarged."""
    if not points:
        return None
    return _curves_of_cases(points, "sweep_enlarged", "The scene, enlarged", (
        "nanoseconds per pixel of the library's choice on one thread; both axes log, lower is "
        "faster"), "times enlarged in both directions", (
        "Ten times is 5100 x 4120 pixels with strokes up to 580 pixels wide: ten times as many "
        "iterations, of which most find most of the image at rest."), "enlargement")


def _curves_of_cases(points: list[Point], name: str, heading: str, explanation: str,
                          x_label: str, caption: str, alternative: str) -> Plot:
    figure, (axes,) = _panels(1, 1, 3.6, 0.9)
    title(figure, heading, explanation)
    curves = [_times([point for point in points if point.place.case.name == case], None,
                     case) for case in cases_of(points)]
    _draw(axes, curves, CYCLE)
    places = {point.place.x for point in points}
    _log_axes(axes, list(places), places)
    axes.set_xlabel(x_label)
    axes.legend(frameon=False, fontsize=8, loc="upper left")
    return rendered(figure, name, caption, _alt(alternative, points), points_csv(points))


def plot_threads(points: list[Point]) -> Plot | None:
    """A panel for each image, or None if only one number of threads was measured."""
    sizes = sorted({point.place.y or 0 for point in points})
    panels_of = {size: _speedups([p for p in points if (p.place.y or 0) == size]) for size in sizes}
    panels_of = {size: curves for size, curves in panels_of.items() if curves}
    if not panels_of:
        return None
    figure, panels = _panels(len(panels_of), 2, 3.2, 1.1)
    title(figure, "Threads", "speed-up over the same technique on one thread, by wall time; dashed: "
          "as many times as threads")
    most = max(point.place.threads for point in points)
    for axes, (size, curves) in zip(panels, panels_of.items()):
        axes.plot([1, most], [1, most], color=MUTED, linewidth=1, linestyle="--")
        _draw_side_by_side(axes, curves, most)
        axes.set_title(f"{size / 1e6:.2g} million pixels")
        axes.set_xlabel("threads")
        axes.set_xticks(sorted({x for curve in curves for x in curve.x}))
        highest = max(most, *(value for curve in curves for value in curve.high))
        axes.set_ylim(0, 1.05 * highest)
        axes.set_xlim(1 - 0.06 * most, most + 0.06 * most)
    panels[0].legend(frameon=False, fontsize=8, loc="upper left")
    return rendered(figure, "sweep_threads", (
        "The scene, and the scene laid out ten times in both directions. Where other programs use "
        "the cores, too, bars are long."), _alt("threads", points), points_csv(points))


def _panels(count: int, columns: int, panel_height: float = PANEL_HEIGHT,
            above: float = TOP) -> tuple[Figure, list[Axes]]:
    rows = -(-count // columns)
    height = above + BOTTOM + rows * panel_height + (rows - 1) * BETWEEN
    figure = Figure(figsize=(WIDTH, height))
    panels = figure.subplots(rows, columns, squeeze=False, gridspec_kw={
        "left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH, "wspace": 0.14,
        "hspace": BETWEEN / panel_height, "top": 1 - above / height, "bottom": BOTTOM / height})
    for axes in panels.flat[count:]:
        axes.set_axis_off()
    return figure, list(panels.flat[:count])


def _kinds(points: list[Point]) -> list[tuple[str, str]]:
    """Technique and level, the fastest at their largest common size first."""
    best: dict[tuple[str, str], float] = {}
    for point in points:
        key = (point.place.technique, point.place.isa)
        best[key] = min(best.get(key, point.median), point.median)
    return sorted(best, key=lambda kind: best[kind])


def _times(points: list[Point], kind: tuple[str, str] | None, label: str = "") -> Curve:
    own = [p for p in points if kind in (None, (p.place.technique, p.place.isa))]
    name = label or f"{kind[0].replace('_', ' ')}, {kind[1]}"
    return Curve(name, [p.place.x for p in own], [p.median for p in own],
                 [p.bounds[0] for p in own], [p.bounds[1] for p in own])


def _speedups(points: list[Point]) -> list[Curve]:
    """Where one thread was measured, too, and at least one other number."""
    curves = []
    for case in cases_of(points):
        own = [point for point in points if point.place.case.name == case]
        alone = next((point for point in own if point.place.threads == 1), None)
        if alone is None or len(own) < 2:
            continue
        curves.append(Curve(
            case, [p.place.x for p in own], [alone.median / p.median for p in own],
            [1.0 if p is alone else alone.bounds[0] / p.bounds[1] for p in own],
            [1.0 if p is alone else alone.bounds[1] / p.bounds[0] for p in own]))
    return curves


def _draw(axes: Axes, curves: list[Curve], colours: tuple[str, ...]) -> None:
    for number, curve in enumerate(curves):
        colour = colours[number % len(colours)]
        marker = MARKERS[number % len(MARKERS)]
        axes.fill_between(curve.x, curve.low, curve.high, color=colour, alpha=BAND, linewidth=0)
        axes.plot(curve.x, curve.middle, color=colour, linewidth=1.4, label=curve.label,
                  marker=marker, markersize=4, markeredgewidth=0.9,
                  markevery=_places(curve, _is_power))
        axes.plot(curve.x, curve.middle, color=colour, linestyle="", marker=marker, markersize=4,
                  markerfacecolor="none", markeredgewidth=0.9,
                  markevery=_places(curve, lambda x: not _is_power(x)))


def _draw_side_by_side(axes: Axes, curves: list[Curve], most: int) -> None:
    """Bars from the lower to the upper bound, moved apart a little where they would overlap."""
    for number, curve in enumerate(curves):
        shift = 0.012 * most * (number - (len(curves) - 1) / 2)
        below, above = ([abs(middle - end) for middle, end in zip(curve.middle, ends)]
                        for ends in (curve.low, curve.high))
        axes.errorbar([x + shift for x in curve.x], curve.middle, [below, above],
                      color=CYCLE[number % len(CYCLE)], marker=MARKERS[number % len(MARKERS)],
                      markersize=4, linewidth=1.2, elinewidth=1, label=curve.label)


def _places(curve: Curve, is_wanted: Callable[[float], bool]) -> list[int]:
    return [place for place, x in enumerate(curve.x) if is_wanted(x)]


def _is_power(side: float) -> bool:
    whole = int(side)
    return whole == side and whole & (whole - 1) == 0


def _log_axes(axes: Axes, ticks: list[float], places: set[float]) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    label_ticks(axes, "x", sorted(ticks), lambda value: f"{value:g}")
    axes.set_xlim(min(places) * 0.85, max(places) * 1.18)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high)
    label_ticks(axes, "y", log_ticks(low, high), lambda value: f"{value:g}")


def _mark_caches(axes: Axes, caches: tuple[Cache, ...]) -> None:
    low, high = axes.get_xlim()
    top = blended_transform_factory(axes.transData, axes.transAxes)
    for cache in caches:
        side = sqrt(cache.size_kib * 1024)
        if low < side < high:
            axes.axvline(side, color=MUTED, linewidth=1, linestyle=(0, (2, 2)), zorder=1)
            axes.text(side, 1.02, f"L{cache.level} {kibibytes(cache.size_kib)}", transform=top,
                      ha="center", size=8, color=MUTED)


def _alt(what: str, points: list[Point]) -> str:
    last = max(point.place.x for point in points)
    ends = [f"{point.place.case.name} by {point.place.technique} {three_digits(point.median)}"
            for point in points if point.place.x == last]
    return (f"Curves over {what}. At {last:g}, nanoseconds per pixel: {'; '.join(ends)}.")
