"""Steps on large binary images: dask beside one call."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import dask
import dask.array as da
import numpy as np
import numpy.typing as npt
from distributed import wait

import thinbench
import thinbench.dask
from report.many_images.steps import CHUNKS, IN_MEMORY, Figures, Key, Step

THREADS, WORKERS = "threads of one process", "worker processes"

EPOCHS = 3
"""Calls in a round."""

Binary = npt.NDArray[np.bool_]


class DaskSteps:
    """Processor time of dask, all processes together, beside that of one call."""

    def __init__(self, image: Binary, client: Any, cores: int) -> None:
        self.image, self.client, self.cores = image, client, cores
        self.latest: Any = None  # what the latest run computed

    def steps(self, sides: list[int]) -> list[Step]:
        """Chunks of these sides."""
        base = Key(CHUNKS, IN_MEMORY, len(self.image))
        steps = [Step(base, base, self._run_in_memory, self._digest)]
        for side in sides:
            for method, run in ((THREADS, self._run_threads), (WORKERS, self._run_workers)):
                steps.append(Step(Key(CHUNKS, method, side), base,
                                  partial(run, da.from_array(self.image, chunks=side)),
                                  self._digest))
        return steps

    def _digest(self) -> str:
        return hashlib.sha256(np.packbits(np.asarray(self.latest)).tobytes()).hexdigest()

    def _run_in_memory(self) -> Figures:
        return self._figures(lambda: thinbench.thin(self.image), time.process_time)

    def _run_threads(self, array: Any) -> Figures:
        with dask.config.set(scheduler="threads", num_workers=self.cores):
            return self._figures(lambda: thinbench.dask.thin(array), time.process_time)

    def _run_workers(self, array: Any) -> Figures:
        """The chunks are with the workers before, and after."""
        array = array.persist()
        wait(array)  # type: ignore[no-untyped-call]
        return self._figures(lambda: thinbench.dask.thin(array), self._all_process_times)

    def _all_process_times(self) -> float:
        return time.process_time() + float(sum(self.client.run(time.process_time).values()))

    def _figures(self, run: Callable[[], Any], clock: Callable[[], float]) -> Figures:
        epochs = []
        for _ in range(EPOCHS):
            start = clock()
            self.latest = run()
            epochs.append(1e9 * (clock() - start) / self.image.size)
        return {"ns_per_pixel": epochs}
