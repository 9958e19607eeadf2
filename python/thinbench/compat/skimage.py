"""scikit-image's `thin` and 2-D `skeletonize`."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays
from thinbench._thinning import thin as _thin


def as_bool(image: npt.ArrayLike) -> npt.NDArray[np.bool_]:
    """A new 2-D array: whether a pixel is nonzero."""
    picture = np.asarray(image)
    if picture.ndim != 2:
        raise ValueError(f"image: expected shape (H, W), got {picture.shape}")
    if picture.dtype.kind not in "biufc":
        raise TypeError(f"image: expected numbers, got dtype {picture.dtype}")
    return picture.astype(bool, order="C")


def thin(image: npt.ArrayLike, max_num_iter: int | None = None) -> npt.NDArray[np.bool_]:
    """Thin an image as `skimage.morphology.thin` does, pixel for pixel.

    Parameters
    ----------
    image : array, shape (H, W)
        Nonzero is foreground.
    max_num_iter : int, optional
        Stop after this many iterations. None and 0: until nothing changes.

    Returns
    -------
    array of bool, shape (H, W)

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit, also for an empty image, as in scikit-image.

    References
    ----------
    docs/thinning.md: the rule "guo_hall_skimage". Everything outside the image is background.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> print(skimage.thin(np.ones((3, 5)))[1].astype(int))
    [0 1 1 1 0]
    """
    picture: Any = as_bool(image)
    if picture.size == 0:
        raise ValueError(f"image: expected an image with pixels, got shape {picture.shape}")
    limit = None if max_num_iter is None else _arrays.integer("max_num_iter", max_num_iter)
    if limit is not None and limit < 0:
        raise ValueError(f"max_num_iter: expected at least 0, got {limit}")
    return _thin(picture, "guo_hall_skimage", max_iterations=limit or None, out=picture)


def skeletonize(image: npt.ArrayLike, *, method: str | None = None) -> npt.NDArray[np.bool_]:
    """Thin an image as `skimage.morphology.skeletonize` does in 2-D, pixel for pixel.

    Parameters
    ----------
    image : array, shape (H, W)
        Nonzero is foreground.
    method : {None, "zhang"}

    Returns
    -------
    array of bool, shape (H, W)

    Raises
    ------
    NotImplementedError
        For the method "lee", which is in scikit-image.
    ValueError
        For another method, or if the image has not two dimensions.

    References
    ----------
    docs/thinning.md: the rule "zhang_suen_skimage". Everything outside the image is background.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> print(skimage.skeletonize(np.ones((3, 5)))[1].astype(int))
    [1 1 1 0 0]
    """
    if method == "lee" or (method is None and np.ndim(image) == 3):
        raise NotImplementedError("method: 'lee' is not here; use scikit-image's "
                                  "skimage.morphology.skeletonize")
    if method not in (None, "zhang"):
        raise ValueError(f"method: expected None or 'zhang', got {method!r}")
    picture: Any = as_bool(image)
    return _thin(picture, "zhang_suen_skimage", out=picture)
