"""Comparison of two builds: processes of both alternate, and their floors are compared.

Each process measures one group, without references, in about 0.1 s. Processes of both builds follow
each other in pairs, so that both meet the same states of the machine. docs/regression.md has the
figures that these choices rest on.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from report.errors import ReportError
from report.measure.converge import floors
from report.measure.estimates import Floor, floor_of, ratio_of
from report.measure.sampler import Json, Sampler, Samples, seconds_of
from report.measure.timings import REFERENCE
from report.progress import Progress
from report.regress.verdicts import EXIT_STATUS, RowVerdict, Times, Verdict, judge, skipped

PAIRS = 9
"""In a round."""

VISITS = 8
"""Epochs of a row in each process."""

LIMIT = 0.025
"""Tolerated loss of speed; the A/A control widens it."""

MAX_LIMIT = 0.04
"""As far as that; beyond it nothing can be said."""

PROCESS_SECONDS, VISIT_SECONDS = 0.15, 0.0008


Job = tuple[Sampler, Samples]
"""A program and what it found."""


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
    if len({frozenset(entry) for plan in (before, now) for group in plan["groups"] for entry in group["entries"]}) > 1:
        raise ReportError("nothing was compared: the other build measures in another way; "
                          "--counts-only compares instructions",
                          EXIT_STATUS[Verdict.SKIPPED])
    results = [_results(plan) for plan in (before, now)]
    common = {name for name, result in results[0].items() if results[1].get(name) == result}
    kept = [lean for group in now["groups"] if (lean := _lean_group(group, common))]
    measured = {entry["name"] for group in kept for entry in group["entries"]}
    left_out = [skipped(name, _why_left_out(name, *results))
                for name in sorted(results[1].keys() - measured)]
    reasons = {row["row"]: row["reason"] for row in now["skipped"]}
    left_out += [skipped(name, reasons.get(name, "this build has no such row"))
                 for name in sorted(results[0].keys() - results[1].keys())]
    return now | {"groups": kept}, left_out


def measure_in_turn(what: str, sets: Sequence[Sequence[Job]], rounds: range) -> None:
    """A process of each job for each round: the sets in random order, the jobs of a set one after
    the other, every other time from the last to the first."""
    progress = Progress(what, len(rounds) * sum(_seconds(job) for jobs in sets for job in jobs))
    for seed in rounds:
        for jobs in random.Random(seed).sample(sets, len(sets)):
            for job in jobs if seed % 2 else reversed(jobs):
                sampler, samples = job
                samples.processes.append(sampler.measure(samples.plan, seed))
                progress.advance(_seconds(job))
    progress.close()


def verdicts_of(pair: Pair, judge_threads: bool) -> Iterator[RowVerdict]:
    """On the rows of a group."""
    limit, doubt = _limit(pair)
    for entry, before, now in zip(pair.group["entries"], floors(pair.before, 0),
                                  floors(pair.now, 0)):
        if entry["role"] != "row":
            continue
        if entry["threaded"] and not judge_threads:
            yield skipped(entry["name"], "threads are judged with --judge-threads only")
            continue
        change = ratio_of(before, now)
        row = RowVerdict(entry["name"], judge(change, limit), "", change, limit,
                         Times(before.time), Times(now.time))
        yield row.doubted(doubt) if doubt else row


def _seconds(job: Job) -> float:
    return PROCESS_SECONDS + seconds_of(job[1].plan)


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


def _limit(pair: Pair) -> tuple[float, str]:
    """The tolerated loss, and what is wrong with the controls of both builds, if anything."""
    control, same, slowed = _controls(pair)
    apart = abs(ratio_of(control, same).value - 1)
    if apart > MAX_LIMIT:
        return MAX_LIMIT, f"a row differs from itself by {100 * apart:.1f} %"
    limit = max(LIMIT, apart)
    if judge(ratio_of(control, slowed), limit) != Verdict.FAIL:
        return limit, "the injected slowdown of 10 % was not found"
    return limit, ""


def _controls(pair: Pair) -> tuple[Floor, Floor, Floor]:
    """A row, the same row again, and the one that is slowed down; processes of both builds."""
    entries = pair.group["entries"]
    same, slowed = ([entry["role"] for entry in entries].index(role)
                    for role in ("same", "slowed"))
    control = [entry["name"] for entry in entries].index(entries[same]["name"])
    processes = pair.before.processes + pair.now.processes
    found = [floor_of([process.groups[0][entry] for process in processes])
             for entry in (control, same, slowed)]
    return found[0], found[1], found[2]
