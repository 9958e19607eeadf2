"""Label images as runs: what their labels measure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _images

_Integers = npt.NDArray[np.intp]

_PARTS = {"label": 0, "area": 0, "bbox": 4, "centroid": 2, "euler_number": 0, "area_filled": 0}
_OLD_NAMES = {"Area": "area", "BoundingBox": "bbox", "Centroid": "centroid", "EulerNumber": "euler_number",
              "FilledArea": "area_filled", "Label": "label", "filled_area": "area_filled"}
_MIN_CLOSED_AREA = 8  # of a 4-connected object that encloses a pixel


class _Runs:
    """Runs of equal pixels in rows, sorted by value, those of a value in raster order."""

    def __init__(self, image: npt.NDArray[Any]) -> None:
        """Of values above 0."""
        height, width = image.shape
        flat = image.ravel()
        begins = np.empty(image.shape, bool)
        np.not_equal(flat[1:], flat[:-1], out=begins.ravel()[1:])
        begins[:, :1] = True
        places = np.flatnonzero(begins)
        found = flat[places]
        kept = np.flatnonzero(found > 0)
        kept = kept[np.argsort(found[kept], kind="stable")]
        lengths = np.diff(places, append=height * width)
        self.rows, self.begins = np.divmod(places[kept], max(width, 1))
        self.ends = self.begins + lengths[kept]
        values = found[kept]
        changes = np.ones(len(values), bool)
        np.not_equal(values[1:], values[:-1], out=changes[1:])
        self.firsts = np.flatnonzero(changes)
        self.values = values[self.firsts]
        self.width = width

    def sums(self, numbers: _Integers) -> _Integers:
        """Of each value."""
        return np.add.reduceat(numbers, self.firsts)

    @property
    def boxes(self) -> tuple[_Integers, _Integers, _Integers, _Integers]:
        """First rows, first columns, last rows + 1 and last columns + 1."""
        lasts = np.append(self.firsts[1:], len(self.rows)) - 1
        return (self.rows[self.firsts], np.minimum.reduceat(self.begins, self.firsts),
                self.rows[lasts] + 1, np.maximum.reduceat(self.ends, self.firsts))

    @property
    def euler_numbers(self) -> _Integers:
        """Runs minus contacts with runs below, as every cycle of contacts has a hole in it."""
        value = np.zeros(len(self.rows), np.intp)
        value[self.firsts[1:]] = 1
        line = np.cumsum(value) * (self.rows.max() + 2) + self.rows
        step = self.width + 1
        upto = np.searchsorted(line * step + self.begins, (line + 1) * step + self.ends, "right")
        before = np.searchsorted(line * step + self.ends, (line + 1) * step + self.begins, "left")
        return self.sums(1 - (upto - before))


def measured(labels: npt.NDArray[Any], properties: Sequence[str], separator: str,
             original: str) -> dict[str, npt.NDArray[Any]]:
    """A column for each property, or several, as scikit-image names them."""
    for name in properties:
        if _OLD_NAMES.get(name, name) not in _PARTS:
            raise NotImplementedError(f"properties: expected {', '.join(_PARTS)}; got {name!r}; use {original}")
    runs = _Runs(labels)
    table: dict[str, npt.NDArray[Any]] = {}
    for name in properties:
        known = _OLD_NAMES.get(name, name)
        columns = _columns(labels, runs, known) if len(runs.values) else [np.empty(
            0, float if known == "centroid" else np.intp)] * max(_PARTS[known], 1)
        names = [f"{name}{separator}{part}" for part in range(_PARTS[known])] or [name]
        table.update(zip(names, columns))
    return table


def _columns(labels: npt.NDArray[Any], runs: _Runs, name: str) -> Sequence[npt.NDArray[Any]]:
    """The columns of a property."""
    if name == "label":
        return [runs.values.astype(np.intp)]
    if name == "bbox":
        return runs.boxes
    if name == "euler_number":
        return [runs.euler_numbers]
    if name == "area_filled":
        return [_filled_areas(labels, runs)]
    lengths = runs.ends - runs.begins
    areas = runs.sums(lengths)
    if name == "area":
        return [areas]
    columns = runs.sums(lengths * (runs.begins + runs.ends - 1) // 2)
    return [runs.sums(lengths * runs.rows) / areas, columns / areas]


def _filled_areas(labels: npt.NDArray[Any], runs: _Runs) -> _Integers:
    """With all holes, which are 8-connected."""
    areas = runs.sums(runs.ends - runs.begins)
    tops, lefts, bottoms, rights = runs.boxes
    boxes = (bottoms - tops) * (rights - lefts)
    for i in np.flatnonzero((areas >= _MIN_CLOSED_AREA) & (areas < boxes)):
        part = labels[tops[i]:bottoms[i], lefts[i]:rights[i]]
        filled = _images.fill_holes(part == runs.values[i], connectivity=4)
        areas[i] = np.count_nonzero(filled)
    return areas
