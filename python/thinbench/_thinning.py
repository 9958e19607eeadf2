"""Thinning of images and of stacks of images."""

from __future__ import annotations

import ctypes
from typing import Any, Literal, overload

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library

RULES = {name: name.encode() for name in _library.all_names(_library.rule_name)}
_BORDERS = {"background": b"background", "keep": b"keep"}


def options_for(border: str, max_iterations: int | None, threads: int) -> bytes:
    """A thinbench_options struct."""
    keep = _arrays.one_of("border", border, _BORDERS) == b"keep"
    limit = 0
    if max_iterations is not None:
        limit = _arrays.integer("max_iterations", max_iterations)
        if limit < 1:
            raise ValueError(f"max_iterations: expected at least 1, got {limit}")
    return _library.options(keep, limit, _arrays.integer("threads", threads))


@overload
def thin(image: npt.ArrayLike, rule: str = ..., *, border: str = ...,
         max_iterations: int | None = ..., threads: int = ...,
         return_iterations: Literal[False] = ..., out: npt.NDArray[Any] | None = ...,
         ) -> npt.NDArray[Any]: ...


@overload
def thin(image: npt.ArrayLike, rule: str = ..., *, border: str = ...,
         max_iterations: int | None = ..., threads: int = ...,
         return_iterations: Literal[True], out: npt.NDArray[Any] | None = ...,
         ) -> tuple[npt.NDArray[Any], int]: ...


@overload
def thin(image: npt.ArrayLike, rule: str = ..., *, border: str = ...,
         max_iterations: int | None = ..., threads: int = ..., return_iterations: bool,
         out: npt.NDArray[Any] | None = ...,
         ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]: ...


def thin(image: npt.ArrayLike, rule: str = "guo_hall", *, border: str = "background",
         max_iterations: int | None = None, threads: int = 1, return_iterations: bool = False,
         out: npt.NDArray[Any] | None = None,
         ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]:
    """Reduce the objects of a binary image to thin lines.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W) or (N, H, W)
        An image, or a stack of N images. Nonzero is foreground. Any strides; an image whose rows
        are not contiguous is copied. Never modified.
    rule : str
        One of `rules()`. "guo_hall" keeps the number of objects and holes.
    border : {"background", "keep"}
        Everything outside the image is background. "background" thins the outermost pixels like
        all others, "keep" never changes them, as OpenCV does.
    max_iterations : int, optional
        Stop after this many iterations, at least 1. Default: until nothing changes.
    threads : int
        The maximum number of threads. One image below 2**20 pixels uses one.
    return_iterations : bool
        Also return the number of iterations; of a stack, the maximum.
    out : array, optional
        Receives the result: same shape and dtype as the image, C-contiguous. May be the image.

    Returns
    -------
    array of the shape and dtype of the image
        True or 255 on skeletons, else 0. With `return_iterations` a tuple of this and an int.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit; then nothing is written.

    References
    ----------
    Guo and Hall, "Parallel thinning with two-subiteration algorithms", CACM 32(3), 1989. The
    sources of all rules are in docs/thinning.md.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> bar = np.zeros((5, 9), np.uint8)
    >>> bar[1:4, 1:8] = 1
    >>> print(thinbench.thin(bar))
    [[  0   0   0   0   0   0   0   0   0]
     [  0   0   0   0   0   0   0   0   0]
     [  0   0 255 255 255 255 255   0   0]
     [  0   0   0   0   0   0   0   0   0]
     [  0   0   0   0   0   0   0   0   0]]
    """
    image = _arrays.binary(image, 3)
    name = _arrays.one_of("rule", rule, RULES)
    options = options_for(border, max_iterations, threads)
    result = _arrays.result_for(image, out)
    stack, kept_alive = _arrays.source(image)
    iterations = ctypes.c_int32() if return_iterations else None
    status = _library.thin(name, stack, _arrays.destination(result), options,
                           ctypes.byref(iterations) if iterations is not None else None)
    if status:
        raise _library.error(status)
    del kept_alive
    return (result, iterations.value) if iterations is not None else result
