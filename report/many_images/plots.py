"""The plots, drawn from the CSV file, light or dark as the reader's page is."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import matplotlib.style
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullLocator

from report.formatting import duration, three_digits
from report.many_images.of_arrays import CHUNKS, IN_MEMORY, LARGE
from report.many_images.of_files import IMAGES, STAGES, WORKERS
from report.many_images.results import Result
from report.page.overview import MUTED, STYLE, svg_of

COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9")
"""Those of Okabe and Ito, as on the page."""

MARKERS = ("o", "D", "s", "^", "v")

DARK = ("<style>@media (prefers-color-scheme: dark) { svg { --ink: #e8ebef; --muted: #a3acb8; "
        "--line: #363d47; --card: #1a1f26 } }</style>")


def plots(results: list[Result]) -> dict[str, bytes]:
    """By the names of their files."""
    draw: dict[str, Callable[[list[Result]], Figure]] = {
        "images.svg": _images, "workers.svg": _workers, "dask.svg": _dask,
        "out_of_core.svg": _out_of_core}
    with matplotlib.style.context(STYLE, after_reset=True):
        return {name: _with_dark(svg_of(figure(results))).encode() for name, figure in draw.items()}


def _with_dark(svg: str) -> str:
    end = svg.index(">") + 1
    return svg[:end] + DARK + svg[end:]


def series(results: list[Result], experiment: str, quantity: str) -> dict[str, list[Result]]:
    """By method, in the order of the file."""
    found: dict[str, list[Result]] = {}
    for one in results:
        if (one.experiment, one.quantity) == (experiment, quantity):
            found.setdefault(one.method, []).append(one)
    return found


def _images(results: list[Result]) -> Figure:
    """A line for each method, a mark for each stage; what gives the same pixels is a group."""
    rates = series(results, IMAGES, "images_per_second")
    figure = Figure(figsize=(8.6, 1.3 + 0.34 * len(rates)))
    axes = figure.subplots()
    bases = list(dict.fromkeys(one.base for (one,) in rates.values()))
    heights = [-index - 0.4 * bases.index(one.base) for index, (one,) in enumerate(rates.values())]
    for stage, colour, marker in zip(STAGES, COLOURS, MARKERS):
        for height, (one,) in zip(heights, series(results, IMAGES, f"{stage}_ms").values()):
            _errorbar(axes, [one.median], [height], colour, marker, None if height else stage,
                      xerr=_lengths([one]))
    for height, (one,) in zip(heights, rates.values()):
        axes.text(1.02, height, f"{three_digits(one.median)} images/s", va="center",
                  transform=axes.get_yaxis_transform())
    axes.set_yticks(heights, list(rates))
    axes.set_ylim(heights[-1] - 0.6, 0.6)
    _log(axes.set_xscale, axes.xaxis)
    axes.xaxis.set_major_formatter(FuncFormatter(_milliseconds))
    axes.set_xlabel("time per image of 510 x 412 pixels, one thread (logarithmic)")
    return _finished(figure, axes)


def _workers(results: list[Result]) -> Figure:
    figure = Figure(figsize=(6.8, 3.6))
    axes = figure.subplots()
    curves = series(results, WORKERS, "images_per_second")
    counts = sorted({one.x for curve in curves.values() for one in curve})
    first = next(iter(curves.values()))[0]
    axes.plot(counts, [count * first.median for count in counts], "--", color=MUTED,
              label="one thread times workers")
    _draw(axes, curves)
    axes.xaxis.set_major_locator(FixedLocator(counts))
    axes.set_ylim(bottom=0)
    axes.set_xlabel("workers")
    axes.set_ylabel("images of 510 x 412 pixels per second")
    return _finished(figure, axes)


def _dask(results: list[Result]) -> Figure:
    figure = Figure(figsize=(6.8, 3.6))
    axes = figure.subplots()
    curves = series(results, CHUNKS, "ms_per_chunk_beyond_memory")
    _draw(axes, curves)
    sides = sorted({one.x for curve in curves.values() for one in curve})
    (memory,) = series(results, CHUNKS, "ns_per_pixel")[IN_MEMORY]
    axes.plot(sides, [1e-6 * memory.median * side**2 for side in sides], "--", color=MUTED,
              label="for comparison: thinning a chunk in memory")
    _log(axes.set_xscale, axes.xaxis)
    axes.xaxis.set_major_locator(FixedLocator(sides))
    _plain(axes.xaxis)
    _log(axes.set_yscale, axes.yaxis)
    axes.yaxis.set_major_formatter(FuncFormatter(_milliseconds))
    axes.set_xlabel("side of a chunk, pixels (logarithmic)")
    axes.set_ylabel("processor time per chunk beyond\nthat in memory (logarithmic)")
    return _finished(figure, axes)


def _out_of_core(results: list[Result]) -> Figure:
    figure = Figure(figsize=(6.8, 3.6))
    axes = figure.subplots()
    curves = series(results, LARGE, "ns_per_pixel")
    _draw(axes, curves)
    axes.xaxis.set_major_locator(FixedLocator(sorted({one.x for curve in curves.values()
                                                      for one in curve})))
    _plain(axes.xaxis)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("side of the image, pixels")
    axes.set_ylabel("processor time per pixel, ns")
    return _finished(figure, axes)


def _draw(axes: Axes, curves: dict[str, list[Result]]) -> None:
    for (name, curve), colour, marker in zip(curves.items(), COLOURS, MARKERS):
        _errorbar(axes, [one.x for one in curve], [one.median for one in curve], colour, marker,
                  name, yerr=_lengths(curve))


def _errorbar(axes: Axes, x: Sequence[float], y: Sequence[float], colour: str, marker: str,
              label: str | None, **lengths: list[list[float]]) -> None:
    axes.errorbar(x, y, color=colour, marker=marker, label=label, capsize=3, **lengths)


def _lengths(curve: list[Result]) -> list[list[float]]:
    """From the median to both ends of its interval."""
    return [[one.median - one.low for one in curve], [one.high - one.median for one in curve]]


def _log(set_scale: Callable[[str], None], axis: matplotlib.axis.Axis) -> None:
    set_scale("log")
    axis.set_major_locator(LogLocator(numticks=12))
    axis.set_minor_locator(NullLocator())


def _plain(axis: matplotlib.axis.Axis) -> None:
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))


def _milliseconds(value: float, _: object) -> str:
    return duration(1e6 * value).replace(".00 ", " ").replace(".0 ", " ")


def _finished(figure: Figure, axes: Axes) -> Figure:
    handles, words = axes.get_legend_handles_labels()
    columns = 3 if max(map(len, words)) < 20 else 2
    figure.legend(handles, words, loc="upper left", ncols=columns, frameon=False, fontsize=9,
                  borderaxespad=0.3)
    height = 0.2 + 0.2 * -(-len(words) // columns)
    figure.tight_layout(rect=(0, 0, 1, 1 - height / figure.get_figheight()), pad=0.4)
    return figure
