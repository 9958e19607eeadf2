"""OpenCV's `cv2.ximgproc.thinning`, which many builds of OpenCV lack."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from thinbench import _arrays
from thinbench._thinning import thin

THINNING_ZHANGSUEN = 0
THINNING_GUOHALL = 1
_HIGH_BIT = np.uint8(128)
_RULES = {THINNING_ZHANGSUEN: "zhang_suen", THINNING_GUOHALL: "guo_hall"}


def thinning(src: npt.ArrayLike, dst: npt.NDArray[np.uint8] | None = None,
             thinningType: int = THINNING_ZHANGSUEN) -> npt.NDArray[np.uint8]:  # noqa: N803
    """Thin an image as OpenCV's `ximgproc.thinning` does, pixel for pixel.

    Parameters
    ----------
    src : array of uint8, shape (H, W)
        Values of 128 and more are foreground.
    dst : array of uint8, optional
        Receives the result: same shape, C-contiguous. May be `src`. (OpenCV returns a new array if
        the shape differs.)
    thinningType : {THINNING_ZHANGSUEN, THINNING_GUOHALL}

    Returns
    -------
    array of uint8, shape (H, W)
        255 on skeletons, else 0. The outermost pixels are never removed.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit, also for an empty image and for an unknown type, which OpenCV
        4.6 accepts.

    References
    ----------
    docs/thinning.md: the rules "zhang_suen" and "guo_hall", with border "keep".

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import cv2
    >>> block = np.pad(np.full((3, 5), 255, np.uint8), 1)
    >>> print(cv2.thinning(block)[2])
    [  0   0 255 255   0   0   0]
    """
    image = _arrays.grey(src, "src")
    if image.size == 0:
        raise ValueError(f"src: expected an image with pixels, got shape {image.shape}")
    rule = _RULES.get(_arrays.integer("thinningType", thinningType))
    if rule is None:
        raise ValueError(f"thinningType: expected 0 (Zhang-Suen) or 1 (Guo-Hall), "
                         f"got {thinningType}")
    foreground = np.bitwise_and(image, _HIGH_BIT, order="C")
    if dst is not None:
        _arrays.result_for(image, dst, "dst")
    return thin(foreground, rule, border="keep", out=foreground if dst is None else dst)
