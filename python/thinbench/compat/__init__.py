"""Functions with the names, arguments and pixels of other projects' functions."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from thinbench.compat import cv2, skimage

__all__ = ["bwmorph", "cv2", "skimage"]


def bwmorph(image: npt.ArrayLike, operation: str, n: float = 1) -> npt.NDArray[np.bool_]:
    """MATLAB's and Octave's `bwmorph(image, "thin", n)`.

    Parameters
    ----------
    image : array, shape (H, W)
        Nonzero is foreground.
    operation : {"thin"}
    n : int or inf
        The number of iterations; inf: until nothing changes.

    Returns
    -------
    array of bool, shape (H, W)

    Raises
    ------
    NotImplementedError
        For other operations.
    ValueError
        If n is negative or not whole, or the image has not two dimensions.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import bwmorph
    >>> print(bwmorph(np.ones((3, 5)), "thin", float("inf"))[1].astype(int))
    [0 1 1 1 0]
    """
    if operation != "thin":
        raise NotImplementedError(f"operation: expected 'thin', got {operation!r}")
    if n != math.inf and (n < 0 or n != int(n)):
        raise ValueError(f"n: expected a whole number of at least 0 or inf, got {n}")
    picture = skimage.as_bool(image)
    if n == 0 or picture.size == 0:
        return picture
    return skimage.thin(picture, None if n == math.inf else int(n))
