"""Threads of Python: what they do at once, and how long a call keeps them waiting."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable


def longest_wait_during(call: Callable[[], object]) -> float:
    """The longest wait of this thread while another makes the call, as a share of its duration."""
    duration: list[float] = []

    def work() -> None:
        start = time.perf_counter()
        call()
        duration.append(time.perf_counter() - start)

    thread = threading.Thread(target=work)
    longest, before = 0.0, time.perf_counter()
    thread.start()
    while not duration:
        now = time.perf_counter()
        longest, before = max(longest, now - before), now
    thread.join()
    return longest / duration[0]


def in_eight_threads(work: Callable[[], object]) -> None:
    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
