"""Comparison of two builds: processes of both alternate, and the clock decides.

A busy neighbour on the same physical core slows calls for seconds at a time. So two processes are
compared that run within half a second: each measures one group, without references, in about
0.1 s, and each row gives ln(its time in one build / its time in the other). A time is the 10 %
quantile of a row's epochs. docs/regression.md has the figures that these choices rest on.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from report.errors import ReportError
from report.measure.estimates import Estimate, Floats, estimate_of_logs
from report.measure.sampler import Json, Sampler, Samples, measure_interleaved, seconds_of
from report.measure.timings import REFERENCE
from report.regress.verdicts import EXIT_STATUS, RowVerdict, Times, Verdict, judge, skipped

PAIRS = 27
VISITS = 8
"""Epochs of a row in each process."""

LIMIT = 0.025
"""Tolerated loss of speed; the A/A control widens it."""

MAX_LIMIT = 0.04
"""As far as that; beyond it nothing can be said."""

QUANTILE = 0.1

PROCESS_SECONDS, VISIT_SECONDS = 0.15, 0.0008


@dataclass
class Pair:
    """A group, measured in both builds. The plans differ in the self-test only."""

    before: Samples
    now: Samples

    @property
    def group(self) -> Json:
        """As planned."""
        group: Json = self.now.plan["groups"][0]
        return group


def common_plan(before: Json, now: Json) -> tuple[Json, list[RowVerdict]]:
    """The rows that both builds know, with equal results, and why others are missing."""
    if any("layouts" not in group for group in before["groups"]):
        raise ReportError("nothing was compared: the other build measures in another way; "
                          "--counts-only compares instructions",
                          EXIT_STATUS[Verdict.SKIPPED])
    results = [_results(plan) for plan in (before, now)]
    common = {name for name, result in results[0].items() if results[1].get(name) == result}
    kept = [lean for group in now["groups"] if (lean := _lean_group(group, common))]
    measured = {entry["name"] for group in kept for entry in group["entries"]}
    left_out = [skipped(name, _why_left_out(name, *results))
                for name in sorted(results[1].keys() - measured)]
    return now | {"groups": kept}, left_out


def measure_pairs(before: Sampler, now: Sampler, pairs: list[Pair], first_seed: int,
                  on_seconds: Callable[[float], None]) -> None:
    """The groups in random order, the processes of a pair one after the other."""
    for seed in range(first_seed, first_seed + PAIRS):
        order = list(pairs)
        random.Random(seed).shuffle(order)
        for pair in order:
            measure_interleaved([(before, pair.before), (now, pair.now)], 1, on_seconds, seed)


def verdicts_of(pair: Pair, judge_threads: bool) -> Iterator[RowVerdict]:
    """On the rows of a group."""
    before, now = _log_times(pair.before), _log_times(pair.now)
    limit, doubt = _limit(pair, np.concatenate([before, now]))
    for index, entry in enumerate(pair.group["entries"]):
        if entry["role"] != "row":
            continue
        if entry["threaded"] and not judge_threads:
            yield skipped(entry["name"], "threads are judged with --judge-threads only")
            continue
        change = estimate_of_logs(before[:, index] - now[:, index])
        # Of the paired ratio, so that times and change agree: the two medians are not paired.
        middle = np.exp(np.median((before + now)[:, index]) / 2)
        times = [Times(float(middle * change.value ** power)) for power in (0.5, -0.5)]
        row = RowVerdict(entry["name"], judge(change, limit), "", change, limit, *times)
        yield row.doubted(doubt) if doubt else row


def planned_seconds(pairs: list[Pair]) -> float:
    """How long `measure_pairs` takes, about."""
    return 2 * PAIRS * sum(PROCESS_SECONDS + seconds_of(pair.now.plan) for pair in pairs)


def _results(plan: Json) -> dict[str, str]:
    """Hashes of results, without references, which are no part of the comparison."""
    return {entry["name"]: entry["hash"] for group in plan["groups"] for entry in group["entries"]
            if entry["name"].split("/")[1] != REFERENCE}


def _lean_group(group: Json, common: set[str]) -> Json | None:
    """With common rows only, and None where the controls are not among them."""
    entries = [entry | {"visits": VISITS, "seconds": VISITS * VISIT_SECONDS}
               for entry in group["entries"] if entry["name"] in common]
    if not any(entry["role"] == "same" for entry in entries):
        return None
    return group | {"entries": entries, "layouts": 1}


def _why_left_out(name: str, before: dict[str, str], now: dict[str, str]) -> str:
    if name not in before:
        return "new: there is nothing to compare with"
    if before[name] != now[name]:
        return "another result than in the other build"
    return "the rows that it is measured beside are not the same in both builds"


def _log_times(samples: Samples) -> Floats:
    """`[process, entry]`"""
    return np.log([[np.quantile(layouts[0], QUANTILE) for layouts in process.groups[0]]
                   for process in samples.processes])


def _limit(pair: Pair, logs: Floats) -> tuple[float, str]:
    """The tolerated loss, and what is wrong with the controls of both builds, if anything."""
    same, slowed = (_control(pair, logs, role) for role in ("same", "slowed"))
    limit = max(LIMIT, 1 - same.low, same.high - 1)
    if limit > MAX_LIMIT:
        return MAX_LIMIT, f"a row differs from itself by {100 * limit:.1f} %"
    if judge(slowed, limit) != Verdict.FAIL:
        return limit, "the injected slowdown of 10 % was not found"
    return limit, ""


def _control(pair: Pair, logs: Floats, role: str) -> Estimate:
    roles = [entry["role"] for entry in pair.group["entries"]]
    control = roles.index(role)
    names = [entry["name"] for entry in pair.group["entries"]]
    return estimate_of_logs(logs[:, names.index(names[control])] - logs[:, control])
