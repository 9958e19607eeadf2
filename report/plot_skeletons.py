"""A contact sheet: the same detail of one input, thinned by each case."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from PIL import Image

from report.errors import ReportError
from report.plot_style import BLUE, WIDTH, Plot, rendered, styled, title
from report.quality import Skeleton
from report.tables import csv_text

ACROSS, DETAIL, STEP = 3, 120, 20
PITCH, TOP = WIDTH / ACROSS, 0.8
SHAPE, PAPER = "#c9ced5", "#f4f5f7"


def plot_skeletons(name: str, rows: list[Skeleton], folder: Path,
                   symmetry: str) -> Plot | None:
    """The figure, or None if the pictures were not written; `symmetry` heads a column of its CSV."""
    cases = [row.case for row in rows]
    ends = ("", *(f"_{case.stem}" for case in cases))
    paths = [folder / f"quality_{name}{end}.png" for end in ends]
    if not all(path.is_file() for path in paths):
        return None
    shape, *skeletons = map(_foreground, paths)
    detail = busiest(shape)
    down = -(-len(cases) // ACROSS)
    with styled():
        height = TOP + PITCH * down
        figure = Figure(figsize=(WIDTH, height))
        panels = figure.subplots(down, ACROSS, squeeze=False, gridspec_kw={
            "left": 0.02, "right": 0.98, "bottom": 0.1 / height, "top": 1 - (TOP + 0.2) / height,
            "wspace": 0.06, "hspace": 0.12})
        title(figure, f"Skeletons of {name}", f"the {DETAIL} x {DETAIL} pixels with most contour; "
              "grey: the object, blue: its skeleton")
        for axes in panels.flat:
            axes.set_axis_off()
        for axes, case, skeleton in zip(panels.flat, cases, skeletons):
            _draw(axes, case.name, shape[detail], skeleton[detail])
        return rendered(figure, f"skeletons_{name}", _caption(name),
                        f"{_caption(name)} Cases: {', '.join(case.name for case in cases)}.",
                        _csv(rows, symmetry))


def busiest(shape: np.ndarray) -> tuple[slice, slice]:
    """The detail with the longest contour, on a coarse grid; all of a smaller picture."""
    contour = np.zeros(shape.shape, dtype=int)
    contour[:, 1:] += shape[:, 1:] != shape[:, :-1]
    contour[1:] += shape[1:] != shape[:-1]
    places = [(y, x) for y in range(0, max(1, shape.shape[0] - DETAIL + 1), STEP)
              for x in range(0, max(1, shape.shape[1] - DETAIL + 1), STEP)]
    windows = [(slice(y, y + DETAIL), slice(x, x + DETAIL)) for y, x in places]
    return max(windows, key=lambda window: int(contour[window].sum()))


def _foreground(path: Path) -> np.ndarray:
    try:
        with Image.open(path) as picture:
            return np.asarray(picture.convert("L")) >= 128
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error}; a picture is needed") from None


def _draw(axes: Axes, case: str, shape: np.ndarray, skeleton: np.ndarray) -> None:
    colours = np.array([to_rgb(colour) for colour in (PAPER, SHAPE, BLUE)])
    axes.imshow(colours[np.where(skeleton, 2, shape.astype(int))], interpolation="none")
    axes.set_title(case, pad=4)


def _csv(rows: list[Skeleton], symmetry: str) -> str:
    header = ("operation", "input", "objects_before", "objects_after", "holes_before",
              "holes_after", "pixels", "blocks", "ends", "branches", "mean_distance",
              "largest_distance", symmetry, "iterations", "border", "max_iterations")
    return csv_text(header, ((row.case.operation, row.input, *row.objects, *row.holes, row.pixels,
                              row.blocks, row.ends, row.branches, row.mean_distance,
                              row.largest_distance, row.least_symmetry, row.iterations,
                              *row.case.columns)
                             for row in rows))


def _caption(name: str) -> str:
    return f"The same detail of {name}, thinned by every case."
