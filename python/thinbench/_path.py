"""Paths for robots on skeletons."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library


def find_path(free: npt.ArrayLike, start: Sequence[int], goal: Sequence[int], width: float = 0, *,
              threads: int = 1) -> npt.NDArray[np.int32]:
    """Find a path for a robot that keeps away from obstacles.

    The path of lowest cost: a step between two pixels of the skeleton of the free space costs its length, any
    other step four times its length.

    Parameters
    ----------
    free : array of bool or uint8, shape (H, W)
        Nonzero where a robot may be. At most 32767 pixels on a side. What is outside is no obstacle.
    start, goal : row and column
    width : float
        Of the robot, a disc, in pixels. All of the path is at least half of it from obstacles.
    threads : int
        The maximum number of threads.

    Returns
    -------
    array of int32, shape (N, 2)
        Rows and columns from start to goal; each pixel is one of the eight neighbours of the last.

    Raises
    ------
    TypeError, ValueError
        If start or goal is outside or has no room, or if there is no path, which begins with "no path".

    References
    ----------
    docs/path-planning.md

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> corridor = np.zeros((5, 7), bool)
    >>> corridor[1:4, 1:6] = True
    >>> thinbench.find_path(corridor, (2, 1), (2, 5)).tolist()
    [[2, 1], [2, 2], [2, 3], [2, 4], [2, 5]]
    """
    image = _arrays.binary(free, name="free")
    found = np.empty((max(image.size, 1), 2), np.int32)
    request = _library.PATH_REQUEST.pack(_library.PATH_REQUEST.size, *_arrays.pixel("start", start),
                                         *_arrays.pixel("goal", goal), _arrays.real("width", width))
    result = ctypes.create_string_buffer(_library.FOUND_PATH.pack(_library.FOUND_PATH.size, 0, 0, 0))
    _library.find_path(_arrays.image(image), request, _arrays.execution(threads),
                       found.ctypes.data, len(found), result)
    _, count, _, _ = _library.FOUND_PATH.unpack_from(result)
    if count == 0:
        raise ValueError(f"no path from {tuple(start)} to {tuple(goal)} is {width:g} pixels wide")
    return found[:count, ::-1].copy()
