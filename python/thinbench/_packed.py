"""Thinning of packed images: 8 pixels per byte."""

from __future__ import annotations

import ctypes
from typing import Any, Literal, overload

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library
from thinbench._rules import Rule
from thinbench._thinning import request

Packed = npt.NDArray[np.uint8]

_BIT_ORDERS = {"big": b"big", "little": b"little"}


@overload
def thin_packed(packed: npt.ArrayLike, width: int, rule: str | Rule = ..., *, bit_order: str = ...,
                border: str | None = ..., max_iterations: int | None = ..., threads: int = ...,
                return_iterations: Literal[False] = ..., out: Packed | None = ...) -> Packed: ...


@overload
def thin_packed(packed: npt.ArrayLike, width: int, rule: str | Rule = ..., *, bit_order: str = ...,
                border: str | None = ..., max_iterations: int | None = ..., threads: int = ...,
                return_iterations: Literal[True], out: Packed | None = ...) -> tuple[Packed, int]: ...


def thin_packed(packed: npt.ArrayLike, width: int, rule: str | Rule = "guo_hall", *,
                bit_order: str = "big", border: str | None = None, max_iterations: int | None = None, threads: int = 1,
                return_iterations: bool = False, out: Packed | None = None) -> Packed | tuple[Packed, int]:
    """Thin an image of 8 pixels per byte, as `thin` does, without unpacking it.

    Parameters
    ----------
    packed : array of uint8, shape (H, (width + 7) // 8)
        As `numpy.packbits(image, axis=-1, bitorder=bit_order)` makes it: 1 is foreground, each row
        starts with a new byte, and unused bits of the last byte have no meaning. Any strides; an
        array whose rows are not contiguous is copied. Never modified.
    width : int
        The number of pixels of a row.
    bit_order : {"big", "little"}
        Whether the first pixel of a byte is its highest or its lowest bit.
    rule, border, max_iterations, threads, return_iterations
        As in `thin`.
    out : array of uint8, optional
        Receives the result: same shape, C-contiguous. May be the image.

    Returns
    -------
    array of uint8, shape (H, (width + 7) // 8)
        The skeleton in the same bit order, unused bits are 0. With `return_iterations` a tuple of
        this and an int.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> bar = np.zeros((5, 9), bool)
    >>> bar[1:4, 1:8] = True
    >>> packed = thinbench.thin_packed(np.packbits(bar, axis=-1), 9)
    >>> print(np.unpackbits(packed, axis=-1, count=9)[2])
    [0 0 1 1 1 1 1 0 0]
    """
    image = _checked(packed, _arrays.integer("width", width))
    lsb_first = _arrays.one_of("bit_order", bit_order, _BIT_ORDERS) == b"little"
    handle, *options = request(rule, border, max_iterations, threads)
    result = _arrays.result_for(image, out)
    iterations = ctypes.c_int32()
    _library.thin_packed(handle, _struct(image, width, lsb_first), _struct(result, width, lsb_first), *options,
                         ctypes.byref(iterations))
    return (result, iterations.value) if return_iterations else result


def _struct(image: Packed, width: int, lsb_first: bool) -> bytes:
    return _library.PACKED.pack(_library.PACKED.size, image.ctypes.data, width, image.shape[0],
                                _arrays.row_stride(image), lsb_first)


def _checked(packed: Any, width: int) -> Packed:
    image = _arrays.unmasked(packed, "packed")
    if image.dtype != np.uint8:
        raise TypeError(f"packed: expected dtype uint8, got {image.dtype}")
    if width < 0:
        raise ValueError(f"width: expected 0 or more, got {width}")
    if image.ndim != 2 or image.shape[1] != (width + 7) // 8:
        raise ValueError(f"packed: expected shape (H, {(width + 7) // 8}) for a width of {width}, "
                         f"got {image.shape}")
    return _arrays.with_rows(image)
