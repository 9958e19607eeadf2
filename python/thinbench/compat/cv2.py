"""OpenCV's `connectedComponents`, also with statistics and algorithm, and `distanceTransform`, and
`ximgproc.thinning`, which many builds of OpenCV lack."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _images
from thinbench._thinning import thin

THINNING_ZHANGSUEN = 0
THINNING_GUOHALL = 1
CC_STAT_LEFT, CC_STAT_TOP, CC_STAT_WIDTH, CC_STAT_HEIGHT, CC_STAT_AREA, CC_STAT_MAX = range(6)
CV_8U, CV_16U, CV_32S, CV_32F = 0, 2, 4, 5
CCL_DEFAULT, CCL_WU, CCL_GRANA, CCL_BOLELLI, CCL_SAUF, CCL_BBDT, CCL_SPAGHETTI = range(-1, 6)
DIST_L1, DIST_L2, DIST_C = 1, 2, 3
DIST_MASK_PRECISE, DIST_MASK_3, DIST_MASK_5 = 0, 3, 5
_ONE = 1 << 16  # of OpenCV's distances by steps
_STEPS = {DIST_L1: (1.0, 2.0), DIST_C: (1.0, 1.0), (DIST_L2, DIST_MASK_3): (0.955, 1.3693),
          (DIST_L2, DIST_MASK_5): (1.0, 1.4, 2.1969)}  # to a neighbour, a diagonal one, and by a knight's move
_NO_BACKGROUND = np.float32(1e15) ** 0.5  # OpenCV's infinity
_LABEL_TYPES: dict[int, np.dtype[Any]] = {CV_32S: np.dtype(np.int32), CV_16U: np.dtype(np.uint16)}
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
        Receives the result: same shape, C-contiguous. May be `src`. (OpenCV returns a new array if
        the shape differs.)
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

    References
    ----------
    docs/thinning.md: the rules "zhang_suen" and "guo_hall", with border "keep".

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import cv2
    >>> block = np.pad(np.full((3, 5), 255, np.uint8), 1)
    >>> print(cv2.thinning(block)[2])
    [  0   0 255 255   0   0   0]
    """
    image = _grey(src, "src")
    rule = _RULES.get(_arrays.integer("thinningType", thinningType))
    if rule is None:
        raise ValueError(f"thinningType: expected 0 (Zhang-Suen) or 1 (Guo-Hall), "
                         f"got {thinningType}")
    foreground = np.bitwise_and(image, _HIGH_BIT, order="C")
    if dst is not None:
        _arrays.result_for(image, dst, "dst")
    return thin(foreground, rule, border="keep", out=foreground if dst is None else dst)


def connectedComponents(image: npt.ArrayLike, labels: npt.NDArray[Any] | None = None,  # noqa: N802
                        connectivity: int = 8, ltype: int = CV_32S) -> tuple[int, npt.NDArray[Any]]:
    """Label objects as OpenCV's `connectedComponents` does by default, number for number.

    Parameters
    ----------
    image : array of uint8 or int8, shape (H, W)
        Nonzero is foreground.
    labels : array of the type of the labels, optional
        Receives them: same shape, C-contiguous. (OpenCV returns a new array if the shape differs.)
    connectivity : {8, 4}
    ltype : {CV_32S, CV_16U}
        The type of the labels: int32 or uint16.

    Returns
    -------
    int, and array of shape (H, W)
        The number of labels with that of the background, 0, and the labels: for 4-connected objects in
        raster order of first pixels, for 8-connected ones in that of first blocks of 2 x 2 pixels.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit, also for an empty image and for more labels than `ltype` has.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import cv2
    >>> count, labels = cv2.connectedComponents(np.array([[0, 0, 0, 1], [1, 0, 0, 0]], np.uint8))
    >>> print(count, labels[0], labels[1])
    3 [0 0 0 2] [1 0 0 0]
    """
    found, objects = _images.numbered(*_checked(image, connectivity, ltype))
    return objects + 1, _converted(found, objects, ltype, labels)


def connectedComponentsWithAlgorithm(image: npt.ArrayLike, connectivity: int, ltype: int,  # noqa: N802
                                     ccltype: int, labels: npt.NDArray[Any] | None = None,
                                     ) -> tuple[int, npt.NDArray[Any]]:
    """Label objects as OpenCV's `connectedComponentsWithAlgorithm` does, number for number.

    Parameters
    ----------
    image, connectivity, ltype, labels
        As in `connectedComponents`.
    ccltype : {CCL_DEFAULT, CCL_WU, CCL_GRANA, CCL_BOLELLI, CCL_SAUF, CCL_BBDT, CCL_SPAGHETTI}
        With CCL_WU and CCL_SAUF also 8-connected objects are in raster order of first pixels.

    Returns
    -------
    int, and array of shape (H, W)
        As from `connectedComponents`.

    Raises
    ------
    TypeError, ValueError
        As `connectedComponents`, and for other algorithms.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import cv2
    >>> image = np.array([[0, 0, 0, 1], [1, 0, 0, 0]], np.uint8)
    >>> print(cv2.connectedComponentsWithAlgorithm(image, 8, cv2.CV_32S, cv2.CCL_SAUF)[1][0])
    [0 0 0 1]
    """
    if ccltype not in range(CCL_DEFAULT, CCL_SPAGHETTI + 1):
        raise ValueError(f"ccltype: expected -1 (CCL_DEFAULT) to 5 (CCL_SPAGHETTI), got {ccltype!r}")
    picture, neighbours, order = _checked(image, connectivity, ltype)
    found, objects = _images.numbered(picture, neighbours, None if ccltype in (CCL_WU, CCL_SAUF) else order)
    return objects + 1, _converted(found, objects, ltype, labels)


def connectedComponentsWithStats(  # noqa: N802
        image: npt.ArrayLike, labels: npt.NDArray[Any] | None = None, stats: npt.NDArray[np.int32] | None = None,
        centroids: npt.NDArray[np.float64] | None = None, connectivity: int = 8, ltype: int = CV_32S,
        ) -> tuple[int, npt.NDArray[Any], npt.NDArray[np.int32], npt.NDArray[np.float64]]:
    """Label and measure objects as OpenCV's `connectedComponentsWithStats` does, number for number.

    Parameters
    ----------
    image, labels, connectivity, ltype
        As in `connectedComponents`.
    stats, centroids
        Not here: only None.

    Returns
    -------
    int, array of shape (H, W), array of int32, shape (N, 5), and array of float64, shape (N, 2)
        Number and labels as from `connectedComponents`; for each label, the background first, the first
        column and row, width, height and area, at the indices CC_STAT_LEFT to CC_STAT_AREA; and the
        centre's x and y.

    Raises
    ------
    NotImplementedError
        For arrays for statistics, which OpenCV takes.
    TypeError, ValueError
        As `connectedComponents`.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import cv2
    >>> image = np.array([[0, 1, 1], [0, 1, 1]], np.uint8)
    >>> count, labels, stats, centroids = cv2.connectedComponentsWithStats(image)
    >>> print(stats[1], centroids[1])
    [1 0 2 2 4] [1.5 0.5]
    """
    if stats is not None or centroids is not None:
        raise NotImplementedError("stats, centroids: expected None; use cv2.connectedComponentsWithStats")
    found, (objects, number) = _images.numbered_objects(*_checked(image, connectivity, ltype))
    found = _converted(found, number, ltype, labels)
    count = number + 1
    table = np.empty((count, 5), np.int32)
    centres = np.empty((count, 2))
    table[0], centres[0] = _background(found, objects)
    table[1:, CC_STAT_LEFT] = objects["left"]
    table[1:, CC_STAT_TOP] = objects["top"]
    table[1:, CC_STAT_WIDTH] = objects["right"] - objects["left"] + 1
    table[1:, CC_STAT_HEIGHT] = objects["bottom"] - objects["top"] + 1
    table[1:, CC_STAT_AREA] = objects["area"]
    np.divide(objects["sum_x"], objects["area"], out=centres[1:, 0])
    np.divide(objects["sum_y"], objects["area"], out=centres[1:, 1])
    return count, found, table, centres


def distanceTransform(src: npt.ArrayLike, distanceType: int, maskSize: int,  # noqa: N802, N803
                      dst: npt.NDArray[np.float32] | None = None,
                      dstType: int = CV_32F) -> npt.NDArray[np.float32]:  # noqa: N803
    """Find distances to the background as OpenCV's `distanceTransform` does.

    Parameters
    ----------
    src : array of uint8, shape (H, W)
        Nonzero is foreground. At most 32767 pixels on a side with DIST_MASK_PRECISE.
    distanceType : {DIST_L2, DIST_L1, DIST_C}
        Euclidean; sum or maximum of the differences of rows and columns.
    maskSize : {DIST_MASK_PRECISE, DIST_MASK_3, DIST_MASK_5}
        For DIST_L2: exact, or by steps to neighbours, for 5 also by knight's moves. OpenCV's are ten times as fast.
    dst : array of float32, optional
        Receives the result: same shape, C-contiguous. (OpenCV returns a new array if the shape differs.)
    dstType : {CV_32F}

    Returns
    -------
    array of float32, shape (H, W)
        OpenCV's numbers, with DIST_MASK_PRECISE but for the last bit: there they are roots of exact integers, which
        become float32 first, and in an image without background the root of 1e15. Else 8192 is the most.

    Raises
    ------
    NotImplementedError
        For other types of distance, which are in OpenCV.
    TypeError, ValueError
        If an argument does not fit, also for an empty image.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import cv2
    >>> image = np.array([[0, 1, 1, 1]], np.uint8)
    >>> print(cv2.distanceTransform(image, cv2.DIST_L2, cv2.DIST_MASK_PRECISE))
    [[0. 1. 2. 3.]]
    """
    image = _grey(src, "src")
    for name, value, known in (("distanceType", distanceType, (DIST_L1, DIST_L2, DIST_C)),
                               ("maskSize", maskSize, (DIST_MASK_PRECISE, DIST_MASK_3, DIST_MASK_5)),
                               ("dstType", dstType, (CV_32F,))):
        if _arrays.integer(name, value) not in known:
            raise NotImplementedError(f"{name}: expected {' or '.join(map(str, known))}, got {value}; "
                                      "use cv2.distanceTransform")
    found = _arrays.result_for(image, dst, "dst", np.float32)
    if distanceType != DIST_L2 or maskSize != DIST_MASK_PRECISE:
        steps = _STEPS[distanceType if distanceType != DIST_L2 else (DIST_L2, maskSize)]
        return np.multiply(_by_steps(image != 0, steps), np.float32(1 / _ONE), out=found, casting="unsafe")
    squares = _images.squared_distances(image)
    if squares[0, 0] == np.iinfo(np.int32).max:
        found.fill(_NO_BACKGROUND)
        return found
    np.copyto(found, squares, casting="unsafe")
    return np.sqrt(found, out=found)


def _by_steps(foreground: npt.NDArray[np.bool_], steps: tuple[float, ...]) -> npt.NDArray[np.int64]:
    """The least sums of steps to background, in 1 / 65536. One pass has all steps that lead up or left, the other those
    that lead down or right."""
    side, diagonal, *knight = (round(step * _ONE) for step in steps)
    moves = [(1, -1, diagonal), (1, 0, side), (1, 1, diagonal)]
    if knight:
        moves += [(y, x, knight[0]) for y, x in ((2, -1), (2, 1), (1, -2), (1, 2))]
    height, width = foreground.shape
    most = np.int64(np.iinfo(np.int32).max >> 2)
    padded = np.full((height + 4, width + 4), most)
    padded[2:-2, 2:-2] = np.where(foreground, most, 0)
    ramp = side * np.arange(width)
    for turned in (padded, padded[::-1, ::-1]):
        for y in range(2, height + 2):
            row = turned[y, 2:-2]
            for up, across, step in moves:
                np.minimum(row, turned[y - up, 2 + across:width + 2 + across] + step, out=row)
            row -= ramp
            np.minimum.accumulate(row, out=row)
            row += ramp
    return padded[2:-2, 2:-2]


def _grey(source: npt.ArrayLike, name: str) -> npt.NDArray[np.uint8]:
    """An image of bytes with pixels."""
    image = _arrays.grey(source, name)
    if image.size == 0:
        raise ValueError(f"{name}: expected an image with pixels, got shape {image.shape}")
    return image


def _checked(source: npt.ArrayLike, connectivity: int, ltype: int) -> tuple[npt.NDArray[np.uint8], int, bytes]:
    """An image, the connectivity and the order of labels."""
    image = _arrays.as_array("image", source)
    connectivity = _arrays.integer("connectivity", connectivity)
    if connectivity not in (4, 8):
        raise ValueError(f"connectivity: expected 8 or 4, got {connectivity!r}")
    if _arrays.integer("ltype", ltype) not in _LABEL_TYPES:
        raise ValueError(f"ltype: expected {CV_32S} (CV_32S) or {CV_16U} (CV_16U), got {ltype!r}")
    return _grey(image.view(np.uint8) if image.dtype == np.int8 else image, "image"), connectivity, b"opencv"


def _converted(labels: npt.NDArray[np.int32], objects: int, ltype: int,
               out: npt.NDArray[Any] | None) -> npt.NDArray[Any]:
    """Labels of another type, in `out` if there is one."""
    dtype = _LABEL_TYPES[ltype]
    if objects > np.iinfo(dtype).max:
        raise ValueError(f"ltype: {objects} objects were found, and CV_16U holds numbers up to {np.iinfo(dtype).max}; "
                         "use CV_32S")
    if out is None and ltype == CV_32S:
        return labels
    result = _arrays.result_for(labels, out, "labels", dtype)
    np.copyto(result, labels, casting="unsafe")
    return result


def _background(labels: npt.NDArray[Any], objects: npt.NDArray[Any]) -> tuple[list[int], list[float]]:
    """Statistics and centre of what has label 0; without pixels, OpenCV's numbers."""
    height, width = labels.shape
    area = height * width - int(objects["area"].sum())
    if area == 0:
        return [-1, 2**31 - 1, 0, 0, 0], [np.nan, np.nan]
    left, right = _ends(labels.T)
    top, bottom = _ends(labels)
    sum_x = height * (width * (width - 1) // 2) - int(objects["sum_x"].sum())
    sum_y = width * (height * (height - 1) // 2) - int(objects["sum_y"].sum())
    return [left, top, right - left + 1, bottom - top + 1, area], [sum_x / area, sum_y / area]


def _ends(lines: npt.NDArray[Any]) -> tuple[int, int]:
    """The first and the last row or column that has background."""
    if not lines[0].all() and not lines[-1].all():
        return 0, len(lines) - 1
    found = np.flatnonzero((lines == 0).any(axis=1))
    return int(found[0]), int(found[-1])
