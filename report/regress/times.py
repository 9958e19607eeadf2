"""The layer of times: measures, judges, and measures again what does not pass."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from report.errors import ReportError
from report.measure.benchmarks import Benchmarks, Json, groups_of, with_rows
from report.measure.measurement import measured
from report.measure.timings import REFERENCE
from report.regress import builds, stored
from report.regress.builds import Pair
from report.regress.verdicts import (EXIT_STATUS, WRONG_USAGE, Layer, Measure, RowVerdict, Verdict,
                                     decide, layer_of)


def against_stored(benchmarks: Benchmarks, words: Sequence[str], machine: Json, file: Path,
                   judge_threads: bool, is_part: bool) -> Layer:
    """This build and the baseline in a file; where `is_part`, only what `words` choose of it."""
    baseline = stored.read_baseline(file)
    if baseline is None:
        return Layer(Verdict.SKIPPED, [], f"there is no baseline for this machine and compiler "
                                          f"('{file}'); ./study regress --update writes it")
    return layer_of(verdicts_against(baseline, benchmarks, benchmarks.verify(words),
                                     cache_bytes(machine), judge_threads, is_part))


def verdicts_against(baseline: Json, benchmarks: Benchmarks, facts: Json, cache: float, judge_threads: bool,
                     is_part: bool = False) -> list[RowVerdict]:
    """All rows, those that do not pass measured again."""

    def measure_again(_: int, rows: set[str] | None, __: set[str]) -> list[RowVerdict]:
        chosen = with_rows(facts, (name for names in groups_of(facts) if rows is None or rows.intersection(names)
                                   for name in names))
        found = stored.measured_from(chosen, measured(benchmarks, chosen, stored.PROCESSES))
        return stored.against_baseline(found, baseline, cache, judge_threads, is_part)

    return decide(measure_again)


def between_builds(both: tuple[Benchmarks, Benchmarks], words: Sequence[str], same: set[str],
                   judge_threads: bool) -> Layer:
    """Two builds, before and now, each of which verifies its rows. Rows of the ISAs in `same` run the same machine
    code and are not measured."""
    ours = both[1].verify(words)
    names = {name for name, row in ours["rows"].items() if row["technique"] != REFERENCE}
    equal = {name for name in names if ours["rows"][name]["isa"] in same}
    rows = [RowVerdict(name, Verdict.PASS, "the same machine code") for name in sorted(equal)]
    if equal != names:
        pairs, left_out = builds.common_pairs(_facts_of_other(both[0], words), ours)
        found = decide(rounds_of(both, pairs, judge_threads), names - equal)
        rows += [row for row in found + left_out if row.name not in equal]
    return layer_of(rows, f"times: {len(equal)} rows not measured, as they run the same machine "
                          "code" if equal else "")


def _facts_of_other(before: Benchmarks, words: Sequence[str]) -> Json:
    try:
        return before.verify(words)
    except ReportError as error:
        if error.status != WRONG_USAGE:
            raise
        raise ReportError("nothing was compared: the other build rejects these options, or has no such row",
                          EXIT_STATUS[Verdict.SKIPPED]) from None


def rounds_of(both: tuple[Benchmarks, Benchmarks], pairs: Sequence[Pair], judge_threads: bool) -> Measure:
    """Each measures more of the groups of its rows, in both builds, and judges what there is."""
    compared = sum(len(pair.rows) for pair in pairs)

    def measure_more(number: int, rows: set[str] | None, alone: set[str]) -> list[RowVerdict]:
        chosen = [pair for pair in pairs if rows is None or rows.intersection(pair.rows)]
        builds.measure_in_turn(both, chosen, range(number * builds.PAIRS, (number + 1) * builds.PAIRS))
        found = {row.name: row for pair in chosen for row in builds.verdicts_of(pair, judge_threads, compared)}
        found |= {row.name: row for pair in chosen if alone.intersection(pair.rows)
                  for row in builds.verdicts_of(pair, judge_threads, compared, -builds.PAIRS) if row.name in alone}
        return list(found.values())

    return measure_more


def cache_bytes(machine: Json) -> float:
    """The second level, which a core has for itself."""
    sizes = [cache["size_kib"] for cache in machine["caches"] if cache["level"] == 2]
    return 1024 * max(sizes, default=float("inf"))
