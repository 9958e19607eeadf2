"""Times the Python package beside OpenCV, scikit-image and SciPy, in one process and one thread.

Outputs are compared first. Calls alternate; a ratio is that of the minimum times.

Usage: PYTHONPATH=build/release/python python3 bench/python/compare.py [IMAGE]
IMAGE is results/pictures/scene.jpg unless given; pixels below 128 are foreground.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import cv2
import numpy as np
from scipy import ndimage
from skimage import measure, morphology

import thinbench
from thinbench import compat

SCENE = Path(__file__).resolve().parents[2] / "results" / "pictures" / "scene.jpg"
SECONDS = 2.0  # per pair


class Pair(NamedTuple):
    name: str
    ours: Callable[[], Any]
    theirs: Callable[[], Any]
    equal: Callable[[Any, Any], bool] = np.array_equal


def min_times(pair: Pair) -> tuple[float, float]:
    """The minimum time of each, over alternating calls; ours is called 20 times as often."""
    best = [float("inf"), float("inf")]
    end = time.perf_counter() + SECONDS
    while time.perf_counter() < end:
        for index, (call, repeats) in enumerate([(pair.ours, 20), (pair.theirs, 1)]):
            for _ in range(repeats):
                start = time.perf_counter()
                call()
                best[index] = min(best[index], time.perf_counter() - start)
    return best[0], best[1]


def tables_equal(ours: dict[str, np.ndarray], theirs: dict[str, np.ndarray]) -> bool:
    objects = ~ours["is_hole"]
    return all(np.allclose(ours[name][objects], theirs[name]) for name in theirs)


def regionprops(image: np.ndarray) -> dict[str, np.ndarray]:
    labels, _ = ndimage.label(image, np.ones((3, 3)))
    return measure.regionprops_table(labels, properties=("area", "centroid", "bbox"))


def pairs(image: np.ndarray) -> list[Pair]:
    grey = image * np.uint8(255)
    small = np.lib.stride_tricks.sliding_window_view(image, (28, 28))[::3, ::3]
    stack = np.ascontiguousarray(small.reshape(-1, 28, 28)[:10000])
    blank = np.zeros((28, 28), bool)
    return [
        Pair("cv2.ximgproc.thinning, Zhang-Suen", lambda: compat.cv2.thinning(grey),
             lambda: cv2.ximgproc.thinning(grey)),
        Pair("cv2.ximgproc.thinning, Guo-Hall",
             lambda: compat.cv2.thinning(grey, thinningType=1),
             lambda: cv2.ximgproc.thinning(grey, thinningType=1)),
        Pair("skimage.morphology.thin", lambda: compat.skimage.thin(image),
             lambda: morphology.thin(image)),
        Pair("skimage.morphology.skeletonize", lambda: compat.skimage.skeletonize(image),
             lambda: morphology.skeletonize(image)),
        Pair("scipy binary_fill_holes", lambda: thinbench.fill_holes(image),
             lambda: ndimage.binary_fill_holes(image)),
        Pair("scipy label + skimage regionprops_table", lambda: thinbench.regions(image),
             lambda: regionprops(image), tables_equal),
        Pair("the same, with our label image", lambda: thinbench.regions(image, True),
             lambda: regionprops(image), lambda ours, theirs: tables_equal(ours[0], theirs)),
        Pair(f"a loop of our thin over {len(stack)} images of 28 x 28",
             lambda: thinbench.thin(stack), lambda: np.array([thinbench.thin(one) for one in stack])),
        Pair("a loop of skimage.morphology.skeletonize over the same",
             lambda: thinbench.thin(stack, "zhang_suen_skimage"),
             lambda: np.array([morphology.skeletonize(one) for one in stack])),
        Pair("a loop of skimage.morphology.thin over the same",
             lambda: thinbench.thin(stack, "guo_hall_skimage"),
             lambda: np.array([morphology.thin(one) for one in stack])),
        Pair("numpy copy of 28 x 28 (the cheapest call)", lambda: thinbench.thin(blank),
             lambda: np.copy(blank)),
    ]


def main() -> None:
    cv2.setNumThreads(1)
    path = sys.argv[1] if len(sys.argv) > 1 else str(SCENE)
    grey = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
    if grey is None:
        sys.exit(f"compare.py: cannot read {path}")
    print(f"{path}, {grey.shape[1]} x {grey.shape[0]}; OpenCV {cv2.__version__}, "
          f"thinbench {thinbench.__version__}")
    for pair in pairs(grey < 128):
        if not pair.equal(pair.ours(), pair.theirs()):
            sys.exit(f"compare.py: outputs differ: {pair.name}")
        ours, theirs = min_times(pair)
        print(f"{pair.name:55} {theirs * 1e6:12.1f} us {ours * 1e6:10.1f} us {theirs / ours:9.1f}x",
              flush=True)


if __name__ == "__main__":
    main()
