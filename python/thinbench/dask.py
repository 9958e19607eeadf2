"""Thinning and regions of dask arrays, equal to the result in memory, bit for bit.

A sub-iteration reads neighbours one pixel away, two in "mb2". So the effect of what is outside a
chunk advances by a known number of pixels per iteration, and a chunk that is thinned with a halo
deep enough is exact in its interior.
"""

from __future__ import annotations

import os
import uuid
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import thinbench
from thinbench import _arrays
from thinbench._thinning import RULES, check_options

try:
    import dask
    import dask.array as da
    from dask.delayed import Delayed
    from dask.highlevelgraph import HighLevelGraph
except ImportError as error:
    raise ImportError("thinbench.dask needs dask: install python3-dask (Debian) or dask[array] "
                      "(pip)") from error

__all__ = ["SPREAD", "regions", "thin"]

SPREAD = {
    "naccache_shinghal": 1,
    "zhang_suen": 2,
    "zhang_suen_skimage": 2,
    "guo_hall": 2,
    "guo_hall_skimage": 2,
    "lu_wang": 2,
    "spta_directional": 4,
    "mb2": 2,
    "net_two_layer_sigmoid": 1,
    "net_two_layer_rounded": 1,
    "net_two_layer_linear": 1,
    "net_single_layer_cluster": 1,
}
"""Rules that `thin` supports: how many pixels the effect of a pixel advances in an iteration."""


_DIRECTIONS = [(y, x) for y in (-1, 0, 1) for x in (-1, 0, 1) if (y, x) != (0, 0)]


def thin(array: Any, rule: str = "guo_hall", *, border: str = "background",
         max_iterations: int | None = None, depth: int = 64, out: Any = None) -> Any:
    """Thin a binary image that is a dask array.

    Without `max_iterations` this computes: chunks are thinned with halos, in rounds, until no
    chunk changes. One round suffices where every chunk comes to rest before its halo is used up.
    Chunks at rest among chunks at rest are skipped.

    Parameters
    ----------
    array : dask array of bool or uint8, shape (H, W)
        Nonzero is foreground. Chunks of any size; those smaller than the halo are merged for the
        computation.
    rule : str
        A key of `SPREAD`. The effect of a pixel has no bound in sequential rules ("spta") and in
        "midpoint_scan".
    border : {"background", "keep"}
        As in `thinbench.thin`; "keep" refers to the border of the whole image.
    max_iterations : int, optional
        Stop after this many iterations, at least 1. The halo then covers them all, and the result
        is lazy. Default: until nothing changes.
    depth : int
        Width of the halos without `max_iterations`, in pixels. More depth, fewer rounds.
    out : zarr array, or path of a new one, optional
        Receives the result, chunk by chunk, after the last round. Must not be the source. A path
        is local and appears when the array is complete.

    Returns
    -------
    dask array of the shape, dtype and chunks of `array`
        True or 255 on skeletons, else 0: lazy with `max_iterations` and where one chunk suffices,
        else persisted. With `out`, that array.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit; then nothing is computed.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> bars = da.ones((9, 300), dtype=bool, chunks=(9, 100))
    >>> skeleton = thinbench.dask.thin(bars)
    >>> skeleton.chunks, int(skeleton.sum().compute())
    (((9,), (100, 100, 100)), 292)
    """
    check_image(array)
    spread = _spread(rule)
    check_options(border, max_iterations, 1)
    if _arrays.integer("depth", depth) < spread:
        raise ValueError(f"depth: expected at least {spread}, the pixels that {rule!r} advances in "
                         f"an iteration, got {depth}")
    _check_out(out, array)
    if max_iterations is None:
        result = _until_at_rest(array, rule, border, depth, depth // spread)
    else:
        result = _limited(array, rule, border, max_iterations, max_iterations * spread)
    result = result.rechunk(array.chunks)
    return result if out is None else _stored(result, out)


def regions(array: Any, return_labels: bool = False) -> Any:
    """Find objects and holes of a binary image that is a dask array.

    Chunks are labelled one by one, and their components joined across chunks. This computes.

    Parameters
    ----------
    array : dask array of bool or uint8, shape (H, W)
        Nonzero is foreground. Chunks of any size.
    return_labels : bool
        Also return an image of labels.

    Returns
    -------
    dict of arrays, or a tuple of that and a dask array of int32, shape (H, W)
        As `thinbench.regions`. The dict is in memory: a row for each object and each hole. The
        image of labels is lazy.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> ring = da.ones((6, 6), dtype=bool, chunks=4)
    >>> ring[1:5, 1:5] = False
    >>> table = thinbench.dask.regions(ring)
    >>> print(table["area"], table["is_hole"], table["parent"])
    [20 16] [False  True] [0 1]
    """
    from thinbench import _dask_regions  # imports this module

    check_image(array)
    return _dask_regions.regions(array, return_labels)


def check_image(array: Any) -> None:
    """Rejects what is not a dask array of a binary image with known chunks."""
    if not isinstance(array, da.Array):
        raise TypeError(f"array: expected a dask array, got {type(array).__name__}")
    _arrays.binary(np.empty((0,) * array.ndim, array.dtype))
    if any(np.isnan(size) for sizes in array.chunks for size in sizes):
        raise ValueError(f"array: expected chunks of known size, got {array.chunks}; "
                         "`array.compute_chunk_sizes()` finds them")


def _spread(rule: str) -> int:
    _arrays.one_of("rule", rule, RULES)
    spread = SPREAD.get(rule)
    if spread is None:
        raise ValueError(f"rule: {rule!r} has no bound for the effect of a pixel, so chunks cannot "
                         f"be exact; expected one of {', '.join(SPREAD)}")
    return spread


def merged(sizes: tuple[int, ...], minimum: int) -> tuple[int, ...]:
    """Chunk sizes of at least `minimum`, or one for all."""
    found = [0]
    for size in sizes:
        if found[-1] >= minimum:
            found.append(0)
        found[-1] += size
    if found[-1] < minimum and len(found) > 1:
        last = found.pop()
        found[-1] += last
    return tuple(found)


def _with_chunks_of_at_least(array: Any, minimum: int) -> Any:
    return array.rechunk(tuple(merged(sizes, minimum) for sizes in array.chunks))


def array_of(tasks: dict[tuple[int, ...], Any], blocks: npt.NDArray[Any], chunks: Any,
             dtype: Any) -> Any:
    """The array whose chunks are given by tasks that read delayed blocks."""
    name = "thinbench-" + uuid.uuid4().hex
    graph = {(name, *index): task for index, task in tasks.items()} | _graph_of(blocks.ravel())
    return da.Array(HighLevelGraph.from_collections(name, graph), name, chunks, dtype=dtype)


def _graph_of(blocks: npt.NDArray[Any]) -> dict[Any, Any]:
    """One graph for all, whose layers would take longer to combine than to compute."""
    graphs = {id(graph): graph for graph in (block.__dask_graph__() for block in blocks)}
    return {key: task for graph in graphs.values() for key, task in graph.items()}


def _thin_block(block: npt.NDArray[Any], **options: Any) -> npt.NDArray[Any]:
    result: npt.NDArray[Any] = thinbench.thin(block, **options)
    return result


def _limited(array: Any, rule: str, border: str, max_iterations: int, depth: int) -> Any:
    array = _with_chunks_of_at_least(array, depth)
    halo = {axis: depth if count > 1 else 0 for axis, count in enumerate(array.numblocks)}
    return da.map_overlap(_thin_block, array, depth=halo, boundary="none", dtype=array.dtype,
                          meta=np.empty((0, 0), array.dtype), rule=rule, border=border,
                          max_iterations=max_iterations)


def _until_at_rest(array: Any, rule: str, border: str, depth: int, iterations: int) -> Any:
    array = _with_chunks_of_at_least(array, depth)
    if array.npartitions == 1:
        return array.map_blocks(_thin_block, dtype=array.dtype, rule=rule, border=border)
    blocks = array.to_delayed()
    active = np.ones(blocks.shape, bool)
    while active.any():
        changed, at_rest = _run_round(blocks, active, depth, rule, border, iterations)
        active = _with_neighbours(changed & ~at_rest.all())
    keys = {index: block.key for index, block in np.ndenumerate(blocks)}
    return array_of(keys, blocks, array.chunks, array.dtype)


def _run_round(blocks: npt.NDArray[Any], active: npt.NDArray[np.bool_], depth: int, rule: str,
               border: str, iterations: int) -> tuple[npt.NDArray[np.bool_], npt.NDArray[np.bool_]]:
    """Replaces the active blocks; returns which have changed and which were at rest at the end."""
    name = "thinbench-round-" + uuid.uuid4().hex
    indices = [(int(i), int(j)) for i, j in np.argwhere(active)]
    used = _with_neighbours(active)
    graph = _graph_of(blocks[used])
    for i, j in np.argwhere(used):
        graph["edges-" + name, int(i), int(j)] = (_edges, blocks[i, j].key, depth)
    for i, j in indices:
        neighbours = _neighbours(i, j, blocks.shape)
        edges = [("edges-" + name, i + y, j + x) for y, x in neighbours]
        graph[name, i, j] = (_advance, blocks[i, j].key, neighbours, edges, depth, rule, border,
                             iterations)
        graph["block-" + name, i, j] = (itemgetter(0), (name, i, j))
        graph["state-" + name, i, j] = (itemgetter(1), (name, i, j))
    layer = HighLevelGraph.from_collections(name, graph)
    persisted = dask.persist(*[Delayed((part + name, *index), layer, layer=name)
                               for part in ("block-", "state-") for index in indices])
    states = dask.compute(*persisted[len(indices):])
    changed, at_rest = np.zeros(active.shape, bool), np.ones(active.shape, bool)
    for index, block, state in zip(indices, persisted, states):
        blocks[index] = block
        changed[index], at_rest[index] = state
    return changed, at_rest


def _with_neighbours(chunks: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """Also the eight neighbours of each chunk: what reads a chunk that has changed."""
    rows = chunks.copy()
    rows[1:] |= chunks[:-1]
    rows[:-1] |= chunks[1:]
    result = rows.copy()
    result[:, 1:] |= rows[:, :-1]
    result[:, :-1] |= rows[:, 1:]
    return result


def _neighbours(i: int, j: int, shape: tuple[int, ...]) -> list[tuple[int, int]]:
    """The directions in which a block has neighbours."""
    return [(y, x) for y, x in _DIRECTIONS if 0 <= i + y < shape[0] and 0 <= j + x < shape[1]]


def _edges(block: npt.NDArray[Any], depth: int) -> dict[tuple[int, int], npt.NDArray[Any]]:
    """What the neighbour of a block in each direction reads of it.

    One task for all is faster than eight; copies, as views would keep the block in memory.
    """
    ends = {-1: slice(depth), 0: slice(None), 1: slice(-depth, None)}
    return {(y, x): block[ends[y], ends[x]].copy() for y, x in _DIRECTIONS}


def _advance(block: npt.NDArray[Any], neighbours: list[tuple[int, int]],
             edges: list[dict[tuple[int, int], npt.NDArray[Any]]], depth: int, rule: str,
             border: str, iterations: int) -> tuple[npt.NDArray[Any], tuple[bool, bool]]:
    """Thins a block with its halo; also returns whether it has changed and whether it was at rest.

    At rest: the last iteration changed nothing in the block, as an iteration before had changed
    nothing anywhere, or as no iteration changed the block: rules only remove pixels.
    """
    pieces = {(y, x): edge[-y, -x] for (y, x), edge in zip(neighbours, edges)}
    pieces[0, 0] = block
    image = np.block([[pieces[y, x] for x in (-1, 0, 1) if (y, x) in pieces]
                      for y in (-1, 0, 1) if (y, 0) in pieces])
    inside = tuple(slice(depth * (before in pieces), depth * (before in pieces) + size)
                   for before, size in zip(((-1, 0), (0, -1)), block.shape))
    thinned, used = thinbench.thin(image, rule, border=border, max_iterations=iterations,
                                   return_iterations=True)
    result = thinned[inside].copy()
    changed = np.count_nonzero(result) != np.count_nonzero(block)
    return result, (changed, used < iterations or not changed)


def _check_out(out: Any, array: Any) -> None:
    if out is None:
        return
    if isinstance(out, (str, os.PathLike)):
        if os.path.exists(out):
            raise ValueError(f"out: expected a new path or a zarr array, but {os.fspath(out)!r} "
                             "exists")
        return
    if not (hasattr(out, "store") and hasattr(out, "chunks")):
        raise TypeError(f"out: expected a zarr array or a path, got {type(out).__name__}")
    if out.shape != array.shape or out.dtype != array.dtype:
        raise ValueError(f"out: expected {array.dtype} of shape {array.shape}, "
                         f"got {out.dtype} of shape {out.shape}")


def _stored(result: Any, out: Any) -> Any:
    """Writes to a zarr array, whose chunks no two tasks share, and returns it."""
    if not isinstance(out, (str, os.PathLike)):
        da.to_zarr(result, out)
        return da.from_zarr(out)
    path = Path(out)
    part = path.with_name(path.name + ".part")
    uniform = result.rechunk(tuple(max(sizes) for sizes in result.chunks))
    da.to_zarr(uniform, str(part), overwrite=True)
    part.rename(path)
    return da.from_zarr(str(path))
