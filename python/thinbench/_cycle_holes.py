"""Which holes the cycles of a graph enclose."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _images

Array = npt.NDArray[Any]
Place = tuple[int, int]
FORWARD = ((0, 1), (1, 0), (1, 1), (1, -1))
STEPS = ((-1, 0), (0, -1), (0, 1), (1, 0), (-1, -1), (-1, 1), (1, -1), (1, 1))
NO_LABEL = np.iinfo(np.int64).min


class CycleHoles:
    """Of a graph with these pixels, each with its label. Memory is that of the pixels, not of the image."""

    def __init__(self, pixels: Array, labels: Array) -> None:
        self._labels = _Labels(pixels, labels)
        self._holes = _holes_of_labels(pixels, labels)
        self._nodes: dict[int, _Node] = {}

    def in_curve(self, curve: Array, label: int) -> Array:
        """The holes of a label inside a closed curve."""
        holes = self._holes[label]
        return holes[_inside(curve, holes)]

    def in_next_loop(self, number: int, pixels: Array, label: int) -> Array:
        """The holes inside the next loop of a node whose pixels enclose it; each call, one loop."""
        return self._node(number, pixels).next_loop(self._holes[label])

    def way(self, number: int, pixels: Array, start: Array, stop: Array) -> Array:
        """Pixels of a node that lead from one to another, both left out, each joined with the next."""
        return self._node(number, pixels).way((int(start[0]), int(start[1])), (int(stop[0]), int(stop[1])))

    def _node(self, number: int, pixels: Array) -> _Node:
        if number not in self._nodes:
            self._nodes[number] = _Node(pixels.astype(np.int64), self._labels)
        return self._nodes[number]


class _Labels:
    """The labels of pixels at some places, looked up by bisection."""

    def __init__(self, pixels: Array, labels: Array) -> None:
        self._stride = int(pixels[:, 1].max(initial=0)) + 3
        keys = self._keys(pixels)
        order = np.argsort(keys, kind="stable")
        self._known, self._values = keys[order], labels[order]

    def _keys(self, places: Array) -> Array:
        keys: Array = (places[:, 0] + 1) * self._stride + places[:, 1] + 1
        return keys

    def at(self, places: Array) -> Array:
        """NO_LABEL where no pixel is; places may lie one row or column outside the pixels."""
        keys = self._keys(places)
        found = np.searchsorted(self._known, keys).clip(max=len(self._known) - 1)
        return np.where(self._known[found] == keys, self._values[found], NO_LABEL)


class _Node:
    """The pixels of a node, and which of them are joined."""

    def __init__(self, pixels: Array, labels: _Labels) -> None:
        self._pixels = pixels
        self._labels = labels
        self._origin = pixels.min(axis=0)
        self._is_pixel = np.zeros(pixels.max(axis=0) - self._origin + 3, bool)
        self._is_pixel[tuple((pixels - self._origin + 1).T)] = True
        self._joined: dict[Place, list[Place]] = {}
        self._loops: Iterator[Array] | None = None

    def way(self, start: Place, stop: Place) -> Array:
        joined = self._joined = self._joined or self._joined_pixels()
        before = {stop: stop}
        reached = [stop]  # grows; from the end, so that the way leads forwards
        for place in reached:
            if start in before:
                break
            for neighbour in joined[place]:
                if neighbour not in before:
                    before[neighbour] = place
                    reached.append(neighbour)
        way = []
        place = before.get(start, stop)
        while place != stop:
            way.append(place)
            place = before[place]
        return np.array(way, np.int64).reshape(-1, 2)

    def next_loop(self, points: Array) -> Array:
        """Of points, the same in every call, those in the next loop of joined pixels."""
        self._loops = self._loops or iter(self._in_loops(points))
        return next(self._loops, points[:0])

    def _in_loops(self, points: Array) -> list[Array]:
        loops, count = self._numbered_loops()
        places = 2 * (points - self._origin) + 1
        within = ((places >= 0) & (places < loops.shape)).all(axis=1)
        points, numbers = points[within], loops[tuple(places[within].T)]
        order = np.argsort(numbers, kind="stable")
        return np.split(points[order], np.searchsorted(numbers[order], np.arange(1, count + 1)))[1:]

    def _numbered_loops(self) -> tuple[Array, int]:
        """On a grid twice as fine, where joined pixels and what lies between two or four of them enclose loops:
        the number of each, from 1, and 0 elsewhere; and their number."""
        at = 2 * (self._pixels - self._origin) + 1
        background = np.ones(at.max(axis=0) + 2, bool)
        background[tuple(at.T)] = False
        for step in FORWARD:
            between = self._is_joined(step) | self._is_in_block(step)
            background[tuple((at + step)[between].T)] = False
        labels, _ = _images.label_image(background, connectivity=4)
        labels[labels == labels[0, 0]] = 0
        found, numbers = np.unique(np.append(labels, 0), return_inverse=True)
        return numbers[:-1].reshape(labels.shape), len(found) - 1

    def _joined_pixels(self) -> dict[Place, list[Place]]:
        joined: dict[Place, list[Place]] = {(row, column): [] for row, column in self._pixels.tolist()}
        for step in STEPS:
            for row, column in self._pixels[self._is_joined(step)].tolist():
                joined[row, column].append((row + step[0], column + step[1]))
        return joined

    def _is_joined(self, step: Place) -> Array:
        """Which pixels are joined with the one a step away: a diagonal one if no pixel of their label is beside it."""
        joined = self._has_pixel(step)
        if 0 not in step:
            joined &= ~(self._has_label((step[0], 0)) | self._has_label((0, step[1])))
        return joined

    def _is_in_block(self, step: Place) -> Array:
        """Which pixels have a diagonal neighbour in the node, and both pixels beside it."""
        if 0 in step:
            return np.zeros(len(self._pixels), bool)
        return self._has_pixel(step) & self._has_label((step[0], 0)) & self._has_label((0, step[1]))

    def _has_pixel(self, step: Place) -> Array:
        is_pixel: Array = self._is_pixel[tuple((self._pixels - self._origin + 1 + step).T)]
        return is_pixel

    def _has_label(self, step: Place) -> Array:
        has_label: Array = self._labels.at(self._pixels + step) == self._labels.at(self._pixels)
        return has_label


def _holes_of_labels(pixels: Array, labels: Array) -> dict[int, Array]:
    """The first pixels of the holes of each label."""
    order = np.argsort(labels, kind="stable")
    numbers, starts = np.unique(labels[order], return_index=True)
    return {int(number): _holes_of(part) for number, part in zip(numbers, np.split(pixels[order], starts[1:]))}


def _holes_of(pixels: Array) -> Array:
    """The first pixel of each hole: of what 4-connected background leaves inside a margin of one."""
    origin = pixels.min(axis=0)
    background = np.ones(pixels.max(axis=0) - origin + 3, bool)
    background[tuple((pixels - origin + 1).T)] = False
    labels, _ = _images.label_image(background, connectivity=4)
    numbers, first = np.unique(labels, return_index=True)
    places: Array = np.stack(np.unravel_index(first, labels.shape), axis=-1) + origin - 1
    holes: Array = places[(numbers != 0) & (numbers != labels[0, 0])]
    return holes


def _inside(polygon: Array, points: Array) -> Array:
    """Which points are inside a closed polygon: those with an odd number of sides to their right."""
    first, last = polygon, np.roll(polygon, -1, axis=0)
    odd = np.zeros(len(points), bool)
    near = ((points >= polygon.min(axis=0)) & (points <= polygon.max(axis=0))).all(axis=1)
    for i in np.flatnonzero(near):
        row, column = points[i] + 1e-9  # beside the centre, where sides meet
        crosses = (first[:, 0] > row) != (last[:, 0] > row)
        a, b = first[crosses], last[crosses]
        at = a[:, 1] + (row - a[:, 0]) * (b[:, 1] - a[:, 1]) / (b[:, 0] - a[:, 0])
        odd[i] = np.count_nonzero(at > column) % 2 == 1
    return odd
