"""Functions with the names, arguments and pixels of other projects' functions."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from thinbench import _arrays
from thinbench._thinning import thin
from thinbench.compat import _inputs, cv2, ndimage, skimage

__all__ = ["bwmorph", "cv2", "ndimage", "skimage"]

_OPERATIONS = ("bridge", "clean", "diag", "dilate", "endpoints", "erode", "fill", "hbreak", "majority", "remove",
               "spur", "thin", "open", "close", "tophat", "bothat")
_ONCE = ("bridge", "clean", "fill", "hbreak", "remove")  # whatever n, as in Octave
_STEPS = {"open": ("erode", "dilate"), "close": ("dilate", "erode"), "tophat": ("erode", "dilate"),
          "bothat": ("dilate", "erode")}


def bwmorph(image: npt.ArrayLike, operation: str, n: float = 1) -> npt.NDArray[np.bool_]:
    """MATLAB's and Octave's `bwmorph(image, operation, n)`, pixels as Octave's.

    Parameters
    ----------
    image : array, shape (H, W)
        Nonzero is foreground.
    operation : {"bridge", "clean", "diag", "dilate", "endpoints", "erode", "fill", "hbreak", "majority",
        "remove", "spur", "thin", "open", "close", "tophat", "bothat"}
    n : int or inf
        The number of iterations; inf: until nothing changes. Everything outside the image is
        background.

    Returns
    -------
    array of bool, shape (H, W)

    Raises
    ------
    NotImplementedError
        For other operations, such as "skel" and "shrink", which are in Octave.
    TypeError, ValueError
        If n is negative or not whole, or inf with "majority", which may never end, or the image has
        not two dimensions.

    References
    ----------
    docs/thinning.md: the rule "guo_hall_skimage" for "thin"; docs/rules.md: the others.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import bwmorph
    >>> print(bwmorph(np.ones((3, 5)), "thin", float("inf"))[1].astype(int))
    [0 1 1 1 0]
    """
    if operation not in _OPERATIONS:
        raise NotImplementedError(f"operation: expected one of {', '.join(_OPERATIONS)}; got {operation!r}"
                                  f"{_arrays.meant(str(operation), _OPERATIONS)}")
    limit = 2**31 - 1 if n == math.inf else _whole(n)
    picture = _inputs.as_bool(image)
    if limit == 0 or picture.size == 0:
        return picture
    if operation == "thin":
        return skimage.thin(picture, limit)
    if operation in _STEPS:
        first, second = _STEPS[operation]
        changed: npt.NDArray[np.bool_] = thin(thin(picture, first, max_iterations=1), second, max_iterations=1)
        return changed ^ picture if operation.endswith("hat") else changed
    if operation in _ONCE:
        limit = 1
    result: npt.NDArray[np.bool_] = thin(picture, operation, max_iterations=limit)
    return result


def _whole(n: float) -> int:
    """A number of iterations; MATLAB's numbers are floating-point."""
    if not isinstance(n, (int, float, np.number)):
        raise TypeError(f"n: expected a number, got {n!r}")
    if not (0 <= n < 2**31 and n == int(n)):
        raise ValueError(f"n: expected a whole number from 0 to 2**31 - 1 or inf, got {n}")
    return int(n)
