"""Steps on large binary images: dask beside one call, and out of core beside in memory."""

from __future__ import annotations

import hashlib
import subprocess
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from typing import Any

import dask
import dask.array as da
import numpy as np
import numpy.typing as npt
from distributed import wait

import thinbench
import thinbench.dask
from report.many_images.steps import Figures, Key, Step

CHUNKS, LARGE = "dask", "out_of_core"
IN_MEMORY = "in memory"
THREADS, WORKERS = "threads of one process", "worker processes"

Binary = npt.NDArray[np.bool_]


class DaskSteps:
    """Processor time of dask, all processes together, beside that of one call just before."""

    def __init__(self, image: Binary, client: Any, cores: int) -> None:
        self.image, self.client, self.cores = image, client, cores
        self.latest: Any = None  # what the latest run computed

    def steps(self, sides: list[int]) -> list[Step]:
        """Chunks of these sides."""
        base = Key(CHUNKS, IN_MEMORY, len(self.image))
        steps = [Step(base, base, self._run_in_memory, self._digest)]
        for side in sides:
            for method in (THREADS, WORKERS):
                steps.append(Step(Key(CHUNKS, method, side), base,
                                  partial(self._run_dask, method, side), self._digest))
        return steps

    def _digest(self) -> str:
        return hashlib.sha256(np.packbits(np.asarray(self.latest)).tobytes()).hexdigest()

    def _run_in_memory(self, _number: int) -> Figures:
        return {"ns_per_pixel": 1e9 * self._seconds_in_memory() / self.image.size}

    def _run_dask(self, method: str, side: int, _number: int) -> Figures:
        array = da.from_array(self.image, chunks=side)
        if method == WORKERS:
            seconds = self._seconds_of_workers(array)
        else:
            with dask.config.set(scheduler="threads", num_workers=self.cores):
                seconds = self._seconds(lambda: thinbench.dask.thin(array), time.process_time)
        beyond = seconds - self._seconds_in_memory()
        return {"ns_per_pixel": 1e9 * seconds / self.image.size,
                "ms_per_chunk_beyond_memory": 1e3 * beyond / array.npartitions}

    def _seconds_in_memory(self) -> float:
        return self._seconds(lambda: thinbench.thin(self.image), time.process_time)

    def _seconds_of_workers(self, array: Any) -> float:
        """The chunks are with the workers before, and after."""
        array = array.persist()
        wait(array)
        return self._seconds(lambda: thinbench.dask.thin(array), self._all_process_times)

    def _all_process_times(self) -> float:
        return time.process_time() + float(sum(self.client.run(time.process_time).values()))

    def _seconds(self, run: Callable[[], Any], clock: Callable[[], float]) -> float:
        start = clock()
        self.latest = run()
        return clock() - start


def large_steps(program: Path, files: dict[int, Path], limits: list[str]) -> list[Step]:
    """`files` has the side of each image. The program's start is subtracted."""
    steps: list[Step] = []
    for side, file in files.items():
        base = Key(LARGE, IN_MEMORY, side)
        ways: dict[Key, list[str]] = {base: []}
        ways |= {Key(LARGE, f"--memory {limit}", side): ["--out-of-core", "--memory", limit]
                 for limit in limits}
        for key, words in ways.items():
            out = file.with_name(f"{len(steps)}.pbm")
            command = [str(program), "run", "thin_guo_hall", str(file), str(out), "--threads", "1",
                       *words]
            steps.append(Step(key, base, partial(_run_large, program, command, side),
                              partial(_digest_of_file, out)))
    return steps


def _digest_of_file(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _run_large(program: Path, command: list[str], side: int, _number: int) -> Figures:
    start, run = _seconds_of([str(program), "list"]), _seconds_of(command)
    processor, wall = (1e9 * (of_run - of_start) / side**2 for of_run, of_start in zip(run, start))
    return {"ns_per_pixel": processor, "wall_ns_per_pixel": wall}


def _seconds_of(command: list[str]) -> tuple[float, float]:
    """Processor time and wall time."""
    before, start = getrusage(RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, check=True, capture_output=True)
    wall, after = time.perf_counter() - start, getrusage(RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall
