"""Comparison of two builds: processes of both alternate, and their times are compared.

Each process measures one group, in about 0.1 s. Processes of both builds follow each other in pairs, so that both meet
the same states of the machine. docs/experiments.md has the figures that these choices rest on.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
import pandas as pd
from scipy import stats

from report.measure.benchmarks import AGAIN, SLOWED, Benchmarks, Json, groups_of, with_rows
from report.measure.estimates import Estimate, Estimates, Time
from report.measure.timings import REFERENCE
from report.progress import Progress
from report.regress.verdicts import RowVerdict, Times, Verdict, judge, skipped

PAIRS = 9
"""In a round."""

OPTIONS = ("--seconds-per-row", "0.006")
"""Of each process."""

LIMIT = 0.025
"""Tolerated loss of speed; the A/A control widens it."""

MAX_LIMIT = 0.04
"""As far as that; beyond it nothing can be said."""

FALSE_ALARMS = 0.05
"""Accepted chance that any row of a comparison fails by luck: intervals are wider where more rows are compared."""


@dataclass
class Pair:
    """A group of rows that both builds know, and what processes of both found."""

    facts: tuple[Json, Json]
    """Of the build before and the one now."""
    tables: list[pd.DataFrame] = field(default_factory=list)
    """One for each pair of processes, with the column build: 0 before, 1 now."""

    @property
    def rows(self) -> list[str]:
        """Of the group."""
        return list(self.facts[0]["rows"])


def common_pairs(before: Json, now: Json) -> tuple[list[Pair], list[RowVerdict]]:
    """Groups of the rows that both builds know, with equal results, and why others are missing."""
    results = [{name: row["hash"] for name, row in facts["rows"].items() if row["technique"] != REFERENCE}
               for facts in (before, now)]
    common = {name for name, result in results[0].items() if results[1].get(name) == result}
    pairs = [Pair((with_rows(before, group), with_rows(now, group))) for names in groups_of(now)
             if (group := [name for name in names if name in common])]
    left_out = [skipped(name, _why_left_out(name, *results)) for name in sorted(results[1].keys() - common)]
    reasons = {row["row"]: row["reason"] for row in now["skipped"]}
    left_out += [skipped(name, reasons.get(name, "this build has no such row"))
                 for name in sorted(results[0].keys() - results[1].keys())]
    return pairs, left_out


def _why_left_out(name: str, before: dict[str, str], now: dict[str, str]) -> str:
    return ("new: there is nothing to compare with" if name not in before
            else "another result than in the other build")


def measure_in_turn(builds: tuple[Benchmarks, Benchmarks], pairs: Sequence[Pair], seeds: Sequence[int]) -> None:
    """A process of each build for each group and seed: the groups in random order, the builds one after the other,
    every other time the other way round."""
    progress = Progress("measuring both builds", len(seeds) * len(pairs))
    for seed in seeds:
        for pair in random.Random(seed).sample(list(pairs), len(pairs)):
            found = {build: builds[build].measure(pair.facts[build], OPTIONS).assign(build=build)
                     for build in ((0, 1) if seed % 2 else (1, 0))}
            pair.tables.append(pd.concat(found.values(), ignore_index=True))
            progress.advance(1)
    progress.close()


def verdicts_of(pair: Pair, judge_threads: bool, compared: int, first: int = 0) -> Iterator[RowVerdict]:
    """On the rows of a group, of `compared` rows in all, by its tables from `first` on."""
    times = times_of(pair.tables[first:])
    limit, doubt = _limit(pair, times, compared)
    for name in pair.rows:
        if pair.facts[1]["rows"][name]["threads"] > 1 and not judge_threads:
            yield skipped(name, "threads are judged with --judge-threads only")
            continue
        if not all(key in times for key in keys_of(name)):
            yield skipped(name, "it failed while it was measured; see above")
            continue
        before, now = (times.time(key) for key in keys_of(name))
        change = change_of(before, now, compared)
        row = RowVerdict(name, judge(change, limit), "", change, limit, Times(before.value), Times(now.value))
        why = doubt or ("" if before.settled and now.settled else "too few moments were quiet")
        yield row.doubted(why) if why else row


def keys_of(name: str) -> tuple[str, str]:
    """How a row is called in the times of both builds."""
    return f"0:{name}", f"1:{name}"


def times_of(tables: Sequence[pd.DataFrame]) -> Estimates:
    """Of both builds, a pair of processes being one process: so they are drawn together."""
    samples = pd.concat([table.assign(process=number) for number, table in enumerate(tables)], ignore_index=True)
    return Estimates(samples.assign(row=samples["build"].astype(str) + ":" + samples["row"]))


def change_of(before: Time, now: Time, compared: int) -> Estimate:
    """Of the speed. The interval holds with a chance of error that all rows share."""
    logs = np.log(before.draws / now.draws)
    value = before.value / now.value
    spread = float(stats.norm.isf(FALSE_ALARMS / 2 / max(compared, 1)) * logs.std())
    return Estimate(value, value * float(np.exp(-spread)), value * float(np.exp(spread)))


def _limit(pair: Pair, times: Estimates, compared: int) -> tuple[float, str]:
    """The tolerated loss, and what is wrong with the controls of both builds, if anything."""
    base = next((name for name in pair.rows if all(key + AGAIN in times and key + SLOWED in times and key in times
                                                   for key in keys_of(name))), None)
    if base is None:
        return LIMIT, "the controls were not measured"
    found = [[times.time(key + what) for what in ("", AGAIN, SLOWED)] for key in keys_of(base)]
    apart = max(abs(own.value / same.value - 1) for own, same, _ in found)
    if apart > MAX_LIMIT:
        return MAX_LIMIT, f"a row differs from itself by {100 * apart:.1f} %"
    limit = max(LIMIT, apart)
    if all(judge(change_of(own, slowed, compared), limit) == Verdict.PASS for own, _, slowed in found):
        return limit, "the injected slowdown of 10 % was not found"
    return limit, ""
