"""SciPy's `ndimage.label`, `binary_fill_holes` and `distance_transform_edt`, for images."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _images
from thinbench.compat import _inputs

_CROSS = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]], bool)


def label(input: npt.ArrayLike, structure: npt.ArrayLike | None = None,
          output: Any = None) -> tuple[npt.NDArray[Any], int] | int:
    """Label objects as `scipy.ndimage.label` does, number for number.

    Parameters
    ----------
    input : array of real numbers, shape (H, W)
        Nonzero is foreground.
    structure : array, shape (3, 3), optional
        A cross, for 4-connected objects, or ones, for 8-connected ones. Default: a cross.
    output : dtype or array, optional
        The type of the labels, or an array of the shape of the image that receives them. Default: int32.

    Returns
    -------
    array of shape (H, W), and int; or int alone if `output` is an array
        Labels from 1 in raster order of first pixels (SciPy: of those of `output`, which differ if its
        columns are contiguous), 0 in the background; and the number of objects.

    Raises
    ------
    NotImplementedError
        For other structures and for other than two dimensions, which are in SciPy.
    RuntimeError, TypeError, ValueError
        Where SciPy raises it: if an argument does not fit, and for too many objects for the type of `output`.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import ndimage
    >>> labels, count = ndimage.label(np.array([[1, 0, 1], [0, 1, 0]]))
    >>> print(labels, count)
    [[1 0 2]
     [0 3 0]] 3
    """
    picture = _inputs.picture_of(input, "input", "scipy.ndimage.label")
    given = _arrays.as_array("structure", _CROSS if structure is None else structure, bool)
    if given.ndim != 2:
        raise RuntimeError(f"structure: expected two dimensions, got shape {given.shape}")
    if given.shape != (3, 3):
        raise ValueError(f"structure: expected shape (3, 3), got {given.shape}")
    connectivity = _connectivity(given, "scipy.ndimage.label")
    if isinstance(output, np.ndarray) and output.shape != picture.shape:
        raise ValueError(f"output: expected shape {picture.shape}, got {output.shape}")
    labels, count = _images.label_image(_inputs.nonzero(picture), connectivity=connectivity)
    if isinstance(output, np.ndarray):
        _convert(labels, output)
        return count
    return (labels if output is None else _convert(labels, np.empty(labels.shape, output))), count


def binary_fill_holes(input: npt.ArrayLike, structure: npt.ArrayLike | None = None,
                      output: npt.NDArray[Any] | None = None,
                      origin: int | tuple[int, int] = 0) -> npt.NDArray[np.bool_] | None:
    """Fill holes as `scipy.ndimage.binary_fill_holes` does, pixel for pixel.

    Parameters
    ----------
    input : array of real numbers, shape (H, W)
        Nonzero is foreground.
    structure : array, shape (3, 3), optional
        A cross, for 4-connected background, or ones, for 8-connected background. Default: a cross.
    output : array, optional
        Receives the result, of the shape of the image.
    origin : {0, (0, 0)}

    Returns
    -------
    array of bool, shape (H, W); None if `output` is an array
        Objects, and background that is not connected to what is outside.

    Raises
    ------
    NotImplementedError
        For other structures and origins, and for other than two dimensions, which are in SciPy.
    RuntimeError, TypeError
        If `output` has another shape, and for complex numbers.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import ndimage
    >>> print(ndimage.binary_fill_holes(np.array([[0, 1, 0], [1, 0, 1], [0, 1, 0]]))[1])
    [ True  True  True]
    """
    name = "scipy.ndimage.binary_fill_holes"
    picture = _inputs.picture_of(input, "input", name)
    background = _connectivity(_arrays.as_array("structure", _CROSS if structure is None else structure, bool), name)
    if np.any(origin):
        raise NotImplementedError(f"origin: expected 0, got {origin}; use {name}")
    if isinstance(output, np.ndarray) and output.shape != picture.shape:
        raise RuntimeError(f"output: expected shape {picture.shape}, got {output.shape}")
    filled: npt.NDArray[np.bool_] = _images.fill_holes(
        _inputs.nonzero(picture), connectivity=8 if background == 4 else 4)
    if not isinstance(output, np.ndarray):
        return filled
    output[...] = filled
    return None


def distance_transform_edt(input: npt.ArrayLike, sampling: Any = None, return_distances: bool = True,
                           return_indices: bool = False, distances: npt.NDArray[np.float64] | None = None,
                           indices: npt.NDArray[np.int32] | None = None) -> Any:
    """Find distances to the background, and where it is, as `scipy.ndimage.distance_transform_edt` does.

    Parameters
    ----------
    input : array of real numbers, shape (H, W)
        Nonzero is foreground. At most 32767 pixels on a side.
    sampling : float or pair of floats, optional
        The distance between rows and that between columns, 1e-30 to 1e30. Results equal SciPy's without it,
        and for powers of two; for others the last bit may differ, as products are rounded otherwise.
    return_distances, return_indices : bool
        What is returned: the distances, row and column of the nearest background pixel, or both.
    distances : array of float64, shape (H, W), optional
        Receives the distances.
    indices : array of int32, shape (2, H, W), optional
        Receives rows and columns.

    Returns
    -------
    array of float64, shape (H, W), and array of int32, shape (2, H, W)
        Those that are asked for and not given; None without any. Of nearest pixels, those in the leftmost column
        count, and of these the upper one. In an image without background, the pixel above the first one counts, as
        in SciPy.

    Raises
    ------
    NotImplementedError
        For indices with a sampling, and for other than two dimensions, which are in SciPy.
    RuntimeError, TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import ndimage
    >>> print(ndimage.distance_transform_edt(np.array([[0, 1, 1], [1, 1, 1]]), sampling=2)[0])
    [0. 2. 4.]
    """
    name = "scipy.ndimage.distance_transform_edt"
    if not (return_distances or return_indices):
        raise RuntimeError("return_distances, return_indices: expected True for one of them, got False")
    if return_indices and sampling is not None:
        raise NotImplementedError(f"sampling: expected None for indices, got {sampling!r}; use {name}")
    picture = _inputs.picture_of(input, "input", name)
    results = []
    if return_distances:
        results += _given(_distances(picture, sampling), distances, "distances")
    if return_indices:
        results += _given(_nearest(picture != 0), indices, "indices")
    return tuple(results) if len(results) > 1 else results[0] if results else None


def _given(found: npt.NDArray[Any], out: npt.NDArray[Any] | None, name: str) -> list[npt.NDArray[Any]]:
    """The array, unless there is another one, which receives it."""
    if out is None:
        return [found]
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{name}: expected an array, got {type(out).__name__}")
    if out.shape != found.shape or out.dtype != found.dtype:
        raise RuntimeError(f"{name}: expected {found.dtype} of shape {found.shape}, "
                           f"got {out.dtype} of shape {out.shape}")
    out[...] = found
    return []


def _connectivity(structure: npt.NDArray[np.bool_], original: str) -> Literal[4, 8]:
    """Of neighbours, as a structure has them."""
    if structure.shape == (3, 3) and structure.all():
        return 8
    if not np.array_equal(structure, _CROSS):
        raise NotImplementedError("structure: expected a cross or ones of shape (3, 3), "
                                  f"got {structure.astype(int).tolist()}; use {original}")
    return 4


def _convert(labels: npt.NDArray[np.int32], output: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """The labels as numbers of another type."""
    np.copyto(output, labels, casting="unsafe")
    if output.dtype != bool and not np.array_equal(output, labels):
        raise RuntimeError(f"output: expected a type for {labels.max()} labels, got {output.dtype}")
    return output


def _distances(picture: npt.NDArray[Any], sampling: Any) -> npt.NDArray[np.float64]:
    spacing = _arrays.as_array("sampling", 1 if sampling is None else sampling, np.float64)
    if spacing.shape not in ((), (2,)):
        raise RuntimeError(f"sampling: expected one number or two, got {sampling!r}")
    down, across = _arrays.spacing("sampling", np.broadcast_to(spacing, 2))
    found = _images.distances(_inputs.nonzero(picture), spacing=(down, across))
    if found.size > 0 and found.flat[0] == np.inf:
        rows, columns = np.ogrid[:found.shape[0], :found.shape[1]]
        found = np.sqrt(((rows + 1) * down)**2 + (columns * across)**2)
    return found


def _nearest(foreground: npt.NDArray[np.bool_]) -> npt.NDArray[np.int32]:
    """Rows and columns of the nearest background pixels.

    A pixel whose nearest one is in column u has a square smaller by at most 2 (x - u) - 1 to its left, and by at most
    2 (u - x) - 1 to its right, with equality where that neighbour has the same nearest one."""
    height, width = foreground.shape
    if foreground.all():
        return np.stack([np.full(foreground.shape, -1, np.int32), np.zeros(foreground.shape, np.int32)])
    y, x = (np.arange(size, dtype=np.int32) for size in foreground.shape)
    y, far = y[:, None], np.int32(2 * height + width)
    above = np.maximum.accumulate(np.where(foreground, -far, y))
    below = np.minimum.accumulate(np.where(foreground, far, y)[::-1])[::-1]
    rows = np.where(y - above <= below - y, above, below)
    vertical, squares = (rows - y).astype(np.int64)**2, _images.squared_distances(foreground)
    rise = np.diff(squares)
    columns, high = np.zeros_like(rows), np.full_like(rows, width - 1)
    columns[:, 1:] = np.maximum(x[1:] - (rise + 1) // 2, 0)
    high[:, :-1] = np.minimum(x[:-1] - rise // 2, width - 1)
    at = np.nonzero(np.take_along_axis(vertical, columns, 1) + (x - columns)**2 != squares)
    firsts = columns[at]
    lengths = high[at] - firsts + 1
    owners = np.repeat(np.arange(len(lengths)), lengths)
    candidates = np.arange(len(owners)) - (np.cumsum(lengths) - lengths - firsts)[owners]
    line, column = at[0][owners], at[1][owners]
    right = np.flatnonzero(vertical[line, candidates] + (candidates - column)**2 == squares[line, column])
    columns[at] = candidates[right[np.diff(owners[right], prepend=-1) > 0]]
    return np.stack([np.take_along_axis(rows, columns, 1), columns])
