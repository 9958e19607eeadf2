"""Threads of Python: what they do at once, and how long a call keeps them waiting."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor


def longest_wait_during(call: Callable[[], object]) -> float:
    """The longest wait of this thread while another makes the call, as a share of its duration."""
    def duration() -> float:
        start = time.perf_counter()
        call()
        return time.perf_counter() - start

    with ThreadPoolExecutor(1) as pool:
        longest, before = 0.0, time.perf_counter()
        timed = pool.submit(duration)
        while not timed.done():
            now = time.perf_counter()
            longest, before = max(longest, now - before), now
        return longest / timed.result()


def in_eight_threads(work: Callable[[], object]) -> None:
    """Raises what one of them raises."""
    with ThreadPoolExecutor(8) as pool:
        for one in [pool.submit(work) for _ in range(8)]:
            one.result()
