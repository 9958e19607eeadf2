"""Steps of one call on arrays: the package, and what gives the same by OpenCV, scikit-image or SciPy."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt
from scipy import ndimage
from skimage import measure, morphology

import thinbench
from report.many_images.inputs import Image
from report.many_images.steps import CALLS, Figures, Key, Step
from thinbench import compat

SECONDS = 0.1
"""Of calls in a round; at least one."""

SMALL, COUNT = 28, 10000
"""Side and number of small images."""

COLUMNS = ("area", "bbox")
"""Of the table of regions, those that are integers."""

Binary = npt.NDArray[np.bool_]
Call = Callable[[], Any]


def call_steps(scene: Image) -> list[Step]:
    """On one thread; the scene is binary."""
    steps = []
    for ours, theirs in pairs(scene != 0):
        (base, *_), calls = ours, ours | theirs
        for name, call in calls.items():
            timed = _TimedCall(call)
            steps.append(Step(Key(CALLS, name), Key(CALLS, base), timed.run, timed.digest))
    return steps


def pairs(image: Binary) -> list[tuple[dict[str, Call], dict[str, Call]]]:
    """By name; each of ours with calls that give the same."""
    grey, packed, width = image * np.uint8(255), np.packbits(image, axis=1), image.shape[1]
    windows = np.lib.stride_tricks.sliding_window_view(image, (SMALL, SMALL))[::3, ::3]
    stack = np.ascontiguousarray(windows.reshape(-1, SMALL, SMALL)[:COUNT])
    return [
        ({"compat.cv2.thinning": partial(compat.cv2.thinning, grey)},
         {"cv2.ximgproc.thinning": partial(cv2.ximgproc.thinning, grey)}),
        ({"compat.cv2.thinning, Guo-Hall": partial(compat.cv2.thinning, grey, thinningType=1)},
         {"cv2.ximgproc.thinning, Guo-Hall": partial(cv2.ximgproc.thinning, grey, thinningType=1)}),
        ({"compat.skimage.thin": partial(compat.skimage.thin, image)},
         {"skimage.morphology.thin": partial(morphology.thin, image)}),
        ({"compat.skimage.skeletonize": partial(compat.skimage.skeletonize, image)},
         {"skimage.morphology.skeletonize": partial(morphology.skeletonize, image)}),
        ({"thin_packed": partial(thinbench.thin_packed, packed, width)},
         {"unpackbits, thin, packbits": lambda: np.packbits(
             thinbench.thin(np.unpackbits(packed, axis=1, count=width)) != 0, axis=1)}),
        ({"fill_holes": partial(thinbench.fill_holes, image)},
         {"ndimage.binary_fill_holes": partial(ndimage.binary_fill_holes, image)}),
        ({"find_regions": partial(thinbench.find_regions, image)},
         {"ndimage.label and regionprops_table": partial(_regionprops, image)}),
        ({f"thin of a stack of {COUNT:,}": partial(thinbench.thin, stack, "zhang_suen_skimage")},
         {"a loop over thin": lambda: [thinbench.thin(one, "zhang_suen_skimage") for one in stack],
          "a loop over skeletonize": lambda: [morphology.skeletonize(one) for one in stack]}),
    ]


def _regionprops(image: Binary) -> Any:
    labels, _ = ndimage.label(image, np.ones((3, 3)))
    return measure.regionprops_table(labels, properties=COLUMNS)


class _TimedCall:
    """Wall time of each call, as the sampler takes it."""

    def __init__(self, call: Call) -> None:
        self.call = call
        self.latest: Any = None

    def run(self) -> Figures:
        """The first call, which finds cold caches, is an epoch like the others."""
        epochs: list[float] = []
        end = time.perf_counter() + SECONDS
        while not epochs or time.perf_counter() < end:
            start = time.perf_counter()
            self.latest = self.call()
            epochs.append(1e3 * (time.perf_counter() - start))
        return {"ms_per_call": epochs}

    def digest(self) -> str:
        """Of pixels, or of what integers a table has on objects."""
        if isinstance(self.latest, dict):
            objects = ~self.latest.get("is_hole", np.zeros(len(self.latest["area"]), bool))
            text = repr([column[objects].astype(int).tolist()
                         for name, column in sorted(self.latest.items())
                         if name.split("-")[0] in COLUMNS])
            return hashlib.sha256(text.encode()).hexdigest()
        found = np.asarray(self.latest)
        return hashlib.sha256(np.where(found == 255, 1, found).astype(np.uint8).tobytes()).hexdigest()
