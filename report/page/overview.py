"""The overview plot: operations against time, one mark for each technique."""

from __future__ import annotations

import io
import re

import matplotlib.style
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from report.formatting import duration
from report.measure.timings import Row
from report.page.families import BITS, COPY, FAMILIES, OTHER, PEER, REFERENCE, Family, family
from report.page.operations import Headline, Rows

INK, MUTED, GRID, GROUND = "#1b1f24", "#59626d", "#dfe3e8", "#fefefe"
VARIABLES = {INK: "ink", MUTED: "muted", GRID: "line", GROUND: "card"}
"""The page's own colours, so that the plot in it is dark where the page is."""

STYLE = {
    "svg.hashsalt": "thinbench", "svg.fonttype": "none", "font.family": "DejaVu Sans",
    "font.size": 10, "text.color": INK, "figure.facecolor": GROUND, "savefig.facecolor": GROUND,
    "axes.facecolor": GROUND, "axes.edgecolor": GRID, "axes.labelcolor": MUTED,
    "axes.spines.top": False, "axes.spines.right": False, "axes.spines.left": False,
    "axes.axisbelow": True, "axes.grid": True, "grid.color": GRID, "xtick.color": MUTED,
    "ytick.color": INK, "xtick.major.size": 0, "ytick.major.size": 0}


def overview(rows: Rows, lines: list[Headline]) -> str:
    """SVG, the same for the same run."""
    with matplotlib.style.context(STYLE, after_reset=True):
        return _without_size(svg_of(_figure(rows, lines)))


def svg_of(figure: Figure) -> str:
    """The drawing alone, in colours that a page or a style may replace."""
    out = io.BytesIO()
    figure.savefig(out, format="svg", metadata=dict.fromkeys(("Date", "Creator", "Format", "Type")))
    svg = out.getvalue().decode()
    for colour, name in VARIABLES.items():
        svg = svg.replace(colour, f"var(--{name}, {colour})")
    return svg[svg.index("<svg"):]


def _figure(rows: Rows, lines: list[Headline]) -> Figure:
    figure = Figure(figsize=(6.8, 1.5 + 0.3 * len(lines)))
    axes = figure.subplots()
    for place, line in enumerate(lines):
        _draw_case(axes, -place, marks(rows, line), rows.equal_peers)
    axes.set_yticks([-place for place in range(len(lines))], [line.label for line in lines])
    axes.set_ylim(0.6 - max(len(lines), 1), 0.6)
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(LogLocator(numticks=12))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda ns, _: _round(ns)))
    axes.set_xlabel("time of a call, end to end, one thread (logarithmic)")
    handles, words = _legend(axes)
    figure.legend(handles, words, loc="upper left", ncols=3, frameon=False, fontsize=9,
                  handletextpad=0.2, columnspacing=1.2, borderaxespad=0.3)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.72 / figure.get_figheight()), pad=0.4)
    return figure


def marks(rows: Rows, line: Headline) -> list[Row]:
    """Of each technique the fastest row, and the copy."""
    found: dict[str, Row] = {}
    for row in sorted(rows.of(line.case), key=lambda row: -row.time_ns):
        found[row.technique] = row
    if line.copy:
        found[line.copy.technique] = line.copy
    return list(found.values())


def _draw_case(axes: Axes, height: float, rows: list[Row], equal_peers: set[str]) -> None:
    times = [row.time_ns for row in rows]
    axes.plot([min(times), max(times)], [height, height], color=GRID, linewidth=1.2, zorder=1)
    for row in rows:
        _mark(axes, row.time_ns, height, family(row, equal_peers))


def _mark(axes: Axes, x: float, y: float, kind: Family) -> None:
    hollow = kind in (REFERENCE, OTHER)
    axes.plot([x], [y], kind.marker, color=kind.colour, linestyle="", zorder=3,
              markersize=11 if kind is COPY else 7 if kind in (BITS, PEER) else 6,
              markerfacecolor=GROUND if hollow else kind.colour, markeredgewidth=2
              if kind is COPY else 1.2, label=kind.words)


def _legend(axes: Axes) -> tuple[list[object], list[str]]:
    handles, words = axes.get_legend_handles_labels()
    by_words = dict(zip(words, handles))
    shown = [kind.words for kind in FAMILIES if kind.words in by_words]
    return [by_words[text] for text in shown], shown


def _round(ns: float) -> str:
    """10 µs, not 10.0 µs."""
    return re.sub(r"\.0+ ", " ", duration(ns))


def _without_size(svg: str) -> str:
    return re.sub(r'(<svg [^>]*?)width="[^"]*" height="[^"]*"|height="[^"]*pt" (?=version)',
                  r"\1", svg, count=1)
