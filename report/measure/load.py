"""What other processes do meanwhile, from /proc/stat."""

from __future__ import annotations

import os
import time
from pathlib import Path

TICKS = os.sysconf("SC_CLK_TCK")
STAT = Path("/proc/stat")


def _busy_seconds() -> float:
    """Of all processors since the start of the machine, stolen time included."""
    user, nice, system, _idle, _iowait, irq, softirq, steal = (
        int(field) for field in STAT.read_text().split("\n", 1)[0].split()[1:9])
    return (user + nice + system + irq + softirq + steal) / TICKS


def _own_seconds() -> float:
    """Of this process and the children that it has waited for."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


class LoadMeter:
    """Starts when it is made."""

    def __init__(self) -> None:
        self.start = time.monotonic()
        self.busy = _busy_seconds()
        self.own = _own_seconds()

    def foreign(self) -> float:
        """Mean number of processors that were busy for others since the start."""
        elapsed = max(time.monotonic() - self.start, 1e-3)
        used = _busy_seconds() - self.busy - (_own_seconds() - self.own)
        return round(max(used, 0.0) / elapsed, 3)
