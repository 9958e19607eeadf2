"""One line on standard error: how much is done and how long the rest will take."""

from __future__ import annotations

import sys
import time


class Progress:
    """Work is counted in any unit, expected seconds for example. On a terminal one line is
    rewritten; elsewhere a line appears every ten seconds."""

    def __init__(self, what: str, total: float) -> None:
        self.what, self.total, self.done = what, max(total, 1e-9), 0.0
        self.start = self.latest = time.monotonic()
        self.terminal = sys.stderr.isatty()

    def advance(self, amount: float) -> None:
        """Some work was done."""
        self.set(self.done + amount)

    def set(self, done: float, total: float | None = None) -> None:
        """So much work is done in all; `total` replaces what was expected."""
        self.done, self.total = done, total or self.total
        now = time.monotonic()
        if now - self.latest < (0.2 if self.terminal else 10):
            return
        self.latest = now
        share = min(max(self.done / self.total, 0.001), 1)
        left = (now - self.start) * (1 - share) / share
        text = f"{self.what}: {100 * share:3.0f} %, about {left:.0f} s left"
        print(f"\r\033[K{text}" if self.terminal else text, end="" if self.terminal else "\n",
              file=sys.stderr, flush=True)

    def close(self) -> None:
        """Removes the line."""
        if self.terminal:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
