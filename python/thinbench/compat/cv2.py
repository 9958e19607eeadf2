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
        Receives the result. May be `src`.
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

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import cv2
    >>> block = np.pad(np.full((3, 5), 255, np.uint8), 1)
    >>> print(cv2.thinning(block)[2])
    [  0   0 255 255   0   0   0]
    """
    image = _arrays.grey(src)
    if image.size == 0:
        raise ValueError(f"src: expected an image with pixels, got shape {image.shape}")
    if thinningType not in _RULES:
        raise ValueError(f"thinningType: expected 0 (Zhang-Suen) or 1 (Guo-Hall), "
                         f"got {thinningType!r}")
    foreground = image & _HIGH_BIT
    return thin(foreground, _RULES[thinningType], border="keep",
                out=foreground if dst is None else dst)
