"""Steps on image files: a batch beside loops over other libraries, and workers."""

from __future__ import annotations

import csv
import hashlib
import shutil
import subprocess
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from statistics import fmean
from typing import Any

import cv2
import numpy as np
from skimage import morphology

import thinbench
from report.errors import ReportError
from report.many_images.inputs import Image
from report.many_images.steps import IMAGES, STAGES, WORKERS, Figures, Key, Step
from thinbench import compat

THREADS = "threads of thinbench batch"
SHARDS = "processes of thinbench batch --shard"
DASK = "dask worker processes"

Thin = Callable[[Image], Any]
"""A skeleton of 0 and anything else; takes 255 on the foreground."""


@dataclass(frozen=True)
class Equals:
    """Ways to the same pixels: words for `thinbench batch`, and functions for loops in Python."""

    batch: tuple[str, ...]
    loops: dict[str, Thin]


ALL_EQUALS = (
    Equals(("thin_guo_hall", "--border", "keep"),
           {"thinbench.compat.cv2.thinning": partial(compat.cv2.thinning, thinningType=1),
            "cv2.ximgproc.thinning": partial(cv2.ximgproc.thinning, thinningType=1)}),
    Equals(("thin_guo_hall_skimage",),
           {"thinbench.compat.skimage.thin": compat.skimage.thin,
            "skimage.morphology.thin": lambda image: morphology.thin(image != 0)}),
    Equals(("thin_zhang_suen_skimage",),
           {"thinbench.compat.skimage.skeletonize": compat.skimage.skeletonize,
            "skimage.morphology.skeletonize": lambda image: morphology.skeletonize(image != 0)}))


def image_steps(program: Path, files: list[Path], work: Path) -> list[Step]:
    """One thread."""
    steps = []
    for equals in ALL_EQUALS:
        base = Key(IMAGES, f"thinbench batch {' '.join(equals.batch)}")
        steps.append(_step(base, base, _batch_run(program, equals.batch, files), work))
        for name, thin in equals.loops.items():
            key = Key(IMAGES, f"Python loop over {name}")
            steps.append(_step(key, base, _loop_run(thin, files), work))
    return steps


def worker_steps(program: Path, files: list[Path], work: Path, client: Any,
                 cores: int) -> list[Step]:
    """All files, by 1, 2, 4 ... workers."""
    runs: dict[str, Callable[[int, Path], None]] = {
        THREADS: partial(_run_threads, program, files[0].parent),
        SHARDS: partial(_run_shards, program, files[0].parent),
        DASK: partial(_run_dask, client, files)}
    base = Key(WORKERS, THREADS, 1)
    return [_timed_step(Key(WORKERS, method, count), base, run, work, len(files))
            for count in worker_counts(cores) for method, run in runs.items()]


def worker_counts(cores: int) -> list[int]:
    """Powers of two, and all."""
    return sorted({1 << power for power in range(cores.bit_length())} | {cores})


def _step(key: Key, base: Key, run: Callable[[Path], Figures], work: Path) -> Step:
    out = _directory(work, key)
    return Step(key, base, lambda: run(_emptied(out)), lambda: _digest(out))


def _emptied(directory: Path) -> Path:
    """ext4 writes a file that replaces another to the disk at once, which would be timed."""
    shutil.rmtree(directory)
    directory.mkdir()
    return directory


def _digest(directory: Path) -> str:
    """Of the names and pixels of all PNG files."""
    found = hashlib.sha256()
    for path in sorted(directory.glob("*.png")):
        found.update(path.name.encode())
        found.update(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE).tobytes())
    return found.hexdigest()


def _timed_step(key: Key, base: Key, run: Callable[[int, Path], None], work: Path,
                images: int) -> Step:
    """`run` takes the number of workers."""
    def timed(out: Path) -> Figures:
        start = time.perf_counter()
        run(key.x, out)
        return {"ms_per_image": [1e3 * (time.perf_counter() - start) / images]}
    return _step(key, base, timed, work)


def _directory(work: Path, key: Key) -> Path:
    """Of a step's results."""
    out = work / "_".join([*key.method.split(), str(key.x)])
    out.mkdir()
    return out


def _batch_run(program: Path, words: Sequence[str],
               files: list[Path]) -> Callable[[Path], Figures]:
    def run(out: Path) -> Figures:
        subprocess.run(_command(program, words, "-", out), text=True, check=True,
                       input="".join(f"{file}\n" for file in files), capture_output=True)
        with (out / "manifest.csv").open(encoding="utf-8", newline="") as manifest:
            lines = list(csv.DictReader(manifest))
        return _figures([[float(line[f"{stage}_seconds"]) for stage in STAGES] for line in lines])
    return run


def _loop_run(thin: Thin, files: list[Path]) -> Callable[[Path], Figures]:
    return lambda out: _figures([_thin_file(thin, file, out) for file in files])


def _thin_file(thin: Thin, file: Path, out: Path) -> list[float]:
    """Seconds of each stage. What is dark is foreground."""
    times = [time.perf_counter()]
    grey = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
    times.append(time.perf_counter())
    _, binary = cv2.threshold(grey, 0, 255, cv2.THRESH_BINARY_INV | cv2.THRESH_OTSU)
    skeleton = np.where(thin(binary), np.uint8(255), np.uint8(0))
    times.append(time.perf_counter())
    cv2.imwrite(str(out / file.name), skeleton)
    times.append(time.perf_counter())
    return [end - start for start, end in zip(times, times[1:])]


def _figures(seconds: list[list[float]]) -> Figures:
    """Means over the images, which are the same in every round."""
    means = [1e3 * fmean(stage) for stage in zip(*seconds)]
    return {f"{stage}_ms": [mean] for stage, mean in zip(STAGES, means)} | {"total_ms": [sum(means)]}


def _command(program: Path, words: Sequence[str], source: Path | str, out: Path,
             threads: int = 1) -> list[str]:
    return [str(program), "batch", *words, str(source), "--out", str(out), "--foreground", "dark",
            "--threads", str(threads)]


def _run_threads(program: Path, source: Path, count: int, out: Path) -> None:
    subprocess.run(_command(program, ["thin_guo_hall"], source, out, count), check=True,
                   capture_output=True)


def _run_shards(program: Path, source: Path, count: int, out: Path) -> None:
    processes = [subprocess.Popen([*_command(program, ["thin_guo_hall"], source, out),
                                   "--shard", f"{number}/{count}"],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                 for number in range(1, count + 1)]
    if any([process.wait() for process in processes]):
        raise ReportError("thinbench batch --shard failed")


def _run_dask(client: Any, files: list[Path], count: int, out: Path) -> None:
    """A task for each file."""
    workers = list(client.scheduler_info()["workers"])[:count]
    client.gather(client.map(_dask_task, files, out=out, workers=workers, pure=False))


def _dask_task(file: Path, out: Path) -> None:
    _thin_file(thinbench.thin, file, out)
