"""Checks of arrays, and their addresses for the C interface."""

from __future__ import annotations

import difflib
import operator
from collections.abc import Iterable, Iterator
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from thinbench import _library

Array = npt.NDArray[Any]
_Value = TypeVar("_Value")

_BOOL = np.dtype(bool)
_UINT8 = np.dtype(np.uint8)
_BINARY = (_UINT8, _BOOL)

_pack_image, _IMAGE_SIZE, _address = _library.IMAGE.pack, _library.IMAGE.size, _library.address


def as_array(name: str, values: Any, dtype: npt.DTypeLike = None) -> Array:
    """What NumPy makes of values; not of lists of different lengths."""
    try:
        return np.asarray(values, dtype)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: expected an array; {error}") from None


def unmasked(image: Any, name: str = "image") -> Array:
    """An array, no element of which is masked."""
    masked = np.count_nonzero(image.mask) if isinstance(image, np.ma.MaskedArray) else 0
    if masked:
        raise ValueError(f"{name}: expected no masked elements, got {masked}; `{name}.filled(0)` makes them background")
    return as_array(name, image)


def binary(image: Any, max_dimensions: int = 2, name: str = "image", stack: bool | None = False) -> Array:
    """A bool or uint8 image in rows, or with `max_dimensions` of 3 also a stack of images.

    What has a last axis of 1 to 4, as images with channels have, is rejected as a stack unless `stack` is True.
    """
    if type(image) is np.ndarray and image.ndim == 2 and image.dtype in _BINARY:
        stride, step = image.strides
        if step == 1 and stride >= image.shape[1]:
            return image  # at once, as small images take a microsecond
    image = unmasked(image, name)
    if image.dtype not in _BINARY:
        raise TypeError(f"{name}: expected dtype bool or uint8, got {image.dtype}; "
                        f"`{name} != 0` or `{name} > threshold` makes one")
    if not stack and (channels := channel_advice(image, name, is_binary=True)):
        advice = "; a stack of such images needs stack=True" if stack is None else ""
        raise ValueError(f"{name}: expected a binary image, got shape {image.shape}{channels}{advice}")
    return with_rows(_with_dimensions(image, max_dimensions, name))


def channel_advice(image: Array, name: str, is_binary: bool = False) -> str:
    """What to type where the last axis of an image, which may have to be binary, looks like channels; else nothing."""
    if image.ndim != 3 or not 1 <= image.shape[2] <= 4:
        return ""
    one = f"`thinbench.binarise({name})` makes a binary image, " if is_binary and is_colour(image) else ""
    return f", whose last axis looks like channels; {one}`{name}[..., 0]` takes one channel"


def is_colour(image: Array) -> bool:
    """Whether it has the shape and type of a colour image, 3 or 4 numbers for each pixel."""
    return image.dtype == _UINT8 and image.ndim == 3 and image.shape[2] in (3, 4)


def labels(image: Any, name: str = "labels") -> Array:
    """A bool or integer image of labels, all of which fit into int32."""
    array: Array = unmasked(image, name)
    if array.dtype.kind not in "biu":
        raise TypeError(f"{name}: expected bool or integers, got {array.dtype}; "
                        f"`{name}.astype(np.int32)` makes one")
    if not np.can_cast(array.dtype, np.int32) and array.size:
        for number in (int(array.min()), int(array.max())):
            if not -2**31 <= number < 2**31:
                raise ValueError(f"{name}: expected numbers that fit into int32, got {number}")
    return _with_dimensions(array, 2, name)


def grey(image: Any, name: str = "image") -> Array:
    """A uint8 image of grey levels in rows."""
    if type(image) is np.ndarray and image.ndim == 2 and image.dtype == _UINT8:
        return with_rows(image)
    image = unmasked(image, name)
    if image.dtype != _UINT8:
        raise TypeError(f"{name}: expected dtype uint8 of grey levels, got {image.dtype}")
    return with_rows(_with_dimensions(image, 2, name))


def _with_dimensions(image: Array, max_dimensions: int, name: str = "image") -> Array:
    if not 2 <= image.ndim <= max_dimensions:
        expected = "(H, W)" if max_dimensions == 2 else "(H, W) or (N, H, W)"
        raise ValueError(f"{name}: expected shape {expected}, got {image.shape}{channel_advice(image, name)}")
    return image


def result_for(image: Array, out: Array | None, name: str = "out", dtype: npt.DTypeLike = None) -> Array:
    """An array like the image, or of another type, or `out` if that fits."""
    if out is None:
        return np.empty(image.shape, image.dtype if dtype is None else dtype)
    wanted = np.dtype(dtype) if dtype is not None else image.dtype
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{name}: expected an array, got {type(out).__name__}")
    if out.dtype != wanted or out.shape != image.shape:
        raise ValueError(f"{name}: expected {wanted} of shape {image.shape}, "
                         f"got {out.dtype} of shape {out.shape}")
    if not out.flags.c_contiguous:
        raise ValueError(f"{name}: expected a C-contiguous array, got strides {out.strides}")
    if not out.flags.writeable:
        raise ValueError(f"{name}: expected a writable array, got a read-only one")
    return out


def with_rows(array: Array) -> Array:
    """The array, or a copy whose rows are contiguous, one after another without overlap."""
    stride, step = array.strides[-2:]
    item = array.itemsize
    overlaps = array.ndim == 3 and array.strides[0] < array.shape[1] * stride
    if step != item or stride % item or stride < array.shape[-1] * item or overlaps:
        return np.ascontiguousarray(array)
    return array


def row_stride(array: Array) -> int:
    """The elements from a row to the next; NumPy gives axes of length 1 and arrays without elements any strides."""
    width: int = array.shape[-1]
    return width if array.flags.c_contiguous else array.strides[-2] // array.itemsize


def image(array: Array) -> bytes:
    """A thinbench_image struct of rows."""
    height, width = array.shape
    return _pack_image(_IMAGE_SIZE, _address(array), width, height, row_stride(array), 0)


def result_image(result: Array) -> bytes:
    """The same of a result, which is contiguous; its foreground is 1 in an array of bool."""
    height, width = result.shape
    return _pack_image(_IMAGE_SIZE, _address(result), width, height, width, result.dtype.kind == "b")


def images(source: Array, result: Array) -> tuple[bytes, bytes]:
    """The structs of both."""
    return image(source), result_image(result)


def stacks(source: Array, result: Array) -> tuple[bytes, bytes]:
    """thinbench_stack structs, likewise."""
    count, height, width = source.shape
    stride = row_stride(source)
    image_stride = height * width if source.flags.c_contiguous else source.strides[0]
    size, pack = _library.STACK.size, _library.STACK.pack
    return (pack(size, _address(source), count, width, height, stride, image_stride, 0),
            pack(size, _address(result), count, width, height, width, height * width, result.dtype.kind == "b"))


def numbers(array: Array) -> bytes:
    """A thinbench_labels, thinbench_reals or thinbench_image16 struct of rows."""
    height, width = array.shape
    return _library.NUMBERS.pack(_library.NUMBERS.size, _library.address(array), width, height, row_stride(array))


def label_rows(image: Array) -> Array:
    """The labels as int32 in rows."""
    return with_rows(image.astype(np.int32, copy=False))


def integer(name: str, value: Any) -> int:
    """An integer in the range of the C interface."""
    if type(value) is int and -(2**31) <= value < 2**31:
        return value
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name}: expected an integer, got {value}")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected an integer, got {value!r}") from None
    if not -(2**31) <= number < 2**31:
        raise ValueError(f"{name}: expected less than 2**31 in magnitude, got {number}")
    return number


def number_below(count: int, name: str, value: Any) -> int:
    """Such as that of a node."""
    number = integer(name, value)
    if not 0 <= number < count:
        raise ValueError(f"{name}: expected a number from 0 to {count - 1}, got {number}")
    return number


def pixel(name: str, point: Any) -> tuple[int, int]:
    """The column and row of what has a row and a column."""
    try:
        row, column = point
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected a row and a column, got {point!r}") from None
    return integer(name, column), integer(name, row)


def each(name: str, values: Iterable[_Value]) -> Iterator[_Value]:
    try:
        return iter(values)
    except TypeError:
        raise TypeError(f"{name}: expected a list, got {values!r}") from None


def execution(threads: Any) -> bytes | None:
    """A thinbench_execution struct."""
    return _library.execution(integer("threads", threads))


def limit(max_iterations: Any) -> int:
    """A number of iterations; 0 for None."""
    if max_iterations is None:
        return 0
    number = integer("max_iterations", max_iterations)
    if number < 1:
        raise ValueError(f"max_iterations: expected at least 1, got {number}")
    return number


def real(name: str, value: Any) -> float:
    """A number, which may be infinite or NaN."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected a number, got {value!r}") from None
    except OverflowError:
        raise ValueError(f"{name}: expected less than 2**1024 in magnitude") from None


def spacing(name: str, value: Any) -> tuple[float, float]:
    """The distance of rows and that of columns, from one number or two."""
    if type(value) is int and value == 1:
        return 1.0, 1.0
    numbers = (value, value) if as_array(name, value).ndim == 0 else tuple(value)
    if len(numbers) != 2:
        raise ValueError(f"{name}: expected a number or two, of rows and of columns, got {value!r}")
    rows, columns = (real(name, number) for number in numbers)
    for number in (rows, columns):
        if not 1e-30 <= number <= 1e30:
            raise ValueError(f"{name}: expected numbers from 1e-30 to 1e30, got {number:g}")
    return rows, columns


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a string, got {value!r}")
    return value


def one_of(name: str, value: Any, allowed: dict[str, _Value]) -> _Value:
    """What a name stands for, such as in the C interface."""
    found = allowed.get(text(name, value))
    if found is None:
        raise ValueError(f"{name}: expected one of {', '.join(allowed)}; got {value!r}{meant(value, allowed)}")
    return found


def counted(count: int, noun: str) -> str:
    """"1 node", "2 nodes"."""
    return f"{count} {noun}{'' if count == 1 else 's'}"


def meant(word: str, known: Iterable[str]) -> str:
    """"; did you mean 'name'?" where a known name is like the word, else nothing."""
    near = difflib.get_close_matches(word.lower(), list(known), 1)
    return f"; did you mean {near[0]!r}?" if near else ""
