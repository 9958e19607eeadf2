"""Heat maps: time a pixel by the density of noise and the side of its blocks."""

from __future__ import annotations

from math import log10

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from report.formatting import three_digits
from report.plot_style import WIDTH, Plot, hover, rendered, title
from report.sweeps.model import Point, cases_of
from report.sweeps.tables import points_csv

LEFT, RIGHT, TOP, BOTTOM = 0.6, 0.2, 1.1, 0.55
PANEL_HEIGHT, BETWEEN = 2.35, 0.85
COLUMNS = 2

# Eight steps of cividis, which reads alike with any colour vision and in grey. Few, so that
# the drawing stays small. Letters on them keep their colour in dark mode.
STEPS = ("#00224e", "#123570", "#434e6c", "#61656f", "#7d7c78", "#9b9476", "#c2b56a", "#fde737")
ON_DARK, ON_LIGHT = "#ffffff", "#101010"
FIRST_LIGHT_STEP = 5
PNG_COLOURS = 64
LEAST_SPAN = 4.0


def plot_density(points: list[Point]) -> Plot | None:
    """A map for each case, or None if no density was measured."""
    cases = cases_of(points)
    if not cases:
        return None
    rows = -(-len(cases) // COLUMNS)
    height = TOP + BOTTOM + rows * PANEL_HEIGHT + (rows - 1) * BETWEEN
    figure = Figure(figsize=(WIDTH, height))
    panels = figure.subplots(rows, COLUMNS, squeeze=False, gridspec_kw={
        "left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH, "wspace": 0.12,
        "hspace": BETWEEN / PANEL_HEIGHT, "top": 1 - TOP / height, "bottom": BOTTOM / height})
    side = round(points[0].pixels**0.5)
    title(figure, f"Density and granularity of noise, {side} x {side} pixels",
          "nanoseconds per pixel of the library's choice on one thread; each map has its own colours, "
          "in equal ratios from dark, fast, to light, slow")
    for axes, case in zip(panels.flat, cases):
        _draw_map(axes, [point for point in points if point.place.case.name == case])
    for axes in panels.flat[len(cases):]:
        axes.set_axis_off()
    return rendered(figure, "sweep_density", _caption(), _alt(points, cases),
                    points_csv(points), PNG_COLOURS)


def cell_text(value: float) -> str:
    """Two digits or three, as a cell has room for."""
    return f"{value:.3f}" if value < 0.0995 else f"{value:.2f}" if value < 9.995 else f"{value:.1f}"


def step_of(value: float, low: float, high: float) -> int:
    """Which of the colours a value has between the lowest and the highest, on a log scale.

    All colours together span at least LEAST_SPAN, so that noise stays one colour.
    """
    share = log10(value / low) / log10(max(high / low, LEAST_SPAN))
    return min(len(STEPS) - 1, int(share * len(STEPS)))


def _draw_map(axes: Axes, points: list[Point]) -> None:
    across = sorted({point.place.x for point in points})
    up = sorted({point.place.y or 0 for point in points})
    low, high = (pick(point.median for point in points) for pick in (min, max))
    for point in points:
        step = step_of(point.median, low, high)
        x, y = across.index(point.place.x), up.index(point.place.y or 0)
        cell = axes.add_patch(Rectangle((x, y), 1, 1, facecolor=STEPS[step], linewidth=0))
        hover(cell, point.words)
        axes.text(x + 0.5, y + 0.5, cell_text(point.median), size=7, ha="center",
                  va="center_baseline", color=ON_LIGHT if step >= FIRST_LIGHT_STEP else ON_DARK)
    axes.set_xlim(0, len(across))
    axes.set_ylim(0, len(up))
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)
    axes.set_xticks([place + 0.5 for place in range(len(across))], [f"{x:g}" for x in across])
    axes.set_yticks([place + 0.5 for place in range(len(up))], [f"{y:g}" for y in up])
    axes.set_xlabel("foreground blocks, %")
    axes.set_ylabel("side of a block, pixels")
    axes.set_title(_heading(points))


def _heading(points: list[Point]) -> str:
    place = points[0].place
    return f"{place.case.name} ({place.technique.replace('_', ' ')}, {place.isa})"


def _caption() -> str:
    return ("Random blocks of 1 to 16 pixels, of which 0 to 100 % are foreground. An image that "
            "is foreground all over takes thinning the most iterations.")


def _alt(points: list[Point], cases: list[str]) -> str:
    parts = []
    for case in cases:
        own = [point for point in points if point.place.case.name == case]
        worst = max(own, key=lambda point: point.median)
        best = min(point.median for point in own)
        parts.append(f"{case} from {three_digits(best)} to {three_digits(worst.median)} at "
                     f"{worst.place.x:g} % in blocks of {worst.place.y or 0:g}")
    return f"Heat maps of nanoseconds per pixel: {'; '.join(parts)}."
