"""Which pixels are foreground, as the program chooses."""

from __future__ import annotations

import ctypes
import struct
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library

_REQUEST = struct.Struct("NPiii4x")  # size, foreground, threshold, window, offset, reserved
_FOREGROUNDS = {name: ctypes.create_string_buffer(name.encode()) for name in ("auto", "bright", "dark")}
_CHANNELS = {name: name.encode()
             for name in ("grey", "red", "green", "blue", "saturation", "value", "auto")}
_METHODS = {"otsu": -1, "local": -2}


def binarise(image: npt.ArrayLike, *, foreground: str = "auto", threshold: int | Literal["otsu", "local"] = "otsu",
             channel: str = "grey", window: int | None = None, offset: int | None = None) -> npt.NDArray[np.bool_]:
    """Make a binary image of a grey or colour image, as the program `thinbench` does.

    Parameters
    ----------
    image : array of uint8, uint16 or bool, shape (H, W), (H, W, 3) or (H, W, 4)
        Grey levels, or red, green, blue and, if there is a fourth, opacity, which is ignored. True
        is the level 255.
    foreground : {"auto", "bright", "dark"}
        "auto": the class that covers less of the image border.
    threshold : int from 0 to 255, of uint16 to 65535, "otsu" or "local"
        Pixels are bright at this level and above. "otsu": the level that separates the two classes
        best. "local", for uneven light: foreground differs from the mean of the window around it by
        more than `offset`.
    channel : {"grey", "red", "green", "blue", "saturation", "value", "auto"}
        What becomes the grey level of a colour. "auto": what separates the two classes best.
    window : int, optional
        Side of the window of "local": odd, 3 to 65535. Default: an eighth of the image's smaller
        side, at least 15.
    offset : int, optional
        Of "local", 0 to 255 grey levels, of uint16 to 65535. Default: 10, of uint16 10 / 255 of the levels' range.

    Returns
    -------
    array of bool, shape (H, W)

    References
    ----------
    docs/images.md: what becomes foreground.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> photo = np.full((5, 5, 3), 200, np.uint8)
    >>> photo[2, 1:4] = 30, 40, 200
    >>> print(thinbench.binarise(photo, channel="red")[2].astype(int))
    [0 1 1 1 0]
    """
    levels = _levels(image, channel)
    request = _REQUEST.pack(_REQUEST.size,
                            ctypes.addressof(_arrays.one_of("foreground", foreground, _FOREGROUNDS)),
                            _threshold(threshold, np.iinfo(levels.dtype).max), _window(window),
                            _offset(offset))
    for name, value in (("window", window), ("offset", offset)):
        if value is not None and threshold != "local":
            raise ValueError(f"{name}: expected threshold='local' beside it, got {threshold!r}")
    result = np.empty(levels.shape, bool)
    if levels.dtype == np.uint8:
        _library.binarise(*_arrays.images(levels, result), request, None, None, None)
    else:
        _library.binarise16(_arrays.numbers(levels), _arrays.images(result, result)[1], request, None, None, None)
    return result


def _threshold(threshold: Any, highest: int) -> int:
    if isinstance(threshold, str):
        return _arrays.one_of("threshold", threshold, _METHODS)
    level = _arrays.integer("threshold", threshold)
    if not 0 <= level <= highest:
        raise ValueError(f"threshold: expected 0 to {highest}, 'otsu' or 'local', got {level}")
    return level


def _window(window: Any) -> int:
    if window is None:
        return 0
    side = _arrays.integer("window", window)
    if not (3 <= side <= 65535 and side % 2):
        raise ValueError(f"window: expected an odd number from 3 to 65535, got {side}")
    return side


def _offset(offset: Any) -> int:
    if offset is None:
        return -1
    levels = _arrays.integer("offset", offset)
    if levels < 0:
        raise ValueError(f"offset: expected 0 or more grey levels, got {levels}")
    return levels


def _levels(image: npt.ArrayLike, channel: str) -> npt.NDArray[Any]:
    name = _arrays.one_of("channel", channel, _CHANNELS)
    array = _arrays.unmasked(image)
    if array.dtype == np.bool_:
        array = array * np.uint8(255)
    if array.dtype not in (np.uint8, np.uint16):
        raise TypeError(f"image: expected dtype uint8, uint16 or bool of grey levels, got {array.dtype}")
    if array.ndim == 2:
        return _arrays.with_rows(array)
    if array.ndim != 3 or array.shape[2] not in (3, 4):
        raise ValueError(f"image: expected shape (H, W), (H, W, 3) or (H, W, 4), got {array.shape}"
                         f"{_arrays.channel_advice(array, 'image')}")
    colours = np.ascontiguousarray(array)
    height, width, samples = colours.shape
    levels = np.empty((height, width), colours.dtype)
    source = _library.COLOURS.pack(_library.COLOURS.size, colours.ctypes.data, width, height, samples * width, samples)
    if colours.dtype == np.uint8:
        _library.select_channel(source, _arrays.image(levels), name, None, None)
    else:
        _library.select_channel16(source, _arrays.numbers(levels), name, None, None)
    return levels
