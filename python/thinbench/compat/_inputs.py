"""Images as other projects take them: numbers of any type."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays


def picture_of(image: Any, name: str, original: str) -> npt.NDArray[Any]:
    """A 2-D array of real numbers; for others, an error that names the original."""
    picture = _arrays.as_array(name, image)
    if picture.dtype.kind not in "biuf":
        raise TypeError(f"{name}: expected real numbers, got dtype {picture.dtype}")
    if picture.ndim != 2:
        raise NotImplementedError(f"{name}: expected shape (H, W), got {picture.shape}"
                                  f"{_arrays.channel_advice(picture, name)}; use {original}")
    return picture


def nonzero(picture: npt.NDArray[Any]) -> npt.NDArray[np.bool_]:
    """Whether a pixel is nonzero: where it has one byte, the image itself, whose bytes may be above 1."""
    if picture.dtype.itemsize == 1:
        return picture.view(np.bool_)
    foreground: npt.NDArray[np.bool_] = picture != 0
    return foreground


def as_bool(image: npt.ArrayLike) -> npt.NDArray[np.bool_]:
    """A new 2-D array: whether a pixel is nonzero."""
    picture = _arrays.as_array("image", image)
    if picture.ndim != 2:
        raise ValueError(f"image: expected shape (H, W), got {picture.shape}"
                         f"{_arrays.channel_advice(picture, 'image', is_binary=True)}")
    if picture.dtype.kind not in "biufc":
        raise TypeError(f"image: expected numbers, got dtype {picture.dtype}")
    return picture.astype(bool, order="C")
