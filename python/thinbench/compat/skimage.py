"""scikit-image's `thin`, `skeletonize`, `label`, `regionprops_table`, `remove_small_objects` and
`remove_small_holes`, for images."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _images
from thinbench._thinning import thin as _thin
from thinbench.compat import _inputs, _label_tables


def thin(image: npt.ArrayLike, max_num_iter: int | None = None, *,
         max_iter: int | None = None) -> npt.NDArray[np.bool_]:
    """Thin an image as `skimage.morphology.thin` does, pixel for pixel.

    Parameters
    ----------
    image : array, shape (H, W)
        Nonzero is foreground.
    max_num_iter : int, optional
        Stop after this many iterations. None and 0: until nothing changes.
    max_iter
        The old name of `max_num_iter`.

    Returns
    -------
    array of bool, shape (H, W)

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit, also for an empty image, as in scikit-image.

    References
    ----------
    docs/thinning.md: the rule "guo_hall_skimage". Everything outside the image is background.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> print(skimage.thin(np.ones((3, 5)))[1].astype(int))
    [0 1 1 1 0]
    """
    if max_iter is not None:
        warnings.warn("`max_iter` is now named `max_num_iter`", FutureWarning, stacklevel=2)
        max_num_iter = max_iter
    picture: Any = _inputs.as_bool(image)
    if picture.size == 0:
        raise ValueError(f"image: expected an image with pixels, got shape {picture.shape}")
    limit = None if max_num_iter is None else _arrays.integer("max_num_iter", max_num_iter)
    if limit is not None and limit < 0:
        raise ValueError(f"max_num_iter: expected at least 0, got {limit}")
    return _thin(picture, "guo_hall_skimage", max_iterations=limit or None, out=picture)


def skeletonize(image: npt.ArrayLike, *, method: str | None = None) -> npt.NDArray[np.bool_]:
    """Thin an image as `skimage.morphology.skeletonize` does in 2-D, pixel for pixel.

    Parameters
    ----------
    image : array, shape (H, W)
        Nonzero is foreground, as in scikit-image 0.20. 0.19 rejects other integers than 0 and 1, and takes
        fractions below 1 as 0.
    method : {None, "zhang"}

    Returns
    -------
    array of bool, shape (H, W)

    Raises
    ------
    NotImplementedError
        For the method "lee", which is in scikit-image.
    ValueError
        For another method, or if the image has not two dimensions.

    References
    ----------
    docs/thinning.md: the rule "zhang_suen_skimage". Everything outside the image is background.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> print(skimage.skeletonize(np.ones((3, 5)))[1].astype(int))
    [1 1 1 0 0]
    """
    array = _arrays.as_array("image", image)
    if method == "lee" or (method is None and array.ndim == 3):
        raise NotImplementedError(f"method: 'lee' is not here{_arrays.channel_advice(array, 'image', True)}; "
                                  "use scikit-image's skimage.morphology.skeletonize")
    if method not in (None, "zhang"):
        raise ValueError(f"method: expected None or 'zhang', got {method!r}")
    picture: Any = _inputs.as_bool(array)
    return _thin(picture, "zhang_suen_skimage", out=picture)


def label(label_image: npt.ArrayLike, background: int | None = None, return_num: bool = False,
          connectivity: int | None = None) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]:
    """Label components of equal values as `skimage.measure.label` does in 2-D, number for number.

    Parameters
    ----------
    label_image : array of real numbers, shape (H, W)
        Floats count as the integers that they are truncated to.
    background : int, optional
        The value of background, which gets label 0. Default: 0.
    return_num : bool
        Also return the number of labels.
    connectivity : {1, 2}, optional
        1: pixels have 4 neighbours; 2, the default: 8.

    Returns
    -------
    array of shape (H, W), or a tuple of it and an int
        Labels from 1 in raster order of first pixels: int32 for an image of bool, else int64.

    Raises
    ------
    NotImplementedError
        For other than two dimensions, which are in scikit-image.
    TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> print(skimage.label(np.array([[1, 0, 2], [0, 1, 2]])))
    [[1 0 2]
     [0 1 2]]
    """
    picture = _inputs.picture_of(label_image, "label_image", "skimage.measure.label")
    if connectivity not in (None, 1, 2):
        raise ValueError(f"connectivity: expected 1 or 2, got {connectivity!r}")
    neighbours: Literal[4, 8] = 4 if connectivity == 1 else 8
    if picture.dtype == bool:
        labels, count = _images.label_image(~picture if background == 1 else picture, connectivity=neighbours)
        return (labels, count) if return_num else labels
    if background is None:
        background = 0
    if not math.isfinite(_arrays.real("background", background)):  # int() reads strings, too
        raise ValueError(f"background: expected a finite number, got {background}")
    labels, count = _label_values(picture, int(background), neighbours)
    wide = labels.astype(np.intp)
    return (wide, count) if return_num else wide


def _label_values(picture: npt.NDArray[Any], background: int,
                  connectivity: Literal[4, 8]) -> tuple[npt.NDArray[np.int32], int]:
    """Bits where one value is foreground; else values, renumbered if they do not fit into int32."""
    whole = picture.astype(np.intp, copy=False) if picture.dtype.kind == "f" else picture
    foreground = whole != background
    if not foreground.any():
        return _images.label_image(foreground, connectivity=connectivity)
    first = whole[np.unravel_index(foreground.argmax(), whole.shape)]
    if not ((whole == first) != foreground).any():
        return _images.label_image(foreground, connectivity=connectivity)
    if -2**31 <= min(whole.min(), background) and max(whole.max(), background) < 2**31:
        return _images.label_values(whole, connectivity=connectivity, background=background)
    numbers = np.unique(whole, return_inverse=True)[1].reshape(whole.shape) + 1
    numbers[~foreground] = 0
    return _images.label_values(numbers, connectivity=connectivity)


def remove_small_objects(ar: npt.ArrayLike, min_size: float = 64, connectivity: int = 1, *,
                         out: npt.NDArray[Any] | None = None) -> npt.NDArray[Any]:
    """Remove objects below a size as `skimage.morphology.remove_small_objects` does in 2-D, pixel for pixel.

    Parameters
    ----------
    ar : array of bool or of integers, shape (H, W)
        Objects, or labels of at least 0, which need not be connected.
    min_size : number
        The area of the smallest object that stays; 0 removes nothing, and takes any integers.
    connectivity : {1, 2}
        Of objects: pixels have 4 or 8 neighbours.
    out : array, optional
        Receives the result; may be `ar`.

    Returns
    -------
    array of the shape and dtype of `ar`
        False or 0 where objects were removed.

    Raises
    ------
    NotImplementedError
        For other than two dimensions, which are in scikit-image.
    TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> print(skimage.remove_small_objects(np.array([[1, 1, 0, 1]], bool), 2)[0])
    [ True  True False False]
    """
    picture = _of_objects(ar, "skimage.morphology.remove_small_objects")
    if connectivity not in (1, 2):
        raise ValueError(f"connectivity: expected 1 or 2, got {connectivity!r}")
    least = _arrays.real("min_size", min_size)
    result = _arrays.result_for(picture, out)
    if least == 0:  # as in scikit-image, also of negative numbers
        np.copyto(result, picture)
        return result
    if picture.dtype.kind == "i" and picture.size and picture.min() < 0:
        raise ValueError(f"ar: expected labels of at least 0, got {picture.min()}; `skimage.label` makes them")
    if picture.dtype == bool:
        labels, (objects, _) = _images.numbered_objects(picture, 4 if connectivity == 1 else 8)
        areas = np.append(0, objects["area"])
    elif picture.dtype.kind == "u" and picture.itemsize == 8:  # may be too large for an index
        _, places, areas = np.unique(picture, return_inverse=True, return_counts=True)
        labels = places.reshape(picture.shape)
    else:
        labels, areas = picture, np.bincount(picture.ravel())
    np.multiply(picture, ~(areas < least)[labels], out=result, casting="unsafe")
    return result


def remove_small_holes(ar: npt.ArrayLike, area_threshold: float = 64, connectivity: int = 1, *,
                       out: npt.NDArray[np.bool_] | None = None) -> npt.NDArray[np.bool_]:
    """Fill background below an area as `skimage.morphology.remove_small_holes` does in 2-D, pixel for pixel.

    Parameters
    ----------
    ar : array of bool or of integers, shape (H, W)
        Nonzero is foreground.
    area_threshold : number
        The area of the smallest component of background that stays, also of those at the border.
    connectivity : {1, 2}
        Of background: pixels have 4 or 8 neighbours.
    out : array of bool, optional
        Receives the result; may be `ar`.

    Returns
    -------
    array of bool, shape (H, W)

    Raises
    ------
    NotImplementedError
        For other than two dimensions, which are in scikit-image.
    TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> print(skimage.remove_small_holes(np.array([[1, 0, 1, 0, 0]], bool), 2)[0])
    [ True  True  True False False]
    """
    picture = _of_objects(ar, "skimage.morphology.remove_small_holes")
    _arrays.real("area_threshold", area_threshold)
    background = picture == 0
    result: npt.NDArray[np.bool_] = _arrays.result_for(background, out)
    np.logical_not(remove_small_objects(background, area_threshold, connectivity), out=result)
    return result


def _of_objects(ar: npt.ArrayLike, original: str) -> npt.NDArray[Any]:
    picture = _inputs.picture_of(ar, "ar", original)
    if picture.dtype.kind not in "biu":
        raise TypeError(f"ar: expected bool or integers, got {picture.dtype}; `ar > threshold` makes one")
    return picture


def regionprops_table(label_image: npt.ArrayLike, intensity_image: npt.ArrayLike | None = None,
                      properties: Sequence[str] = ("label", "bbox"), *, cache: bool = True,
                      separator: str = "-", extra_properties: None = None) -> dict[str, npt.NDArray[Any]]:
    """Measure labels as `skimage.measure.regionprops_table` does in 2-D.

    Parameters
    ----------
    label_image : array of integers, shape (H, W)
        Labels above 0 are measured. They need be neither consecutive nor connected.
    intensity_image : array of real numbers, shape (H, W), optional
        What "intensity_max", "intensity_mean", "intensity_min" and "centroid_weighted" measure.
    extra_properties
        Not here.
    properties : sequence of {"label", "area", "area_bbox", "area_filled", "axis_major_length", "axis_minor_length", \
"bbox", "centroid", "centroid_weighted", "eccentricity", "equivalent_diameter_area", "euler_number", "extent", \
"inertia_tensor", "inertia_tensor_eigvals", "intensity_max", "intensity_mean", "intensity_min", "orientation", \
"perimeter"}
        Also by scikit-image's old names, such as "filled_area".
    cache
        Without effect.
    separator : str
        Between the name and the index in the names of columns, such as "bbox-0".

    Returns
    -------
    dict of arrays
        One element per label in ascending order: scikit-image's numbers, those of float64 that come from sums of
        squares, roots or real intensities but for rounding. 8-connected objects and 4-connected holes count for
        "euler_number"; "area_filled" has 4-connected objects. "orientation" is pi / 4 or -pi / 4 where rows and
        columns vary alike, as of discs; there scikit-image's comes from rounding.

    Raises
    ------
    NotImplementedError
        For other properties and for other than two dimensions, which are in scikit-image.
    TypeError, ValueError
        If the labels are not integers, and if the intensities have another shape or are needed but not given.

    Examples
    --------
    >>> import numpy as np
    >>> from thinbench.compat import skimage
    >>> labels = np.array([[1, 1, 1, 0], [1, 0, 1, 0], [1, 1, 1, 2]])
    >>> skimage.regionprops_table(labels, properties=("area", "euler_number"))
    {'area': array([8, 1]), 'euler_number': array([0, 1])}
    """
    name = "skimage.measure.regionprops_table"
    picture = _inputs.picture_of(label_image, "label_image", name)
    if picture.dtype.kind not in "iu":
        raise TypeError(f"label_image: expected integers, got {picture.dtype}; `skimage.label` makes them")
    if extra_properties is not None:
        raise NotImplementedError(f"extra_properties: not here; use {name}")
    intensities = None if intensity_image is None else _inputs.picture_of(intensity_image, "intensity_image", name)
    if intensities is not None and intensities.shape != picture.shape:
        raise ValueError(f"intensity_image: expected shape {picture.shape}, got {intensities.shape}")
    return _label_tables.measured(picture, intensities, properties, _arrays.text("separator", separator), name)
