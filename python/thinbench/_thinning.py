"""Thinning of images, of stacks and lists of images, and of label images."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterable
from typing import Any, Literal, overload

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library

RULES = {name: name.encode() for name in _library.all_names(_library.rule_name)}
_BORDERS = {"background": b"background", "keep": b"keep"}


def options_for(border: str, max_iterations: int | None, threads: int) -> bytes:
    """A thinbench_options struct."""
    keep = _arrays.one_of("border", border, _BORDERS) == b"keep"
    limit = limit_of(max_iterations)
    return _library.options(keep, limit, _arrays.integer("threads", threads))


def limit_of(max_iterations: int | None) -> int:
    """The limit as the C interface takes it; 0 for None."""
    if max_iterations is None:
        return 0
    limit = _arrays.integer("max_iterations", max_iterations)
    if limit < 1:
        raise ValueError(f"max_iterations: expected at least 1, got {limit}")
    return limit


def run(function: Callable[..., None], rule: bytes | int | None, image: npt.ArrayLike, options: bytes,
        return_iterations: bool, out: npt.NDArray[Any] | None,
        ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]:
    """Calls `thin` or `apply` of the library for an image or a stack."""
    image = _arrays.binary(image, 3)
    result = _arrays.result_for(image, out)
    stack, kept_alive = _arrays.source(image)
    iterations = ctypes.c_int32() if return_iterations else None
    function(rule, stack, _arrays.destination(result), options,
             ctypes.byref(iterations) if iterations is not None else None)
    del kept_alive
    return (result, iterations.value) if iterations is not None else result


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
    name = _arrays.one_of("rule", rule, RULES)
    options = options_for(border, max_iterations, threads)
    return run(_library.thin, name, image, options, return_iterations, out)


def thin_many(images: Iterable[npt.ArrayLike], rule: str = "guo_hall", *,
              border: str = "background", max_iterations: int | None = None,
              threads: int = 1) -> list[npt.NDArray[Any]]:
    """Thin a list of images of any sizes.

    Images of one size and dtype are thinned as a stack, which is faster where there are many up to
    128 pixels wide.

    Parameters
    ----------
    images : iterable of arrays of bool or uint8, shape (H, W)
        Sizes and dtypes may differ. Never modified.
    rule, border, max_iterations, threads
        As in `thin`. Threads share the images of one size.

    Returns
    -------
    list of arrays
        The skeletons in the order of the images, each with the shape and dtype of its image.
        Skeletons of one size are views of one stack; copy those that outlive the others.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> skeletons = thinbench.thin_many([np.ones((3, 9), bool), np.ones((5, 5), bool)])
    >>> [(skeleton.shape, int(skeleton.sum())) for skeleton in skeletons]
    [((3, 9), 7), ((5, 5), 1)]
    """
    arrays = [_arrays.binary(image) for image in images]
    _arrays.one_of("rule", rule, RULES)
    options_for(border, max_iterations, threads)
    groups: dict[tuple[Any, ...], list[int]] = {}
    for index, array in enumerate(arrays):
        groups.setdefault((array.shape, array.dtype), []).append(index)
    results = list(arrays)
    for indices in groups.values():
        stack = np.array([arrays[index] for index in indices])
        thin(stack, rule, border=border, max_iterations=max_iterations, threads=threads, out=stack)
        for index, skeleton in zip(indices, stack):
            results[index] = skeleton
    return results


@overload
def thin_labels(labels: npt.ArrayLike, rule: str = ..., *, border: str = ...,
                max_iterations: int | None = ..., threads: int = ...,
                return_iterations: Literal[False] = ..., out: npt.NDArray[Any] | None = ...,
                ) -> npt.NDArray[Any]: ...


@overload
def thin_labels(labels: npt.ArrayLike, rule: str = ..., *, border: str = ...,
                max_iterations: int | None = ..., threads: int = ...,
                return_iterations: Literal[True], out: npt.NDArray[Any] | None = ...,
                ) -> tuple[npt.NDArray[Any], int]: ...


def thin_labels(labels: npt.ArrayLike, rule: str = "guo_hall", *, border: str = "background",
                max_iterations: int | None = None, threads: int = 1,
                return_iterations: bool = False, out: npt.NDArray[Any] | None = None,
                ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]:
    """Thin every label of a label image as if it were alone in the image.

    Labels that touch do not merge. A label may have several components.

    Parameters
    ----------
    labels : array of uint16 or int32, shape (H, W)
        0 is background; negative labels are rejected. Labels need not be consecutive. Any
        strides. Never modified.
    rule, border, max_iterations
        As in `thin`; "keep" refers to the border of the image.
    threads : int
        The maximum number of threads, which share the labels.
    return_iterations : bool
        Also return the maximum number of iterations over all labels; 0 without labels.
    out : array, optional
        Receives the result: same shape and dtype as `labels`, C-contiguous. May be `labels`.

    Returns
    -------
    array of the shape and dtype of `labels`
        The label of each pixel that is on the skeleton of its label, else 0. With
        `return_iterations` a tuple of this and an int.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit; then nothing is written.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> labels = np.repeat(np.array([[7, 7, 7, 9, 9, 9]], np.int32), 5, axis=0)
    >>> print(thinbench.thin_labels(labels)[2])
    [0 7 0 0 9 0]
    """
    image = _arrays.labels(labels)
    name = _arrays.one_of("rule", rule, RULES)
    options = options_for(border, max_iterations, threads)
    result = _arrays.result_for(image, out)
    source = _arrays.label_rows(image)
    target = result if result.dtype == np.int32 else source
    iterations = ctypes.c_int32()
    _library.thin_labels(name, source.ctypes.data, _arrays.label_stride(source),
                         target.ctypes.data, _arrays.label_stride(target),
                         *image.shape, options, ctypes.byref(iterations))
    if target is not result:
        result[...] = target
    return (result, iterations.value) if return_iterations else result
