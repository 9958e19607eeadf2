"""Thinning, edges, regions and distances of dask arrays, equal to the result in memory, bit for bit.

A sub-iteration reads neighbours one pixel away, two in "mb2". So the effect of what is outside a
chunk advances by a known number of pixels per iteration, `Rule.reach`, and a chunk that is thinned
with a halo deep enough is exact in its interior.
"""

from __future__ import annotations

import math
import os
from pathlib import Path
from typing import Any

import numpy as np

import thinbench
from thinbench import Rule, _arrays, _library
from thinbench._thinning import rule_of

try:
    import dask.array as da
except ImportError as error:
    raise ImportError("thinbench.dask needs dask: install python3-dask (Debian) or dask[array] "
                      "(pip)") from error

from thinbench import _dask_regions, _dask_thinning

__all__ = ["detect_edges", "distances", "fill_holes", "find_regions", "label_regions", "thin"]


def thin(array: Any, rule: str | Rule = "guo_hall", *, border: str | None = None,
         max_iterations: int | None = None, depth: int = 64, out: Any = None) -> Any:
    """Thin a binary image that is a dask array.

    Without a limit this computes: chunks are thinned with halos, in rounds, until no
    chunk changes. One round suffices where every chunk comes to rest before its halo is used up.
    Chunks at rest among chunks at rest are skipped.

    Parameters
    ----------
    array : dask array of bool or uint8, shape (H, W)
        Nonzero is foreground. Chunks of any size; those smaller than the halo are merged for the
        computation.
    rule, border, max_iterations
        As in `thinbench.thin`. "keep" refers to the border of the whole image. With a limit, of
        the rule or of the call, halos cover all iterations, and the result is lazy.
    depth : int
        Width of the halos without a limit, in pixels. More depth, fewer rounds.
    out : zarr array, or path of a new one, optional
        Receives the result, chunk by chunk, after the last round. Must not be the source. A path
        is local and appears when the array is complete.

    Returns
    -------
    dask array of the shape, dtype and chunks of `array`
        True or 255 on skeletons, else 0: lazy with a limit and where one chunk suffices,
        else persisted. With `out`, that array.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> bars = da.ones((9, 300), dtype=bool, chunks=(9, 100))
    >>> skeleton = thinbench.dask.thin(bars)
    >>> skeleton.chunks, int(skeleton.sum().compute())
    (((9,), (100, 100, 100)), 292)
    """
    _check_image(array)
    thinbench.thin(np.empty((0, 0), bool), rule, border=border, max_iterations=max_iterations)
    used = rule_of(rule)
    if _arrays.integer("depth", depth) < used.reach:
        raise ValueError(f"depth: expected at least {used.reach}, the pixels that {used.name!r} "
                         f"advances in an iteration, got {depth}")
    _check_out(out, array)
    limit = _arrays.limit(max_iterations) or used.max_iterations
    if limit is None or limit == _library.UNLIMITED:
        result = _dask_thinning.until_at_rest(array, used, border, depth, depth // used.reach)
    else:
        result = _dask_thinning.limited(array, used, border, limit, limit * used.reach)
    result = result.rechunk(array.chunks)
    return result if out is None else _stored(result, out)


def find_regions(array: Any) -> dict[str, Any]:
    """Find objects and holes of a binary image that is a dask array.

    Chunks are labelled one by one, and their components joined across chunks. This computes.

    Parameters
    ----------
    array : dask array of bool or uint8, shape (H, W)
        Nonzero is foreground. Chunks of any size.

    Returns
    -------
    dict of arrays
        As `thinbench.find_regions`, in memory: a row for each object and each hole.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> ring = da.ones((6, 6), dtype=bool, chunks=4)
    >>> ring[1:5, 1:5] = False
    >>> table = thinbench.dask.find_regions(ring)
    >>> print(table["area"], table["is_hole"], table["enclosing_object"])
    [20 16] [False  True] [0 1]
    """
    return label_regions(array)[1]  # labels are lazy


def label_regions(array: Any) -> tuple[Any, dict[str, Any]]:
    """Find objects and holes of a binary image that is a dask array, and label their pixels.

    Returns a lazy array of int32, shape (H, W), and the table of `find_regions`, as `thinbench.label_regions`.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> labels, table = thinbench.dask.label_regions(da.ones((2, 3), dtype=bool, chunks=2))
    >>> print(labels.compute())
    [[1 1 1]
     [1 1 1]]
    """
    _check_image(array)
    return _dask_regions.label_regions(array)


def detect_edges(array: Any, operator: str = "sobel", gradient_threshold: int = 40,
                 brightness_threshold: int = 128) -> Any:
    """Find the edges of a grey image that is a dask array.

    Lazy: chunks with a halo of 3 pixels, the reach of the widest operator and of the brightness.

    Parameters
    ----------
    array : dask array of uint8, shape (H, W)
        Grey levels. Chunks of any size; those smaller than the halo are merged.
    operator, gradient_threshold, brightness_threshold
        As in `thinbench.detect_edges`.

    Returns
    -------
    dask array of uint8, shape (H, W)
        255 on edges, else 0: equal to `thinbench.detect_edges` in memory.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> step = da.concatenate([da.zeros((9, 50), dtype="u1"), da.full((9, 50), 200, dtype="u1")], axis=1)
    >>> int((thinbench.dask.detect_edges(step) > 0).sum().compute())
    18
    """
    _check_image(array, _arrays.grey)
    options: dict[str, Any] = {"operator": operator, "gradient_threshold": gradient_threshold,
                               "brightness_threshold": brightness_threshold}
    thinbench.detect_edges(np.empty((0, 0), np.uint8), **options)
    return _dask_thinning.with_halo(array, thinbench.detect_edges, 3, np.uint8, **options)


def fill_holes(array: Any, max_size: int) -> Any:
    """Fill the small holes of a binary image that is a dask array.

    Lazy: chunks with a halo of `max_size` pixels. `thinbench.dask.find_regions` finds holes of any size.

    Parameters
    ----------
    array : dask array of bool or uint8, shape (H, W)
        Nonzero is foreground. Chunks of any size; those smaller than the halo are merged.
    max_size : int
        Holes up to this many pixels wide and high are filled. Others remain.

    Returns
    -------
    dask array of the shape and dtype of `array`
        True or 255 on objects and in small holes, else 0.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> ring = da.ones((6, 6), dtype=bool, chunks=4)
    >>> ring[2:4, 2:4] = False
    >>> int(thinbench.dask.fill_holes(ring, 2).sum().compute())
    36
    """
    _check_image(array)
    if _arrays.integer("max_size", max_size) < 1:
        raise ValueError(f"max_size: expected at least 1, got {max_size}")
    return _dask_thinning.with_halo(array, _dask_regions.without_small_holes, max_size, array.dtype,
                                    max_size=max_size)


def distances(array: Any, max_distance: float) -> Any:
    """Find the distance to the nearest background pixel in a binary image that is a dask array.

    Lazy: chunks with a halo of `max_distance` pixels, rounded up.

    Parameters
    ----------
    array : dask array of bool or uint8, shape (H, W)
        Nonzero is foreground. Chunks of any size; those smaller than the halo are merged.
    max_distance : float
        Distances up to this one are exact; greater ones become infinite.

    Returns
    -------
    dask array of float64, shape (H, W)
        As `thinbench.distances`, up to `max_distance`.

    Examples
    --------
    >>> import dask.array as da
    >>> import thinbench.dask
    >>> line = da.concatenate([da.zeros((1, 1), dtype=bool), da.ones((1, 5), dtype=bool)], axis=1)
    >>> print(thinbench.dask.distances(line, 3).compute())
    [[ 0.  1.  2.  3. inf inf]]
    """
    _check_image(array)
    limit = _arrays.real("max_distance", max_distance)
    if not 1 <= limit <= 32767:
        raise ValueError(f"max_distance: expected 1 to 32767, got {max_distance}")
    return _dask_thinning.with_halo(array, _dask_regions.near_distances, math.ceil(limit), np.float64,
                                    max_distance=limit)


def _check_image(array: Any, check: Any = _arrays.binary) -> None:
    """Rejects what is not a dask array of an image with known chunks."""
    if not isinstance(array, da.Array):
        raise TypeError(f"array: expected a dask array, got {type(array).__name__}")
    check(np.empty((0, 0), array.dtype), name="array")
    if array.ndim != 2:
        raise ValueError(f"array: expected shape (H, W), got {array.shape}{_arrays.channel_advice(array, 'array')}")
    if any(np.isnan(size) for sizes in array.chunks for size in sizes):
        raise ValueError(f"array: expected chunks of known size, got {array.chunks}; "
                         "`array.compute_chunk_sizes()` finds them")


def _check_out(out: Any, array: Any) -> None:
    if out is None:
        return
    try:
        import zarr  # noqa: F401
    except ImportError as error:
        raise ImportError("out: needs zarr: install python3-zarr (Debian) or zarr (pip)") from error
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
