"""Verdicts on rows, and what follows from them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from enum import StrEnum

from report.measure.estimates import Estimate


class Verdict(StrEnum):
    """Of a row, a layer or the whole check."""

    PASS = "PASS"
    FAIL = "FAIL"
    INCONCLUSIVE = "INCONCLUSIVE"
    SKIPPED = "SKIPPED"


EXIT_STATUS = {Verdict.PASS: 0, Verdict.FAIL: 1, Verdict.INCONCLUSIVE: 3, Verdict.SKIPPED: 4}
WRONG_USAGE = 2


@dataclass(frozen=True)
class Times:
    """Nanoseconds of a call."""

    row: float
    reference: float | None = None


@dataclass(frozen=True)
class RowVerdict:
    """A verdict and what it rests on."""

    name: str
    verdict: Verdict
    reason: str = ""
    change: Estimate | None = None  # of the speed: 0.9 is 10 % less
    limit: float = 0  # tolerated loss of speed
    before: Times | None = None
    now: Times | None = None
    speedup: Estimate | None = None  # over the reference

    def doubted(self, reason: str) -> RowVerdict:
        """The same row, of which nothing can be said."""
        return replace(self, verdict=Verdict.INCONCLUSIVE, reason=reason)


def skipped(name: str, reason: str) -> RowVerdict:
    """A row that nothing is compared with."""
    return RowVerdict(name, Verdict.SKIPPED, reason)


def judge(change: Estimate, limit: float) -> Verdict:
    """FAIL only where the whole interval is beyond the limit."""
    if change.high < 1 - limit:
        return Verdict.FAIL
    return Verdict.INCONCLUSIVE if change.low < 1 - limit else Verdict.PASS


Measure = Callable[[int, set[str] | None, set[str]], list[RowVerdict]]
"""Measures more and judges: the number of the round, the rows, or None for all, and those of them that are judged by
this round alone."""


MAX_ROUNDS = 5


def decide(measure: Measure, rows: set[str] | None = None) -> list[RowVerdict]:
    """Measures these rows, or all, and what is not settled again, for up to MAX_ROUNDS rounds. PASS is settled; FAIL
    is once the next round says it as well, judged alone."""
    found: dict[str, RowVerdict] = {}
    unsettled = rows
    for number in range(MAX_ROUNDS):
        failed = {name for name, row in found.items() if row.verdict == Verdict.FAIL and name in (unsettled or ())}
        latest = {row.name: row for row in measure(number, unsettled, failed)
                  if unsettled is None or row.name in unsettled}
        found |= {name: row.doubted("FAIL in one round, not in the next")
                  if name in failed and row.verdict == Verdict.PASS else row for name, row in latest.items()}
        unsettled = {name for name in latest if found[name].verdict == Verdict.INCONCLUSIVE
                     or (found[name].verdict == Verdict.FAIL and name not in failed)}
        if not unsettled:
            break
    return [row.doubted("FAIL in the last round only")
            if row.verdict == Verdict.FAIL and row.name in (unsettled or ()) else row
            for row in found.values()]


def overall(verdicts: Iterable[Verdict]) -> Verdict:
    """The worst one; SKIPPED where nothing was compared."""
    found = set(verdicts)
    worst_first = (Verdict.FAIL, Verdict.INCONCLUSIVE, Verdict.PASS)
    return next((verdict for verdict in worst_first if verdict in found), Verdict.SKIPPED)


@dataclass(frozen=True)
class Layer:
    """Instructions, or times."""

    verdict: Verdict
    rows: list[RowVerdict]
    summary: str = ""


def layer_of(rows: list[RowVerdict], summary: str = "") -> Layer:
    """With the verdict that follows from the rows."""
    return Layer(overall(row.verdict for row in rows), rows, summary)


def exit_status(instructions: Layer, times: Layer, counts_only: bool) -> int:
    """1 where either layer fails, else what times say: counts that pass do not show that nothing
    became slower."""
    if Verdict.FAIL in (instructions.verdict, times.verdict):
        return EXIT_STATUS[Verdict.FAIL]
    return EXIT_STATUS[instructions.verdict if counts_only else times.verdict]
