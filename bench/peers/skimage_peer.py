"""Times scikit-image's thinning on the pictures of a run and adds the rows to its files.

Usage: skimage_peer.py DIR TIMINGS REPETITIONS FILTER

DIR holds rows.json and pictures/, TIMINGS is Google Benchmark's JSON file. Its functions give other
pixels than any case here, so each is compared with itself on a copy of the input, and must give a
subset. They treat everything outside the image as background, as the cases that they stand beside. Where scikit-image is not installed, its rows are recorded as skipped.
"""

from __future__ import annotations

import json
import os
import re
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

Picture = np.ndarray
REASON = "scikit-image is not installed (python3-skimage)"
ROWS = (("thin_zhang_suen", "skimage_skeletonize", "skeletonize"),
        ("thin_guo_hall", "skimage_thin", "thin"))


def main(directory: Path, timings_path: Path, repetitions: int, pattern: str) -> None:
    """Adds rows, or says why there are none."""
    timings, rows = (json.loads(path.read_text()) for path in (timings_path, directory / "rows.json"))
    timed = {entry["name"].split("/iterations:")[0] for entry in timings["benchmarks"]}
    for operation, technique, function in ROWS:
        for item in rows["inputs"]:
            name = f"{operation}/{technique}/native/1/end_to_end/{item['name']}"
            reference = f"{operation}/reference/baseline/1/end_to_end/{item['name']}"
            picture = directory / "pictures" / f"{item['name']}.png"
            if reference in timed and picture.exists() and re.search(pattern, name):
                add(name, function, picture, timings, rows, repetitions)
    replace(timings_path, timings)
    replace(directory / "rows.json", rows)


def add(name: str, function: str, picture: Path, timings: dict[str, Any], rows: dict[str, Any],
        repetitions: int) -> None:
    """One row, or one skipped row."""
    technique = name.split("/")[1]
    try:
        import skimage
        from skimage import morphology
    except ImportError:
        rows["skipped"].append({"row": name, "reason": REASON})
        return
    about = {"technique": technique,
             "about": f"scikit-image {skimage.__version__}, {function}, 1 thread, from Python; other "
                      "pixels than any operation's, compared with itself only",
             "equal_output": False}
    if about not in rows["peers"]:
        rows["peers"].append(about)
    objects = np.asarray(Image.open(picture).convert("L")) >= 128
    entries = measured(name, getattr(morphology, function), objects, repetitions)
    timings["benchmarks"] += entries
    rows["verified"] += 1


def measured(name: str, function: Callable[[Picture], Picture], objects: Picture,
             repetitions: int) -> list[dict[str, Any]]:
    """The repetitions as Google Benchmark writes them."""
    first, again = function(objects), function(objects.copy())
    if not np.array_equal(first, again) or np.any(first & ~objects):
        sys.exit(f"skimage_peer: {name}: gives no repeatable subset of its input")
    height, width = objects.shape
    common = {"name": name, "run_type": "iteration", "time_unit": "ns", "iterations": 1,
              "label": "background",
              "width": float(width), "height": float(height), "verified": 1.0, "peer": 1.0}
    return [common | {"repetition_index": index} | times(function, objects)
            for index in range(repetitions)]


def times(function: Callable[[Picture], Picture], objects: Picture) -> dict[str, float]:
    """One call, in nanoseconds."""
    cpu, real = time.process_time_ns(), time.perf_counter_ns()
    function(objects)
    return {"cpu_time": float(time.process_time_ns() - cpu),
            "real_time": float(time.perf_counter_ns() - real)}


def replace(path: Path, data: dict[str, Any]) -> None:
    """The file appears as a whole."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    temporary.write_text(json.dumps(data, indent=2))
    temporary.replace(path)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]), sys.argv[4])
