"""The midpoint scan."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy.typing as npt

from thinbench import _arrays, _library

_DIRECTIONS = {"rows": 1, "columns": 2, "diagonals": 4, "antidiagonals": 8}
_BORDERS = {"background": b"background", "keep": b"keep"}


def midpoint_scan(image: npt.ArrayLike, directions: str | Iterable[str] = tuple(_DIRECTIONS), *,
                  border: str = "background", threads: int = 1,
                  out: npt.NDArray[Any] | None = None) -> npt.NDArray[Any]:
    """Mark the midpoints of all runs of foreground pixels.

    The result is neither connected nor thin in general, but fast to compute and in the middle.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W)
        Nonzero is foreground. Never modified.
    directions : str or iterable of str
        Any of "rows", "columns", "diagonals" and "antidiagonals".
    border : {"background", "keep"}
        "keep" also copies the outermost rows and columns.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.
    out : array, optional
        Receives the result: same shape and dtype as the image, C-contiguous. May be the image.

    Returns
    -------
    array of the shape and dtype of the image
        True or 255 on midpoints, of the two in the middle the first; else 0.

    References
    ----------
    Lazea, Mureşan and Lupu, "Image processing algorithms used in robotics applications", 1999,
    end of section 3.1.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> print(thinbench.midpoint_scan(np.ones((2, 5), bool), "rows").astype(int))
    [[0 0 1 0 0]
     [0 0 1 0 0]]
    """
    image = _arrays.binary(image)
    names = (directions,) if isinstance(directions, str) else _arrays.each("directions", directions)
    bits = 0
    for name in names:
        bits |= _arrays.one_of("directions", name, _DIRECTIONS)
    outside = _arrays.one_of("border", border, _BORDERS)
    result = _arrays.result_for(image, out)
    _library.midpoint_scan(*_arrays.images(image, result), bits, outside,
                           _arrays.execution(threads))
    return result
