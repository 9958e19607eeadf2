"""Thinning of dask arrays in rounds: each thins chunks with halos that their neighbours provide."""

from __future__ import annotations

import uuid
from operator import itemgetter
from typing import Any

import dask
import dask.array as da
import numpy as np
import numpy.typing as npt
from dask.delayed import Delayed
from dask.highlevelgraph import HighLevelGraph

import thinbench
from thinbench import Rule, _library

_DIRECTIONS = [(y, x) for y in (-1, 0, 1) for x in (-1, 0, 1) if (y, x) != (0, 0)]


def _merged(sizes: tuple[int, ...], minimum: int) -> tuple[int, ...]:
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


def with_chunks_of_at_least(array: Any, minimum: int) -> Any:
    return array.rechunk(tuple(_merged(sizes, minimum) for sizes in array.chunks))


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


def with_halo(array: Any, compute: Any, depth: int, dtype: Any, **options: Any) -> Any:
    """Lazily what `compute` makes of chunks with a halo from their neighbours."""
    wide = with_chunks_of_at_least(array, depth)
    halo = {axis: depth if count > 1 else 0 for axis, count in enumerate(wide.numblocks)}
    result = da.map_overlap(compute, wide, depth=halo, boundary="none", dtype=dtype,
                            meta=np.empty((0, 0), dtype), **options)
    return result.rechunk(array.chunks)


def limited(array: Any, rule: Rule, border: str | None, max_iterations: int, depth: int) -> Any:
    return with_halo(array, _thin_block, depth, array.dtype, rule=rule, border=border, max_iterations=max_iterations)


def until_at_rest(array: Any, rule: Rule, border: str | None, depth: int, iterations: int) -> Any:
    array = with_chunks_of_at_least(array, depth)
    if array.npartitions == 1:
        return array.map_blocks(_thin_block, dtype=array.dtype, rule=rule, border=border,
                                max_iterations=_library.UNLIMITED)
    blocks = array.to_delayed()
    active = np.ones(blocks.shape, bool)
    while active.any():
        changed, at_rest = _run_round(blocks, active, depth, rule, border, iterations)
        active = _with_neighbours(changed & ~at_rest.all())
    keys = {index: block.key for index, block in np.ndenumerate(blocks)}
    return array_of(keys, blocks, array.chunks, array.dtype)


def _run_round(blocks: npt.NDArray[Any], active: npt.NDArray[np.bool_], depth: int, rule: Rule,
               border: str | None, iterations: int) -> tuple[npt.NDArray[np.bool_], npt.NDArray[np.bool_]]:
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


def _edges(block: npt.NDArray[Any], depth: int) -> dict[tuple[int, int], npt.NDArray[np.uint8]]:
    """What the neighbour of a block in each direction reads of it, in packed bits.

    One task for all is faster than eight, and bits are quicker to send to another worker.
    """
    ends = {-1: slice(depth), 0: slice(None), 1: slice(-depth, None)}
    return {(y, x): np.packbits(block[ends[y], ends[x]], axis=1) for y, x in _DIRECTIONS}


def _advance(block: npt.NDArray[Any], neighbours: list[tuple[int, int]],
             edges: list[dict[tuple[int, int], npt.NDArray[np.uint8]]], depth: int, rule: Rule,
             border: str | None, iterations: int) -> tuple[npt.NDArray[Any], tuple[bool, bool]]:
    """Thins a block with its halo; also returns whether it has changed and whether it was at rest.

    At rest: the last iteration changed nothing in the block, as an iteration before had changed
    nothing anywhere, or as no iteration changed the block: without a limit, rules only remove pixels
    or only add them.
    """
    width = {-1: depth, 0: block.shape[1], 1: depth}
    pieces = {(y, x): np.unpackbits(edge[-y, -x], axis=1, count=width[x]).view(block.dtype)
              for (y, x), edge in zip(neighbours, edges)}
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
