"""The layer of times: measures, judges, and measures again what does not pass."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from report.errors import ReportError
from report.measure.converge import measure_until_converged
from report.measure.sampler import Json, Sampler, Samples
from report.measure.timings import REFERENCE
from report.regress import builds, stored
from report.regress.verdicts import (EXIT_STATUS, WRONG_USAGE, Layer, Measure, RowVerdict, Verdict,
                                     decide, layer_of)


Build = tuple[Sampler, Json]
"""A sampler and the plan that it carries out."""


def against_stored(sampler: Sampler, words: Sequence[str], machine: Json, file: Path,
                   judge_threads: bool, is_part: bool) -> Layer:
    """This build and the baseline in a file; where `is_part`, only what `words` choose of it."""
    baseline = stored.read_baseline(file)
    if baseline is None:
        return Layer(Verdict.SKIPPED, [], f"there is no baseline for this machine and compiler "
                                          f"('{file}'); ./study regress --update writes it")
    return layer_of(verdicts_against(baseline, (sampler, sampler.plan(words)),
                                     cache_bytes(machine), judge_threads, is_part))


def verdicts_against(baseline: Json, now: Build, cache: float, judge_threads: bool,
                     is_part: bool = False) -> list[RowVerdict]:
    """All rows, those that do not pass measured again."""

    def measure_again(_: int, rows: set[str] | None) -> list[RowVerdict]:
        samples = measure(now[0], _with_rows(now[1], rows))
        return stored.against_baseline(stored.measured_from(samples), baseline, cache, judge_threads, is_part)

    return decide(measure_again)


def measure(sampler: Sampler, plan: Json, seconds: float = stored.SECONDS) -> Samples:
    """Until everything has converged or time is up."""
    samples = Samples(plan)
    measure_until_converged([(sampler, samples)], seconds)
    return samples


def between_builds(before: Sampler, now: Sampler, words: Sequence[str], same: set[str],
                   judge_threads: bool) -> Layer:
    """Two builds, each with a plan of its own that verifies its rows. Rows of the ISAs in `same`
    run the same machine code and are not measured."""
    ours = now.plan(words)
    names = {name for name in ours["rows"] if name.split("/")[1] != REFERENCE}
    equal = {name for name in names if ours["rows"][name]["isa"] in same}
    rows = [RowVerdict(name, Verdict.PASS, "the same machine code") for name in sorted(equal)]
    if equal != names:
        plan, left_out = builds.common_plan(_plan_of_other(before, words), ours)
        measured = decide(rounds_of((before, plan), (now, plan), judge_threads), names - equal)
        rows += [row for row in measured + left_out if row.name not in equal]
    return layer_of(rows, f"times: {len(equal)} rows not measured, as they run the same machine "
                          "code" if equal else "")


def _plan_of_other(before: Sampler, words: Sequence[str]) -> Json:
    try:
        return before.plan(words)
    except ReportError as error:
        if error.status != WRONG_USAGE:
            raise
        raise ReportError("nothing was compared: the other build rejects these options, or has no such row",
                          EXIT_STATUS[Verdict.SKIPPED]) from None


def rounds_of(before: Build, now: Build, judge_threads: bool) -> Measure:
    """Each measures more of the groups of its rows, in both builds, and judges what there is."""
    pairs = [builds.Pair(*(Samples(plan | {"groups": [group]}) for plan, group
                           in zip((before[1], now[1]), groups)))
             for groups in zip(before[1]["groups"], now[1]["groups"])]

    def measure_more(number: int, rows: set[str] | None) -> list[RowVerdict]:
        chosen = [pair for pair in pairs if _holds(pair.group, rows)]
        builds.measure_in_turn("measuring both builds", [
            [(before[0], pair.before), (now[0], pair.now)] for pair in chosen
        ], range(number * builds.PAIRS, (number + 1) * builds.PAIRS))
        return [row for pair in chosen for row in builds.verdicts_of(pair, judge_threads)]

    return measure_more


def cache_bytes(machine: Json) -> float:
    """The second level, which a core has for itself."""
    sizes = [cache["size_kib"] for cache in machine["caches"] if cache["level"] == 2]
    return 1024 * max(sizes, default=float("inf"))


def _with_rows(plan: Json, rows: set[str] | None) -> Json:
    """The plan of the groups that hold these rows, or of all."""
    return plan | {"groups": [group for group in plan["groups"] if _holds(group, rows)]}


def _holds(group: Json, rows: set[str] | None) -> bool:
    return rows is None or any(entry["name"] in rows for entry in group["entries"])
