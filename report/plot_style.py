"""How all figures look, and how one becomes SVG and PNG bytes that never vary."""

from __future__ import annotations

import io
from dataclasses import dataclass

import matplotlib.style
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator
from PIL import Image

from report.small_svg import HOVER, small_svg

INK = "#1b1f24"
MUTED = "#59626d"
GRID = "#dfe3e8"
CARD = "#fefefe"
GREY = "#8b929b"

# Okabe and Ito's colours, which the common kinds of colour blindness keep apart.
ORANGE, SKY, GREEN, YELLOW = "#e69f00", "#56b4e9", "#009e73", "#d8c80f"
BLUE, VERMILLION, PURPLE = "#0072b2", "#d55e00", "#cc79a7"
CYCLE = (BLUE, ORANGE, GREEN, PURPLE, SKY, VERMILLION, YELLOW)
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*", "<", ">", "p")

STYLE = {
    "svg.hashsalt": "thinbench", "svg.fonttype": "none", "text.parse_math": False,
    "font.family": "DejaVu Sans", "font.size": 9.5, "text.color": INK,
    "figure.facecolor": CARD, "savefig.facecolor": CARD, "axes.facecolor": CARD,
    "axes.edgecolor": GRID, "axes.labelcolor": MUTED, "axes.spines.top": False,
    "axes.spines.right": False, "axes.axisbelow": True, "axes.grid": True, "grid.color": GRID,
    "grid.linewidth": 0.8, "xtick.color": MUTED, "ytick.color": MUTED, "xtick.major.size": 0,
    "ytick.major.size": 0, "hatch.linewidth": 0.9, "axes.titlesize": 10.5,
    "axes.titleweight": "bold", "axes.titlelocation": "left",
}

WIDTH = 11.5
"""Inches, for every figure, so that letters are equally large on the page."""

PNG_DPI = 72


@dataclass(frozen=True)
class Plot:
    """A finished figure, with the words that stand for it where it cannot be seen."""

    stem: str
    caption: str
    alt: str
    svg: bytes
    png: bytes
    csv: str
    """What is drawn, as numbers."""


def styled():
    """The context in which figures are made, whatever the user's matplotlibrc says."""
    return matplotlib.style.context(STYLE, after_reset=True)


def hover(artist: Artist, text: str) -> None:
    """What a page shows where the pointer rests on the artist; small_svg makes a title of it."""
    artist.set_gid(HOVER + " ".join(text.split()))


def rendered(figure: Figure, stem: str, caption: str, alt: str, csv: str,
             colours: int = 16) -> Plot:
    """Both formats, without dates, versions or random identifiers; `colours` of the PNG file."""
    svg, png = io.BytesIO(), io.BytesIO()
    nameless = dict.fromkeys(("Date", "Creator", "Format", "Type"))
    figure.savefig(svg, format="svg", metadata=nameless)
    figure.savefig(png, format="png", dpi=PNG_DPI, metadata={"Software": None})
    return Plot(stem, caption, alt, small_svg(svg.getvalue()), _with_palette(png, colours), csv)


def _with_palette(png: io.BytesIO, colours: int) -> bytes:
    """The same picture in few colours; flat drawings need 16 at most: a quarter of the bytes."""
    small = io.BytesIO()
    with Image.open(png) as picture:
        picture.convert("RGB").quantize(colours, dither=Image.Dither.NONE).save(
            small, format="png", optimize=True)
    return small.getvalue()


def title(figure: Figure, heading: str, subheading: str) -> None:
    """Two left-aligned lines at a fixed distance from the top edge."""
    height = figure.get_figheight()
    figure.text(0.2 / figure.get_figwidth(), 1 - 0.2 / height, heading, size=13, weight="bold",
                va="top")
    figure.text(0.2 / figure.get_figwidth(), 1 - 0.46 / height, subheading, size=9.5, color=MUTED,
                va="top")


def log_ticks(low: float, high: float) -> list[float]:
    """Round numbers between two limits: 1, 2, 5 over few decades, 1, 3 or 1 alone over many."""
    decades = range(-9, 13)
    for steps, most in (((1, 2, 5), 8), ((1, 3), 8), ((1,), 99)):
        ticks = [step * 10.0**decade for decade in decades for step in steps]
        inside = [tick for tick in ticks if low <= tick <= high]
        if len(inside) <= most:
            break
    return inside


def label_ticks(axes: Axes, which: str, ticks: list[float], text) -> None:
    """Puts exactly these ticks, labelled by `text`, on an axis."""
    axis = axes.xaxis if which == "x" else axes.yaxis
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: text(value)))


def spread_out(targets: list[float], gap: float) -> list[float]:
    """Moves positions apart to at least `gap`, by the least sum of squared moves.

    This is isotonic regression by pooling neighbours: once `gap` times the rank
    is taken off, the places only have to be in order.
    """
    order = sorted(range(len(targets)), key=lambda index: targets[index])
    pools: list[list[float]] = []
    for rank, index in enumerate(order):
        pools.append([targets[index] - rank * gap])
        while len(pools) > 1 and _mean(pools[-2]) > _mean(pools[-1]):
            last = pools.pop()
            pools[-1] += last
    level = [_mean(pool) for pool in pools for _ in pool]
    places = [0.0] * len(targets)
    for rank, index in enumerate(order):
        places[index] = level[rank] + rank * gap
    return places


def _mean(values: list[float]) -> float:
    return sum(values) / len(values)
