"""Label images as runs: what their labels measure."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _images

_Integers = npt.NDArray[np.intp]

_WHOLE = ("label", "area", "area_bbox", "area_filled", "bbox", "euler_number")
_OF_INTENSITIES = ("centroid_weighted", "intensity_max", "intensity_mean", "intensity_min")
_SHAPES: dict[str, tuple[int, ...]] = dict.fromkeys([
    *_WHOLE, *_OF_INTENSITIES, "axis_major_length", "axis_minor_length", "eccentricity", "equivalent_diameter_area",
    "extent", "orientation", "perimeter"], ()) | {
    "bbox": (4,), "centroid": (2,), "centroid_weighted": (2,), "inertia_tensor": (2, 2), "inertia_tensor_eigvals": (2,)}
_PARTS = {name: [tuple(map(str, index)) for index in itertools.product(*map(range, shape))]
          for name, shape in _SHAPES.items()}  # what the names of columns end with
_OLD_NAMES = {
    "Area": "area", "BoundingBox": "bbox", "BoundingBoxArea": "area_bbox", "Centroid": "centroid",
    "Eccentricity": "eccentricity", "EquivDiameter": "equivalent_diameter_area", "EulerNumber": "euler_number",
    "Extent": "extent", "FilledArea": "area_filled", "InertiaTensor": "inertia_tensor",
    "InertiaTensorEigvals": "inertia_tensor_eigvals", "Label": "label", "MajorAxisLength": "axis_major_length",
    "MaxIntensity": "intensity_max", "MeanIntensity": "intensity_mean", "MinIntensity": "intensity_min",
    "MinorAxisLength": "axis_minor_length", "Orientation": "orientation", "Perimeter": "perimeter",
    "WeightedCentroid": "centroid_weighted", "bbox_area": "area_bbox",
    "equivalent_diameter": "equivalent_diameter_area", "filled_area": "area_filled",
    "major_axis_length": "axis_major_length", "max_intensity": "intensity_max", "mean_intensity": "intensity_mean",
    "min_intensity": "intensity_min", "minor_axis_length": "axis_minor_length",
    "weighted_centroid": "centroid_weighted"}
_STEP_KINDS = np.zeros((5, 5), np.uint8)  # by the numbers of neighbours at sides and diagonals
for _sides, _diagonals, _kind in ((2, 0, 1), (3, 0, 1), (2, 1, 1), (3, 1, 1), (2, 2, 1), (3, 2, 1), (0, 2, 2),
                                  (1, 3, 2), (1, 1, 3), (1, 2, 3)):
    _STEP_KINDS[_sides, _diagonals] = _kind  # 1: straight, 2: diagonal, 3: one end of each
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
        self._places, self._kept = places, kept

    def sums(self, numbers: npt.NDArray[Any]) -> Any:
        """Of each value."""
        return np.add.reduceat(numbers, self.firsts)

    def of_pixels(self, numbers: npt.NDArray[Any], reduceat: Callable[..., Any] = np.add.reduceat) -> Any:
        """The sum, or another reduction, of numbers of each value's pixels."""
        return reduceat(reduceat(numbers.ravel(), self._places, dtype=float)[self._kept], self.firsts)

    @cached_property
    def owners(self) -> _Integers:
        """The index of each run's value."""
        steps = np.zeros(len(self.rows), np.intp)
        steps[self.firsts[1:]] = 1
        return np.cumsum(steps)

    @cached_property
    def areas(self) -> _Integers:
        """In pixels."""
        areas: _Integers = self.sums(self.ends - self.begins)
        return areas

    @cached_property
    def boxes(self) -> tuple[_Integers, _Integers, _Integers, _Integers]:
        """First rows, first columns, last rows + 1 and last columns + 1."""
        lasts = np.append(self.firsts[1:], len(self.rows)) - 1
        return (self.rows[self.firsts], np.minimum.reduceat(self.begins, self.firsts),
                self.rows[lasts] + 1, np.maximum.reduceat(self.ends, self.firsts))

    @property
    def box_areas(self) -> _Integers:
        """In pixels."""
        tops, lefts, bottoms, rights = self.boxes
        return (bottoms - tops) * (rights - lefts)

    @property
    def euler_numbers(self) -> _Integers:
        """Runs minus contacts with runs below, as every cycle of contacts has a hole in it."""
        line = self.owners * (self.rows.max() + 2) + self.rows
        step = self.width + 1
        upto = np.searchsorted(line * step + self.begins, (line + 1) * step + self.ends, "right")
        before = np.searchsorted(line * step + self.ends, (line + 1) * step + self.begins, "left")
        numbers: _Integers = self.sums(1 - (upto - before))
        return numbers

    @cached_property
    def variances(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Of columns and of rows, and their covariance; sums of whole numbers are exact up to 2^53."""
        tops, lefts, _, _ = self.boxes
        y, begins, ends = (numbers.astype(float) for numbers in (
            self.rows - tops[self.owners], self.begins - lefts[self.owners], self.ends - lefts[self.owners]))
        lengths, squares = ends - begins, [x * (x - 1) * (2 * x - 1) / 6 for x in (begins, ends)]
        of_x = lengths * (begins + ends - 1) / 2
        sum_x, sum_y = self.sums(of_x), self.sums(lengths * y)

        def covariance(products: npt.NDArray[np.float64], sum_a: Any, sum_b: Any) -> Any:
            return (self.sums(products) - sum_a * sum_b / self.areas) / self.areas

        return (covariance(squares[1] - squares[0], sum_x, sum_x), covariance(lengths * y**2, sum_y, sum_y),
                covariance(of_x * y, sum_x, sum_y))

    @cached_property
    def eigenvalues(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """The variances along the longer and the shorter axis."""
        of_x, of_y, of_both = self.variances
        middle, half = (of_x + of_y) / 2, np.hypot((of_x - of_y) / 2, of_both)
        return middle + half, np.maximum(middle - half, 0)

    @property
    def orientations(self) -> npt.NDArray[np.float64]:
        """Of the longer axis, from that of the rows."""
        of_x, of_y, of_both = self.variances
        return np.where(of_x == of_y, np.where(of_both > 0, -np.pi / 4, np.pi / 4),
                        np.arctan2(2 * of_both, of_y - of_x) / 2)


def measured(labels: npt.NDArray[Any], intensities: npt.NDArray[Any] | None, properties: Sequence[str],
             separator: str, original: str) -> dict[str, npt.NDArray[Any]]:
    """A column for each property, or several, as scikit-image names them."""
    known = [_OLD_NAMES.get(name, name) for name in properties]
    for name, given in zip(known, properties):
        if name not in _PARTS:
            raise NotImplementedError(f"properties: expected {', '.join(_PARTS)}; got {given!r}; use {original}")
        if name in _OF_INTENSITIES and intensities is None:
            raise ValueError(f"intensity_image: expected an array for {given!r}, got None")
    runs = _Runs(labels)
    table: dict[str, npt.NDArray[Any]] = {}
    for name, given in zip(known, properties):
        names = [separator.join((given, *part)) for part in _PARTS[name]]
        columns = (_columns(labels, intensities, runs, name) if len(runs.values)
                   else [np.empty(0, np.intp if name in _WHOLE else float)] * len(names))
        table.update(zip(names, columns))
    return table


def _columns(labels: npt.NDArray[Any], intensities: Any, runs: _Runs, name: str) -> Sequence[npt.NDArray[Any]]:
    """The columns of a property."""
    areas = runs.areas
    match name:
        case "label":
            return [runs.values.astype(np.intp)]
        case "area":
            return [areas]
        case "area_bbox":
            return [runs.box_areas]
        case "area_filled":
            return [_filled_areas(labels, runs)]
        case "bbox":
            return runs.boxes
        case "extent":
            return [areas / runs.box_areas]
        case "equivalent_diameter_area":
            return [np.sqrt(4 * areas / np.pi)]
        case "euler_number":
            return [runs.euler_numbers]
        case "centroid":
            lengths = runs.ends - runs.begins
            columns = runs.sums(lengths * (runs.begins + runs.ends - 1) // 2)
            return [runs.sums(lengths * runs.rows) / areas, columns / areas]
        case "inertia_tensor":
            of_x, of_y, of_both = runs.variances
            return [of_x, -of_both, -of_both, of_y]
        case "orientation":
            return [runs.orientations]
        case "perimeter":
            return [_perimeters(labels, runs)]
    if name in _OF_INTENSITIES:
        return _of_intensities(intensities, runs, name)
    longer, shorter = runs.eigenvalues
    if name == "inertia_tensor_eigvals":
        return [longer, shorter]
    if name == "eccentricity":
        return [np.sqrt(1 - np.divide(shorter, longer, out=np.ones_like(longer), where=longer > 0))]
    return [4 * np.sqrt(longer if name == "axis_major_length" else shorter)]


def _of_intensities(intensities: npt.NDArray[Any], runs: _Runs, name: str) -> list[npt.NDArray[Any]]:
    if name == "intensity_max":
        return [runs.of_pixels(intensities, np.maximum.reduceat)]
    if name == "intensity_min":
        return [runs.of_pixels(intensities, np.minimum.reduceat)]
    total = runs.of_pixels(intensities)
    if name == "intensity_mean":
        return [total / runs.areas]
    height, width = intensities.shape
    return [runs.of_pixels(intensities * axis) / total
            for axis in (np.arange(height, dtype=float)[:, None], np.arange(width, dtype=float))]


def _perimeters(labels: npt.NDArray[Any], runs: _Runs) -> npt.NDArray[np.float64]:
    """The length of a line through the pixels that have another value beside them, by the kinds of neighbours on it.

    K. Benkrid and D. Crookes, "Design and FPGA implementation of a perimeter estimator", 2000."""
    sides, diagonals = ((0, 1), (1, 0), (1, 2), (2, 1)), ((0, 0), (0, 2), (2, 0), (2, 2))
    height, width = labels.shape

    def equal(image: npt.NDArray[Any], places: Sequence[tuple[int, int]]) -> Any:
        padded = np.pad(image, 1)
        return sum((padded[y:y + height, x:x + width] == image).astype(np.uint8) for y, x in places)

    line = np.where(equal(labels, sides) < 4, labels, 0)
    on_line = line > 0
    kinds = _STEP_KINDS[equal(line, sides)[on_line], equal(line, diagonals)[on_line]]
    owners = np.searchsorted(runs.values, line[on_line])
    straight, diagonal, both = (np.bincount(owners[kinds == kind], minlength=len(runs.values)) for kind in (1, 2, 3))
    lengths: npt.NDArray[np.float64] = straight + np.sqrt(2) * diagonal + (1 + np.sqrt(2)) / 2 * both
    return lengths


def _filled_areas(labels: npt.NDArray[Any], runs: _Runs) -> _Integers:
    """With all holes, which are 8-connected."""
    areas = runs.areas.copy()
    tops, lefts, bottoms, rights = runs.boxes
    for i in np.flatnonzero((areas >= _MIN_CLOSED_AREA) & (areas < runs.box_areas)):
        part = labels[tops[i]:bottoms[i], lefts[i]:rights[i]]
        filled = _images.fill_holes(part == runs.values[i], connectivity=4)
        areas[i] = np.count_nonzero(filled)
    return areas
