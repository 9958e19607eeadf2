"""Objects and holes of dask arrays: components of chunks, joined across chunks.

Every pixel of a chunk belongs to a component: 8-connected foreground or 4-connected background. The
outermost lines of pixels of all chunks say which components are one. Background components that do
not touch the image border are holes.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import dask
import numpy as np
import numpy.typing as npt

import thinbench
from thinbench import _arrays, _images
from thinbench._dask_thinning import array_of, with_chunks_of_at_least

Array = npt.NDArray[Any]

_REDUCTIONS: dict[str, Any] = {
    "area": np.add, "sum_x": np.add, "sum_y": np.add, "left": np.minimum, "top": np.minimum,
    "right": np.maximum, "bottom": np.maximum}


class Part(NamedTuple):
    """The components of a chunk; labels count from 1, those of the foreground first."""

    components: Array  # REGION, with coordinates in the whole image
    objects: int
    first: Array  # of each component: index of its first pixel in the whole image
    above: Array  # label of the pixel above the first pixel; 0 where that is in another chunk
    top: Array  # labels of the outermost lines of pixels
    bottom: Array
    left: Array
    right: Array


class Line(NamedTuple):
    """Components along a whole row or column of pixels, as indices into the list of all."""

    components: Array
    is_object: Array


def label_regions(array: Any) -> tuple[Any, _images.Columns]:
    """As thinbench.dask.label_regions, for a checked array."""
    if array.size == 0:
        return array.astype(np.int32), _images.columns(_images.Regions(np.empty(0, _images.REGION), 0))
    chunked = with_chunks_of_at_least(array, 1)
    blocks = chunked.to_delayed()
    parts = _computed_parts(blocks, chunked.chunks, array.shape[1])
    table, labels = _joined(parts, array.shape)
    tasks = {index: (_relabelled, block.key, labels[index])
             for index, block in np.ndenumerate(blocks)}
    return array_of(tasks, blocks, chunked.chunks, np.int32).rechunk(array.chunks), table


def _computed_parts(blocks: Array, chunks: Any, width: int) -> Array:
    """The part of each block."""
    tops, lefts = (np.cumsum((0, *sizes)) for sizes in chunks)
    tasks = [dask.delayed(_part, pure=False)(block, int(tops[i]), int(lefts[j]), width)
             for (i, j), block in np.ndenumerate(blocks)]
    parts = np.empty(len(tasks), object)
    for index, part in enumerate(dask.compute(*tasks)):
        parts[index] = part
    return parts.reshape(blocks.shape)


def _labelled(block: Array) -> tuple[Array, int, Array]:
    """Components, how many are foreground, and labels of all pixels."""
    block = _arrays.binary(block)  # in rows: that of a constant dask array is one pixel, repeated
    (found, objects), labels = _images.regions_and_labels(block)
    # In a frame of foreground every component of the background is a hole.
    framed = np.pad(block, 1, constant_values=1)
    (framed_found, framed_objects), framed_labels = _images.regions_and_labels(framed)
    background = framed_found[framed_objects:].copy()
    for name in ("left", "top", "right", "bottom"):
        background[name] -= 1
    for name in ("sum_x", "sum_y"):
        background[name] -= background["area"]
    inside = framed_labels[1:-1, 1:-1] + np.int32(objects - framed_objects)
    return (np.concatenate([found[:objects], background]), objects,
            np.where(block, labels, inside))


def _first_pixels(labels: Array, count: int) -> Array:
    """The index of the first pixel of each component."""
    starts = np.ones(labels.shape, bool)
    starts[:, 1:] = labels[:, 1:] != labels[:, :-1]
    found = np.flatnonzero(starts)[::-1]
    first = np.empty(count + 1, np.int64)
    first[labels.ravel()[found]] = found  # the last assignment, to the first pixel, remains
    return first[1:]


def _part(block: Array, top: int, left: int, image_width: int) -> Part:
    components, objects, labels = _labelled(block)
    y, x = np.divmod(_first_pixels(labels, len(components)), block.shape[1])
    above = np.where(y > 0, labels[y - 1, x], 0)
    for name, offset in (("x", left), ("y", top)):
        components["sum_" + name] += offset * components["area"]
    for name, offset in (("left", left), ("right", left), ("top", top), ("bottom", top)):
        components[name] += offset
    return Part(components, objects, (y + top) * image_width + x + left, above,
                labels[0].copy(), labels[-1].copy(), labels[:, 0].copy(), labels[:, -1].copy())


def _relabelled(block: Array, labels: Array) -> Array:
    result: Array = labels[_labelled(block)[2]]
    return result


def _joined(parts: Array, shape: tuple[int, int]) -> tuple[_images.Columns, Array]:
    """The table of regions, and for each chunk the label of each of its components."""
    counts = np.array([len(part.components) for part in parts.flat])
    offsets = np.cumsum(np.append(0, counts))
    starts = offsets[:-1].reshape(parts.shape)
    components = np.concatenate([part.components for part in parts.flat])
    is_object = np.concatenate([np.arange(count) < part.objects
                                for part, count in zip(parts.flat, counts)])
    lines = _Lines(parts, starts, is_object)
    roots = _roots(len(components), lines.pairs())
    touches_border = np.zeros(len(components), bool)
    touches_border[lines.border()] = True
    first = np.concatenate([part.first for part in parts.flat])
    label_of, regions = _merged(components, roots, first, is_object, touches_border,
                                lines.above(first, shape[1]))
    labels = np.empty(parts.shape, object)
    for (index, part), start in zip(np.ndenumerate(parts), offsets):
        labels[index] = np.append(0, label_of[start:start + len(part.components)]).astype(np.int32)
    return _images.columns(regions), labels


class _Lines:
    """The outermost lines of pixels of chunks, along the whole width or height of the image."""

    def __init__(self, parts: Array, starts: Array, is_object: Array) -> None:
        self._parts, self._starts, self._is_object = parts, starts, is_object

    def _line(self, parts: Array, starts: Array, side: str) -> Line:
        components = np.concatenate([getattr(part, side) - 1 + start
                                     for part, start in zip(parts, starts)])
        return Line(components, self._is_object[components])

    def row(self, i: int, side: str) -> Line:
        return self._line(self._parts[i], self._starts[i], side)

    def column(self, j: int, side: str) -> Line:
        return self._line(self._parts[:, j], self._starts[:, j], side)

    def border(self) -> Array:
        """Components that touch the border of the image."""
        return np.concatenate([self.row(0, "top").components, self.row(-1, "bottom").components,
                               self.column(0, "left").components,
                               self.column(-1, "right").components])

    def pairs(self) -> Array:
        """Components that are neighbours across chunks."""
        rows, columns = self._parts.shape
        found = [np.empty((0, 2), np.int64)]
        for i in range(rows - 1):
            found += _neighbours(self.row(i, "bottom"), self.row(i + 1, "top"))
        for j in range(columns - 1):
            found += _neighbours(self.column(j, "right"), self.column(j + 1, "left"))
        return np.unique(np.concatenate(found), axis=0)

    def above(self, first: Array, width: int) -> Array:
        """For each component the one above its first pixel; -1 at the top of the image."""
        above = np.concatenate([np.where(part.above > 0, part.above - 1 + start, -1)
                                for part, start in zip(self._parts.flat, self._starts.flat)])
        for i in range(1, len(self._parts)):
            line = self.row(i - 1, "bottom").components
            row = slice(self._starts[i, 0], self._starts[i + 1, 0] if i + 1 < len(self._parts)
                        else len(first))
            above[row] = np.where(above[row] < 0, line[first[row] % width], above[row])
        result: Array = above
        return result


def _neighbours(one: Line, other: Line) -> list[Array]:
    """Pairs of 8-connected objects and of 4-connected background on adjacent lines."""
    found = []
    for shift in (-1, 0, 1):
        a = slice(max(shift, 0), len(one.components) + min(shift, 0))
        b = slice(max(-shift, 0), len(one.components) + min(-shift, 0))
        joined = one.is_object[a] & other.is_object[b]
        if shift == 0:
            joined |= ~one.is_object & ~other.is_object
        pairs = np.stack([one.components[a][joined], other.components[b][joined]], axis=1)
        found.append(np.unique(pairs, axis=0))
    return found


def _roots(count: int, pairs: Array) -> Array:
    """For each of `count` nodes a number that all nodes connected by pairs share."""
    root = np.arange(count)
    while True:
        ends = root[pairs]
        ends = ends[ends[:, 0] != ends[:, 1]]
        if len(ends) == 0:
            return root
        np.minimum.at(root, ends.max(axis=1), ends.min(axis=1))
        while not np.array_equal(root, root[root]):
            root = root[root]


def _merged(components: Array, roots: Array, first: Array, is_object: Array,
            touches_border: Array, above: Array) -> tuple[Array, _images.Regions]:
    """For each component the label of its region, 0 outside; and the regions."""
    order = np.lexsort((first, roots))  # the first member of each group is the topmost
    is_start = np.append(True, np.diff(roots[order]) != 0)
    starts = np.flatnonzero(is_start)
    group = np.empty(len(roots), np.int64)
    group[order] = np.cumsum(is_start) - 1
    found = np.empty(len(starts), _images.REGION)
    for name, reduce in _REDUCTIONS.items():
        found[name] = reduce.reduceat(components[name][order], starts)
    leader = order[starts]
    outside = ~is_object[leader] & np.logical_or.reduceat(touches_border[order], starts)
    rank = np.lexsort((first[leader], ~is_object[leader], outside))
    label = np.empty(len(starts), np.int64)
    label[rank] = np.arange(1, len(starts) + 1)
    label[outside] = 0
    found["enclosing_object"] = np.where(is_object[leader], 0, label[group[above[leader]]])
    kept = rank[:len(starts) - np.count_nonzero(outside)]
    return label[group], _images.Regions(found[kept], int(np.count_nonzero(is_object[leader])))


def without_small_holes(block: npt.NDArray[Any], max_size: int) -> npt.NDArray[Any]:
    """The block with its holes of at most this many rows and columns filled."""
    if block.size == 0:
        return block
    labels, table = thinbench.label_regions(block)
    is_filled = np.zeros(len(table["label"]) + 1, bool)
    height, width = table["bbox-2"] - table["bbox-0"], table["bbox-3"] - table["bbox-1"]
    is_filled[1:] = ~table["is_hole"] | (height <= max_size) & (width <= max_size)
    return is_filled[labels] if block.dtype == bool else is_filled[labels] * np.uint8(255)


def near_distances(block: npt.NDArray[Any], max_distance: float) -> npt.NDArray[np.float64]:
    """The distances of the block, infinite where they are greater."""
    distances = thinbench.distances(block)
    distances[distances > max_distance] = np.inf
    return distances
