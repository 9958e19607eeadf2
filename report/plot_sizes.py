"""Time against image size: the best variant of each technique over the size sweep."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import log10, sqrt

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import blended_transform_factory

from report.cases import file_stem
from report.formatting import kibibytes, round_duration, scope_label, three_digits
from report.model import REFERENCE, Cache, Row, Study
from report.plot_style import (CYCLE, INK, MARKERS, MUTED, WIDTH, Plot, hover, label_ticks,
                               log_ticks, rendered, spread_out, title)
from report.tables import to_csv

HEIGHT = 5.6
LEFT, BETWEEN, RIGHT, TOP, BOTTOM = 0.75, 2.3, 1.6, 1.3, 0.6
LABEL_PITCH = 0.28
PANEL_HEIGHT = HEIGHT - TOP - BOTTOM
PANEL_WIDTH = (WIDTH - LEFT - BETWEEN - RIGHT) / 2

Measure = Callable[[Row], float]


@dataclass(frozen=True)
class Line:
    """One variant over the sizes, and how it is drawn in every figure of the study."""

    rows: list[Row]
    look: dict[str, str]

    @property
    def label(self) -> str:
        """The variant in words, on two lines where one would run into the next panel."""
        return self.rows[0].name.variant_label.replace(" (", "\n(")


def plot_sizes(study: Study, case: str, scope: str) -> Plot | None:
    """The figure for one case and scope, or None if the sweep has no variant in it."""
    sweep = choose_lines(study.sweep(case), scope)
    if not any(row.name.scope == scope and not row.name.is_reference
               for rows in sweep for row in rows):
        return None
    techniques = sorted({row.name.technique for row in study.rows} - {REFERENCE})
    lines = [Line(rows, _look(rows[0], techniques)) for rows in sweep]
    _tell_apart(lines)
    figure = Figure(figsize=(WIDTH, HEIGHT))
    panels = figure.subplots(1, 2, gridspec_kw={
        "left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH, "wspace": BETWEEN / PANEL_WIDTH,
        "top": 1 - TOP / HEIGHT, "bottom": BOTTOM / HEIGHT})
    title(figure, f"{case} by image size, {scope_label(scope)}",
          "the best variant of each technique at the largest size, and the best on one thread; "
          "both axes log, lower is faster")
    _draw_panel(panels[0], lines, lambda row: row.median_ns, "Time per image", round_duration)
    _draw_panel(panels[1], lines, lambda row: row.ns_per_pixel, "Nanoseconds per pixel",
                lambda value: f"{value:g}")
    for axes in panels:
        _mark_caches(axes, study.machine.caches)
    return rendered(figure, f"sizes_{file_stem(case)}_{scope}", _caption(case, scope),
                    _alt(case, scope, lines), to_csv(row for line in lines for row in line.rows))


def choose_lines(sweep: list[Row], scope: str) -> list[list[Row]]:
    """The reference, for each technique the variant that is best at its largest size, and, if the
    best of these takes several threads, the best of its technique on one."""
    reference = _by_size(row for row in sweep if row.name.is_reference)
    rows = [row for row in sweep if row.name.scope == scope and not row.name.is_reference]
    lines = [_best_line([row for row in rows if row.name.technique == technique])
             for technique in sorted({row.name.technique for row in rows})]
    if lines:
        top = min((line[-1] for line in lines), key=lambda row: (-row.pixels, row.median_ns)).name
        on_one = [row for row in rows if row.name.technique == top.technique
                  and row.name.threads == 1]
        lines += [_best_line(on_one)] if top.threads > 1 and on_one else []
    return ([reference] if reference else []) + lines


def _best_line(rows: list[Row]) -> list[Row]:
    """Among the variants of these rows the one that is fastest at the largest size."""
    largest = max(row.pixels for row in rows)
    best = min((row for row in rows if row.pixels == largest), key=lambda row: row.median_ns)
    return _by_size(row for row in rows if row.name.variant == best.name.variant)


def _by_size(rows: Iterable[Row]) -> list[Row]:
    return sorted(rows, key=lambda row: row.pixels)


def _look(row: Row, techniques: list[str]) -> dict[str, str]:
    """Colour and marker together tell lines apart, also in grey; the reference is dashed."""
    if row.name.is_reference:
        return {"color": INK, "marker": "o", "linestyle": "--"}
    number = techniques.index(row.name.technique)
    return {"color": CYCLE[number % len(CYCLE)], "marker": MARKERS[number % len(MARKERS)],
            "linestyle": "-"}


def _tell_apart(lines: list[Line]) -> None:
    """A second line of a technique keeps its colour and is dotted."""
    seen: set[str] = set()
    for line in lines:
        technique = line.rows[0].name.technique
        if technique in seen:
            line.look["linestyle"] = ":"
        seen.add(technique)


def _draw_panel(axes: Axes, lines: list[Line], measure: Measure, heading: str,
                text: Callable[[float], str]) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(heading, pad=20)
    for line in lines:
        [drawn] = axes.plot([_side(row) for row in line.rows], [measure(row) for row in line.rows],
                            linewidth=1.7, markersize=4.5, **line.look)
        hover(drawn, f"{line.rows[0].name.variant_label}: " + ", ".join(
            f"{_side(row):.0f}² {text(float(three_digits(measure(row)).replace(',', '')))}"
            for row in line.rows))
    sides = sorted({_side(row) for line in lines for row in line.rows})
    label_ticks(axes, "x", sides, lambda side: f"{side:.0f}²")
    axes.set_xlim(sides[0] * 0.85, sides[-1] * 1.18)
    axes.set_xlabel("image size, pixels")
    values = [measure(row) for line in lines for row in line.rows]
    low, high = min(values) / 1.5, max(values) * 1.5
    axes.set_ylim(low, high)
    label_ticks(axes, "y", log_ticks(low, high), text)
    _label_lines(axes, lines, measure)


def _label_lines(axes: Axes, lines: list[Line], measure: Measure) -> None:
    """Each line's name beside its last point, moved apart where they would overlap."""
    low, high = (log10(limit) for limit in axes.get_ylim())
    left, right = (log10(limit) for limit in axes.get_xlim())
    ends = [(log10(measure(line.rows[-1])) - low) / (high - low) for line in lines]
    last = max(_side(line.rows[-1]) for line in lines)
    places = spread_out(ends, LABEL_PITCH / PANEL_HEIGHT)
    for line, end, place in zip(lines, ends, places):
        side = _side(line.rows[-1])
        start = 1 if side == last else (log10(side) - left) / (right - left) + 0.02
        axes.annotate(
            line.label, (start, end), (1.07, place), xycoords="axes fraction",
            textcoords="axes fraction", size=8, va="center", color=INK, annotation_clip=False,
            arrowprops={"arrowstyle": "-", "color": line.look["color"], "linewidth": 1.2 if side == last else 0.5,
                        "shrinkA": 1, "shrinkB": 0, "relpos": (0, 0.5)})


def _mark_caches(axes: Axes, caches: tuple[Cache, ...]) -> None:
    """A line at the side of the square whose bytes, one a pixel, fill each level of cache."""
    low, high = axes.get_xlim()
    top = blended_transform_factory(axes.transData, axes.transAxes)
    for cache in caches:
        side = sqrt(cache.size_kib * 1024)
        if low < side < high:
            axes.axvline(side, color=MUTED, linewidth=1, linestyle=(0, (2, 2)), zorder=1)
            axes.text(side, 1.02, f"L{cache.level} {kibibytes(cache.size_kib)}", transform=top,
                      ha="center", size=8, color=MUTED)


def _side(row: Row) -> float:
    return sqrt(row.pixels)


def _caption(case: str, scope: str) -> str:
    return (f"{case}, {scope_label(scope)}: time per image and per pixel over square images. "
            "The dashed line is the reference, always end to end. Dotted lines mark where one "
            "image of bytes fills a cache; a bit-packed image, eight times smaller, fills it at "
            "2.8 times that side.")


def _alt(case: str, scope: str, lines: list[Line]) -> str:
    ends = [f"{line.rows[0].name.variant_label}: {three_digits(line.rows[-1].ns_per_pixel)} ns per pixel"
            for line in lines]
    return (f"Lines of time against image size for {case}, {scope_label(scope)}. "
            f"At the largest size, {'; '.join(ends)}.")
