"""Thinning of images, of stacks and lists of images, and of label images."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from functools import lru_cache
from typing import Any, Literal, overload

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library
from thinbench._rules import Rule

_named = lru_cache(maxsize=None)(Rule.named)


def rule_of(rule: str | Rule) -> Rule:
    """A rule, or the one of this name."""
    if isinstance(rule, Rule):
        return rule
    if not isinstance(rule, str):
        raise TypeError(f"rule: expected a name or a Rule, got {type(rule).__name__}; Rule(tables) makes one")
    return _named(rule)


def request(rule: str | Rule, border: str | None, max_iterations: int | None, threads: int,
            ) -> tuple[int | None, bytes | None, bytes | None]:
    """What to compute and how: a handle, valid as long as the rule, and two structs or None for the defaults."""
    if border is None and max_iterations is None and type(threads) is int and threads == 1:
        return rule_of(rule).handle, None, None
    outside = 0 if border is None else _arrays.one_of("border", border, _library.BORDERS)
    return (rule_of(rule).handle, _library.thinning(outside, _arrays.limit(max_iterations)),
            _arrays.execution(threads))


@overload
def thin(image: npt.ArrayLike, rule: str | Rule = ..., *, border: str | None = ...,
         max_iterations: int | None = ..., threads: int = ...,
         return_iterations: Literal[False] = ..., out: npt.NDArray[Any] | None = ...,
         stack: bool | None = ...,
         ) -> npt.NDArray[Any]: ...


@overload
def thin(image: npt.ArrayLike, rule: str | Rule = ..., *, border: str | None = ...,
         max_iterations: int | None = ..., threads: int = ...,
         return_iterations: Literal[True], out: npt.NDArray[Any] | None = ...,
         stack: bool | None = ...,
         ) -> tuple[npt.NDArray[Any], int]: ...


@overload
def thin(image: npt.ArrayLike, rule: str | Rule = ..., *, border: str | None = ...,
         max_iterations: int | None = ..., threads: int = ..., return_iterations: bool,
         out: npt.NDArray[Any] | None = ..., stack: bool | None = ...,
         ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]: ...


def thin(image: npt.ArrayLike, rule: str | Rule = "guo_hall", *, border: str | None = None,
         max_iterations: int | None = None, threads: int = 1, return_iterations: bool = False,
         out: npt.NDArray[Any] | None = None, stack: bool | None = None,
         ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]:
    """Apply a rule to a binary image, by default one that reduces objects to thin lines.

    `apply` is the same function, for rules that do not thin.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W) or (N, H, W)
        An image, or a stack of N images. Nonzero is foreground. Any strides; an image whose rows
        are not contiguous is copied. Never modified.
    rule : str or Rule
        A Rule, or the name of one: `rules()`, `named_rules()`. "guo_hall" keeps the number of
        objects and holes.
    border : {"background", "keep", "foreground"}, optional
        What is outside the image. "background" changes the outermost pixels like all others,
        "keep" never does, as OpenCV. "foreground" is for rules with tables. Default: as the rule
        says, "background" for all that thin.
    max_iterations : int, optional
        Stop after this many iterations, at least 1; 2**31 - 1 is no limit. Default: as the rule
        says, which is until nothing changes for all that thin.
    threads : int
        The maximum number of threads. One image below 2**20 pixels uses one.
    return_iterations : bool
        Also return the number of iterations, including the last one if it changed nothing; of a
        stack, the maximum.
    out : array, optional
        Receives the result: same shape and dtype as the image, C-contiguous. May be the image.
    stack : bool, optional
        True: shapes (N, H, 1) to (N, H, 4) are stacks; by default they are rejected, as the last axis may be
        channels.
        False: nothing is a stack.

    Returns
    -------
    array of the shape and dtype of the image
        True or 255 for foreground, else 0. With `return_iterations` a tuple of this and an int.

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
    array = _arrays.binary(image, 2 if stack is False else 3, stack=stack)
    handle, *options = request(rule, border, max_iterations, threads)
    result = _arrays.result_for(array, out)
    iterations = ctypes.c_int32()
    count = ctypes.byref(iterations) if return_iterations else None
    if array.ndim == 2:
        _library.thin(handle, *_arrays.images(array, result), *options, count)
    else:
        _library.thin_stack(handle, *_arrays.stacks(array, result), *options, count)
    return (result, iterations.value) if return_iterations else result


apply = thin


def thin_many(images: Iterable[npt.ArrayLike], rule: str | Rule = "guo_hall", *,
              border: str | None = None, max_iterations: int | None = None,
              threads: int = 1) -> list[npt.NDArray[Any]]:
    """Thin a list of images of any sizes.

    Faster than a loop over `thin` where there are many up to 128 pixels wide, most of all where all are
    of one size and dtype.

    Parameters
    ----------
    images : iterable of arrays of bool or uint8, shape (H, W)
        Sizes and dtypes may differ. Never modified.
    rule, border, max_iterations, threads
        As in `thin`. Threads share the images.

    Returns
    -------
    list of arrays
        The skeletons in the order of the images, each with the shape and dtype of its image. Where all are
        alike, they are views of one stack; copy those that outlive the others.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> skeletons = thinbench.thin_many([np.ones((3, 9), bool), np.ones((5, 5), bool)])
    >>> [(skeleton.shape, int(skeleton.sum())) for skeleton in skeletons]
    [((3, 9), 7), ((5, 5), 1)]
    """
    arrays = [_arrays.binary(image, name=f"images[{i}]") for i, image in enumerate(_arrays.each("images", images))]
    if len({(array.shape, array.dtype) for array in arrays}) == 1:
        stack = np.array(arrays)
        thin(stack, rule, border=border, max_iterations=max_iterations, threads=threads, out=stack, stack=True)
        return list(stack)
    handle, *options = request(rule, border, max_iterations, threads)
    results = [np.empty(array.shape, array.dtype) for array in arrays]
    _library.thin_many(handle, b"".join(map(_arrays.image, arrays)), b"".join(map(_arrays.result_image, results)),
                       len(arrays), *options, None)
    return results


@overload
def thin_labels(labels: npt.ArrayLike, rule: str | Rule = ..., *, border: str | None = ...,
                max_iterations: int | None = ..., threads: int = ...,
                return_iterations: Literal[False] = ..., out: npt.NDArray[Any] | None = ...,
                ) -> npt.NDArray[Any]: ...


@overload
def thin_labels(labels: npt.ArrayLike, rule: str | Rule = ..., *, border: str | None = ...,
                max_iterations: int | None = ..., threads: int = ...,
                return_iterations: Literal[True], out: npt.NDArray[Any] | None = ...,
                ) -> tuple[npt.NDArray[Any], int]: ...


def thin_labels(labels: npt.ArrayLike, rule: str | Rule = "guo_hall", *, border: str | None = None,
                max_iterations: int | None = None, threads: int = 1,
                return_iterations: bool = False, out: npt.NDArray[Any] | None = None,
                ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]:
    """Thin every label of a label image as if it were alone in the image.

    Labels that touch do not merge. A label may have several components.

    Parameters
    ----------
    labels : array of bool or integers, shape (H, W)
        0 is background; negative labels and those from 2**31 on are rejected. Labels need not be consecutive. Any
        strides. Never modified.
    rule, border, max_iterations
        As in `thin`, but the rule must not add pixels, and the border is not "foreground". "keep"
        refers to the border of the image.
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

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> labels = np.repeat(np.array([[7, 7, 7, 9, 9, 9]], np.int32), 5, axis=0)
    >>> print(thinbench.thin_labels(labels)[2])
    [0 7 0 0 9 0]
    """
    image = _arrays.labels(labels)
    handle, *options = request(rule, border, max_iterations, threads)
    result = _arrays.result_for(image, out)
    source = _arrays.label_rows(image)
    target = result if result.dtype == np.int32 else source
    iterations = ctypes.c_int32()
    _library.thin_labels(handle, _arrays.numbers(source), _arrays.numbers(target), *options,
                         ctypes.byref(iterations))
    if target is not result:
        result[...] = target
    return (result, iterations.value) if return_iterations else result
