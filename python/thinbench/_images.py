"""Edges, objects and holes."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library

EDGE_OPERATORS = {name: name.encode()
                  for name in _library.all_names(_library.edge_operator_name)}
REGION = np.dtype([("area", "i8"), ("sum_x", "i8"), ("sum_y", "i8"), ("left", "i4"),
                    ("top", "i4"), ("right", "i4"), ("bottom", "i4"), ("enclosing_object", "u4"),
                    ("reserved", "u4")])

_ONE = np.array(1, np.int32)  # faster than a number of Python
_LISTS = _library.regions_objects, _library.regions_holes

Columns = dict[str, npt.NDArray[Any]]


class Regions(NamedTuple):
    """Objects, then holes, as an array of REGION, and the number of objects."""

    found: _arrays.Array
    objects: int


def detect_edges(image: npt.ArrayLike, operator: str = "sobel", gradient_threshold: int = 40,
                 brightness_threshold: int = 128, *, threads: int = 1,
                 out: npt.NDArray[np.uint8] | None = None) -> npt.NDArray[np.uint8]:
    """Find the edges of dark objects on a bright background.

    Parameters
    ----------
    image : array of uint8, shape (H, W)
        Grey levels, 0 is black. Never modified.
    operator : {"sobel", "prewitt", "roberts4", "roberts9", "mero_vassy", "mero_vassy_5x5"}
        The gradient operator; docs/edges.md has the masks.
    gradient_threshold, brightness_threshold : int
        An edge has a scaled gradient above the first and a pixel above the second in its 3 x 3
        neighbourhood. 0 to 255.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.
    out : array of uint8, optional
        Receives the result; C-contiguous, sharing no memory with the image.

    Returns
    -------
    array of uint8, shape (H, W)
        255 on edges, else 0. The border is no edge, as its pixels are repeated outside.

    References
    ----------
    Lazea, Mureşan and Lupu, "Image processing algorithms used in robotics applications", 1999,
    section 2.1.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> step = np.repeat(np.array([[0, 0, 0, 200, 200, 200]], np.uint8), 3, axis=0)
    >>> print(thinbench.detect_edges(step)[1])
    [  0   0 255 255   0   0]
    """
    image = _arrays.grey(image)
    name = _arrays.one_of("operator", operator, EDGE_OPERATORS)
    result = _arrays.result_for(image, out)
    _library.detect_edges(name, *_arrays.images(image, result),
                          _arrays.integer("gradient_threshold", gradient_threshold),
                          _arrays.integer("brightness_threshold", brightness_threshold),
                          _arrays.execution(threads))
    return result


def fill_holes(image: npt.ArrayLike, *, connectivity: Literal[4, 8] = 8,
               max_area: int | None = None, threads: int = 1,
               out: npt.NDArray[Any] | None = None) -> npt.NDArray[Any]:
    """Fill the holes of objects.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W)
        Nonzero is foreground. Never modified.
    connectivity : {8, 4}
        Of objects; holes have the other one.
    max_area : int, optional
        Fill only holes of at most so many pixels, 0 to 2**31 - 1, not counting objects inside them,
        which stay as they are.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.
    out : array, optional
        Receives the result: same shape and dtype as the image, C-contiguous. May be the image.

    Returns
    -------
    array of the shape and dtype of the image
        True or 255 on objects and everything they enclose: background stays background if it is
        4-connected to the border, for 4-connected objects 8-connected. As scipy's
        `binary_fill_holes`, there with a structure of ones.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> ring = np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]], bool)
    >>> print(thinbench.fill_holes(ring)[1])
    [ True  True  True]
    """
    image = _arrays.binary(image)
    result = _arrays.result_for(image, out)
    _library.fill_holes(*_arrays.images(image, result), _filling(connectivity, max_area),
                        _arrays.execution(threads))
    return result


def fill_holes_of_labels(labels: npt.ArrayLike, *, connectivity: Literal[4, 8] = 8, max_area: int | None = None,
                         threads: int = 1, out: npt.NDArray[Any] | None = None) -> npt.NDArray[Any]:
    """Fill the holes of every label of a label image.

    Parameters
    ----------
    labels : array of bool or integers, shape (H, W)
        0 is background. Never modified.
    connectivity, threads
        As in `fill_holes`, of labels.
    max_area : int, optional
        Fill only holes of which at most so many pixels, 0 to 2**31 - 1, are to be filled.
    out : array, optional
        Receives the result: same shape and dtype as `labels`, C-contiguous. May be `labels`.

    Returns
    -------
    array of the shape and dtype of `labels`
        Background in a hole of a label has this label, that of the innermost hole where labels are
        around each other. The holes of a label are those of `fill_holes(labels == label)`. Labels
        keep their pixels.

    Examples
    --------
    >>> import thinbench
    >>> print(thinbench.fill_holes_of_labels([[5, 5, 5, 2], [5, 0, 5, 2], [5, 5, 5, 0]]))
    [[5 5 5 2]
     [5 5 5 2]
     [5 5 5 0]]
    """
    image = _arrays.labels(labels)
    filling = _filling(connectivity, max_area)
    result = _arrays.result_for(image, out)
    source = _arrays.label_rows(image)
    target = result if result.dtype == np.int32 else np.empty(image.shape, np.int32)
    _library.fill_holes_of_labels(_arrays.numbers(source), _arrays.numbers(target), filling,
                                  _arrays.execution(threads))
    if target is not result:
        result[...] = target
    return result


def _filling(connectivity: int, max_area: int | None) -> bytes:
    area = _library.ANY_HOLE_AREA if max_area is None else _arrays.integer("max_area", max_area)
    return _library.hole_filling(_arrays.integer("connectivity", connectivity), area)


def euler_number(image: npt.ArrayLike, *, connectivity: Literal[4, 8] = 8, threads: int = 1) -> int:
    """Count objects minus holes.

    Parameters
    ----------
    image, connectivity, threads
        As in `fill_holes`.

    Returns
    -------
    int
        Everything outside the image is background.

    References
    ----------
    S. B. Gray, "Local properties of binary images in two dimensions", IEEE Transactions on
    Computers C-20(5), 1971.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> thinbench.euler_number(np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]], bool))
    0
    """
    image = _arrays.binary(image)
    number = ctypes.c_int64()
    _library.euler_number(_arrays.image(image), _arrays.integer("connectivity", connectivity),
                          _arrays.execution(threads), ctypes.byref(number))
    return number.value


def label_image(image: npt.ArrayLike, *, connectivity: Literal[4, 8] = 8,
                threads: int = 1) -> tuple[npt.NDArray[np.int32], int]:
    """Label objects.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W)
        Nonzero is foreground. At most 2**31 pixels.
    connectivity, threads
        As in `fill_holes`.

    Returns
    -------
    array of int32, shape (H, W), and int
        The number of each pixel's object, from 1 in raster order of first pixels, 0 in the
        background; and the number of objects. As scipy's `label`, whose structure is 4-connected
        by default.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> labels, count = thinbench.label_image(np.array([[1, 0, 1], [0, 1, 0]], bool), connectivity=4)
    >>> print(labels, count)
    [[1 0 2]
     [0 3 0]] 3
    """
    return numbered(image, _arrays.integer("connectivity", connectivity),
                    execution=_arrays.execution(threads))


def label_values(image: npt.ArrayLike, *, connectivity: Literal[4, 8] = 8,
                 background: int = 0) -> tuple[npt.NDArray[np.int32], int]:
    """Label components of equal values, such as the parts of each label of a label image.

    Parameters
    ----------
    image : array of bool or integers, shape (H, W)
        All values fit into int32. At most 2**31 pixels.
    connectivity : {8, 4}
        Of components.
    background : int
        Pixels of this value get label 0.

    Returns
    -------
    array of int32, shape (H, W), and int
        The number of each pixel's component, from 1 in raster order of first pixels, and the number of
        components. As scikit-image's `measure.label`.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> labels, count = thinbench.label_values(np.array([[7, 7, 2], [0, 0, 7]]))
    >>> print(labels, count)
    [[1 1 2]
     [0 0 1]] 2
    """
    values = _arrays.label_rows(_arrays.labels(image, "image"))
    labels = np.empty(values.shape, np.int32)
    components = ctypes.c_uint32()
    _library.label_values(_arrays.numbers(values), _arrays.numbers(labels),
                          _arrays.integer("connectivity", connectivity), _arrays.integer("background", background),
                          None, ctypes.byref(components))
    return labels, components.value


def numbered(image: npt.ArrayLike, connectivity: int, order: bytes | None = None,
             execution: bytes | None = None) -> tuple[npt.NDArray[np.int32], int]:
    """As `label_image`; `order` and `execution` as in the C interface."""
    image = _arrays.binary(image)
    labels = np.empty(image.shape, np.int32)
    objects = ctypes.c_uint32()
    _library.label_image(_arrays.image(image), _arrays.numbers(labels), connectivity, order, execution,
                         ctypes.byref(objects))
    return labels, objects.value


def numbered_objects(image: npt.ArrayLike, connectivity: int, order: bytes | None = None,
                     execution: bytes | None = None) -> tuple[npt.NDArray[np.int32], Regions]:
    """As `numbered`, but instead of their number the objects."""
    image = _arrays.binary(image)
    labels = np.empty(image.shape, np.int32)
    return labels, _regions(_library.label_objects, _arrays.image(image), _arrays.numbers(labels), connectivity, order,
                            execution)


def distances(image: npt.ArrayLike, *, spacing: float | Sequence[float] = 1, threads: int = 1,
              out: npt.NDArray[np.float64] | None = None) -> npt.NDArray[np.float64]:
    """Find the Euclidean distance from each pixel to its nearest background pixel.

    Distances are between centres of pixels; background has 0. What is outside the image does not
    count, as in `scipy.ndimage.distance_transform_edt`, which gives the same array.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W)
        Nonzero is foreground. At most 32767 pixels on a side.
    spacing : float or two floats
        The distance between the centres of neighbouring rows, and of neighbouring columns.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.
    out : array of float64, optional
        Receives the result; C-contiguous. It spares large images fresh memory.

    Returns
    -------
    array of float64, shape (H, W)
        Infinity in an image without background.

    References
    ----------
    A. Meijster, J. Roerdink and W. Hesselink 2000, "A general algorithm for computing distance
    transforms in linear time".

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> print(thinbench.distances(np.array([[0, 1, 1, 1]], bool), spacing=2))
    [[0. 2. 4. 6.]]
    """
    array = _arrays.binary(image)
    units = _library.spacing(*_arrays.spacing("spacing", spacing))
    execution = _arrays.execution(threads)
    found = _arrays.result_for(array, out, dtype=np.float64)
    _library.distances(_arrays.image(array), _arrays.numbers(found), units, execution)
    return found


def squared_distances(image: npt.ArrayLike, *, threads: int = 1,
                      out: npt.NDArray[np.int32] | None = None) -> npt.NDArray[np.int32]:
    """Find the squares of `distances` in pixels, which are exact integers.

    Parameters
    ----------
    image, threads
        As in `distances`.
    out : array of int32, optional
        Receives the result; C-contiguous.

    Returns
    -------
    array of int32, shape (H, W)
        2**31 - 1 in an image without background.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> print(thinbench.squared_distances(np.array([[0, 1, 1, 1], [1, 1, 1, 1]], bool)))
    [[ 0  1  4  9]
     [ 1  2  5 10]]
    """
    array = _arrays.binary(image)
    execution = _arrays.execution(threads)
    found = _arrays.result_for(array, out, dtype=np.int32)
    _library.squared_distances(_arrays.image(array), _arrays.numbers(found), execution)
    return found


def find_regions(image: npt.ArrayLike, *, threads: int = 1) -> Columns:
    """Find objects and holes.

    An object is an 8-connected component of the foreground. A hole is a 4-connected component of
    the background that does not touch the border. Everything outside the image is background.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W)
        Nonzero is foreground. At most 2**29 pixels on a side.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.

    Returns
    -------
    dict of arrays
        One element per region, objects first, each list in raster order of first pixels:
        "label" from 1; "enclosing_object", of a hole the label of the object around it, else 0; "area";
        "centroid-0" and "centroid-1" (row, column); "bbox-0" to "bbox-3" (first row, first column,
        last row + 1, last column + 1); "is_hole".

    References
    ----------
    docs/regions.md: labelled runs, joined by union-find; runs as bits for labels.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> ring = np.array([[1, 1, 1, 0], [1, 0, 1, 0], [1, 1, 1, 0]], bool)
    >>> table = thinbench.find_regions(ring)
    >>> print(table["area"], table["is_hole"], table["enclosing_object"])
    [8 1] [False  True] [0 1]
    """
    image = _arrays.binary(image)
    return columns(_regions(_library.find_regions, _arrays.image(image), _arrays.execution(threads)))


def label_regions(image: npt.ArrayLike, *, threads: int = 1) -> tuple[npt.NDArray[np.int32], Columns]:
    """Find objects and holes, and label their pixels.

    Returns an array of int32, shape (H, W): the label of each pixel's region, or 0; and the table of `find_regions`.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> ring = np.array([[1, 1, 1, 0], [1, 0, 1, 0], [1, 1, 1, 0]], bool)
    >>> labels, table = thinbench.label_regions(ring)
    >>> print(labels)
    [[1 1 1 0]
     [1 2 1 0]
     [1 1 1 0]]
    """
    found, labels = regions_and_labels(_arrays.binary(image), _arrays.execution(threads))
    return labels, columns(found)


def find_objects(image: npt.ArrayLike, *, threads: int = 1) -> Columns:
    """Find objects alone: the rows of `find_regions` that are no holes, in less time.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> print(thinbench.find_objects(np.array([[1, 1, 0, 1]], bool))["area"])
    [2 1]
    """
    image = _arrays.binary(image)
    return columns(_regions(_library.find_objects, _arrays.image(image), _arrays.execution(threads)))


def label_objects(image: npt.ArrayLike, *, connectivity: Literal[4, 8] = 8,
                  threads: int = 1) -> tuple[npt.NDArray[np.int32], Columns]:
    """Find objects alone, and label their pixels.

    Returns the labels of `label_image`, and the table of `find_objects`, or that of 4-connected objects.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> labels, table = thinbench.label_objects(np.array([[1, 1, 0, 1]], bool))
    >>> print(table["area"], labels)
    [2 1] [[1 1 0 2]]
    """
    labels, found = numbered_objects(image, _arrays.integer("connectivity", connectivity),
                                     execution=_arrays.execution(threads))
    return labels, columns(found)


def regions_and_labels(image: _arrays.Array,
                       execution: bytes | None = None) -> tuple[Regions, npt.NDArray[np.int32]]:
    """Of an image that is checked."""
    labels = np.empty(image.shape, np.int32)
    return _regions(_library.label_regions, _arrays.image(image), _arrays.numbers(labels), execution), labels


def _regions(find: Callable[..., None], *arguments: Any) -> Regions:
    """What a function of the C interface finds in images that live as long as the call."""
    handle = ctypes.c_void_p()
    find(*arguments, ctypes.byref(handle))
    try:
        found, (objects, _) = _library.copied(handle, _LISTS, REGION)
    finally:
        _library.regions_destroy(handle)
    return Regions(found, objects)


def localise_objects(image: npt.ArrayLike, gradient_threshold: int = 40, brightness_threshold: int = 128,
                     *, threads: int = 1) -> Columns:
    """Find dark objects and their holes in a grey image, by their edges.

    Finds edges by Sobel's operator, fills their contours, and returns the regions of the result.
    Areas include the width of the edges; centres are unbiased.

    Parameters
    ----------
    image : array of uint8, shape (H, W)
        Grey levels of dark objects on a bright background.
    gradient_threshold, brightness_threshold, threads
        As in `detect_edges`.

    Returns
    -------
    dict of arrays
        As `find_regions`. Beyond the image border its pixels are repeated.

    References
    ----------
    Lazea, Mureşan and Lupu, "Image processing algorithms used in robotics applications", 1999,
    section 2.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> picture = np.full((20, 20), 255, np.uint8)
    >>> picture[5:15, 5:15] = 0
    >>> found = thinbench.localise_objects(picture)
    >>> print(found["centroid-0"], found["is_hole"])
    [9.5] [False]
    """
    image = _arrays.grey(image)
    return columns(_regions(_library.localise_objects, _arrays.image(image), None,
                            _arrays.integer("gradient_threshold", gradient_threshold),
                            _arrays.integer("brightness_threshold", brightness_threshold), _arrays.execution(threads)))


def columns(regions: Regions) -> Columns:
    """As a dict of columns."""
    found, objects = regions
    area = found["area"]
    divisor = area.astype(np.float64)
    is_hole = np.zeros(len(found), bool)
    is_hole[objects:] = True
    return {
        "label": np.arange(1, len(found) + 1, dtype=np.int32),
        "enclosing_object": found["enclosing_object"].astype(np.int32),
        "area": area.copy(),
        "centroid-0": found["sum_y"] / divisor,
        "centroid-1": found["sum_x"] / divisor,
        "bbox-0": found["top"].copy(),
        "bbox-1": found["left"].copy(),
        "bbox-2": found["bottom"] + _ONE,
        "bbox-3": found["right"] + _ONE,
        "is_hole": is_hole,
    }
