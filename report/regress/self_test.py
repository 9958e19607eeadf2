"""`./study regress --self-test`: how often the check is right where the truth is known."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import islice
from pathlib import Path

import pandas as pd

from report.measure.benchmarks import AGAIN, SLOWED, Benchmarks, Json
from report.measure.measurement import measured
from report.measure.machine import machine_facts
from report.regress import builds, stored, times
from report.regress.builds import Pair
from report.regress.verdicts import EXIT_STATUS, MAX_ROUNDS, RowVerdict, Verdict, decide, overall

FILTER = ("^(midpoint_scan/.*bitpacked|edges_sobel/simd_16bit|holes/.*_runs)/[a-z0-9.]+/1/"
          "end_to_end/")
BUSY_LOOP = "while :; do :; done"
COMPILER = "while :; do echo '#include <regex>' | c++ -std=c++20 -O2 -x c++ -c -o /dev/null -; done"
LOADS: dict[str, Sequence[str]] = {"idle": (), "one loop": (BUSY_LOOP,),
                                   "two loops": (BUSY_LOOP, BUSY_LOOP), "compiler": (COMPILER,)}
SLOWER = (0, 3, 5, 10)
"""Percent."""

NEEDED = {5: 0.8, 10: 0.9}
"""Share of trials with a verdict in which a slowdown of so many percent must be FAIL."""

UNDECIDED = 0.5
"""Share of trials that may be INCONCLUSIVE where rows are equal or differ by so many percent."""

FALSE_ALARMS = 0.001
"""Share of trials without a slowdown that may be FAIL."""

RECORDED = builds.PAIRS * MAX_ROUNDS
"""Pairs of processes: a trial without a verdict to the end."""

WARM_UP_SECONDS = 0.5


def run(programs: Path, quick: bool) -> tuple[str, int]:
    """The tables and the exit status."""
    benchmarks = Benchmarks(programs / "thinbench_benchmarks")
    machine = machine_facts(programs / "thinbench_benchmarks", "self-test")
    facts = benchmarks.verify(["--no-peers", "--variants", "highest", "--filter", FILTER])
    parts = [_replay(benchmarks, facts, 100 if quick else 500), _stored(benchmarks, facts, machine, 4 if quick else 16)]
    verdict = overall(found for _, found in parts)
    return "\n".join([*(text for text, _ in parts), f"self-test {verdict}"]), EXIT_STATUS[verdict]


def _replay(benchmarks: Benchmarks, facts: Json, trials: int) -> tuple[str, Verdict]:
    """Trials on recorded processes, one row of one build slowed down afterwards."""
    lines = [f"Two builds, {trials} trials each on recorded processes:",
             "  load       slower   FAIL  INCONCLUSIVE  PASS   pairs"]
    found_of: dict[tuple[str, int], Counter[Verdict]] = {}
    for load, scripts in LOADS.items():
        _say(f"recording, {load}")
        pairs = builds.common_pairs(facts, facts)[0]
        with _load(scripts):
            builds.measure_in_turn((benchmarks, benchmarks), pairs, range(RECORDED))
        for percent in SLOWER:
            found, mean = replay(pairs, percent, trials)
            lines.append(f"  {load:9}  {percent:4} %  " + "".join(
                f"{100 * found[verdict] / trials:{width}.1f} %" for verdict, width in
                ((Verdict.FAIL, 6), (Verdict.INCONCLUSIVE, 11), (Verdict.PASS, 6)))
                + f"  {mean:.0f}")
            found_of[load, percent] = found
    return "\n".join(lines), judged(found_of)


def judged(found_of: dict[tuple[str, int], Counter[Verdict]]) -> Verdict:
    """Of the trials of each load and slowdown."""
    alarms = [found[Verdict.FAIL] / found.total() for (_, percent), found in found_of.items() if percent == 0]
    missed = any(found[Verdict.FAIL] < NEEDED.get(percent, 0) * (found[Verdict.FAIL] + found[Verdict.PASS])
                 for (_, percent), found in found_of.items())
    if missed or sum(alarms) > FALSE_ALARMS * len(alarms):
        return Verdict.FAIL
    undecided = any(found[Verdict.INCONCLUSIVE] > UNDECIDED * found.total()
                    for (_, percent), found in found_of.items() if percent == 0 or percent in NEEDED)
    return Verdict.INCONCLUSIVE if undecided else Verdict.PASS


def replay(pairs: Sequence[Pair], percent: float, trials: int) -> tuple[Counter[Verdict], float]:
    """What becomes of a row that one build computes in so many percent more time, and the mean
    number of pairs that it takes. Each trial draws its own order of the recorded pairs, and which build is which."""
    dice = random.Random(percent)
    found: Counter[Verdict] = Counter()
    taken = 0
    compared = sum(len(pair.rows) for pair in pairs)
    for _ in range(trials):
        source = dice.choice(pairs)
        name = dice.choice(source.rows)
        drawn = iter([_slower(_swapped(table, dice.random() < 0.5), name, 1 + percent / 100)
                      for table in dice.sample(source.tables, len(source.tables))])
        trial = Pair(source.facts)

        def replayed(_: int, __: set[str] | None, alone: set[str], trial: Pair = trial,
                     drawn: Iterator[pd.DataFrame] = drawn) -> list[RowVerdict]:
            trial.tables += islice(drawn, builds.PAIRS)
            return list(builds.verdicts_of(trial, False, compared, -builds.PAIRS if alone else 0))

        row, = decide(replayed, {name})
        found[row.verdict] += 1
        taken += len(trial.tables)
    return found, taken / trials


def _swapped(table: pd.DataFrame, swap: bool) -> pd.DataFrame:
    return table.assign(build=1 - table["build"]) if swap else table


def _slower(table: pd.DataFrame, name: str, factor: float) -> pd.DataFrame:
    """The row and the controls that repeat it, now."""
    slow = table["row"].isin((name, name + AGAIN, name + SLOWED)) & (table["build"] == 1)
    return table.assign(ns=table["ns"].where(~slow, table["ns"] * factor))


def _stored(benchmarks: Benchmarks, facts: Json, machine: Json, attempts: int) -> tuple[str, Verdict]:
    """Every load follows every other one, and itself. No row may be FAIL, and some must be PASS,
    as else no FAIL would show nothing."""
    lines = ["The same build and a baseline of it, under other loads (rows):"]
    total: Counter[Verdict] = Counter()
    loads = list(LOADS)
    for attempt in range(attempts):
        before, now = loads[attempt % 4], loads[(attempt + attempt // 4) % 4]
        _say(f"baseline {attempt + 1} of {attempts}")
        with _load(LOADS[before]):
            first = stored.measured_from(facts, measured(benchmarks, facts, stored.PROCESSES))
        baseline = stored.baseline_from(first, machine, FILTER, "self-test", None)
        with _load(LOADS[now]):
            rows = times.verdicts_against(baseline, benchmarks, facts, times.cache_bytes(machine), False)
        found = Counter(row.verdict for row in rows)
        lines.append(f"  {before:9} -> {now:9}  {_counted(found)}{_why(rows)}")
        total += found
    return "\n".join(lines), (Verdict.FAIL if total[Verdict.FAIL] else
                              Verdict.PASS if total[Verdict.PASS] else Verdict.INCONCLUSIVE)


@contextmanager
def _load(scripts: Sequence[str]) -> Iterator[None]:
    """Other processes keep the machine busy meanwhile."""
    started = [subprocess.Popen(["sh", "-c", script], start_new_session=True,
                                stderr=subprocess.DEVNULL) for script in scripts]
    try:
        time.sleep(WARM_UP_SECONDS)
        yield
    finally:
        for process in started:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def _counted(found: Counter[Verdict]) -> str:
    return ", ".join(f"{found[verdict]} {verdict}" for verdict in
                     (Verdict.FAIL, Verdict.INCONCLUSIVE, Verdict.PASS))


def _why(rows: list[RowVerdict]) -> str:
    reasons = Counter(row.reason.split(":")[0] for row in rows
                      if row.verdict == Verdict.INCONCLUSIVE)
    return f"   ({reasons.most_common(1)[0][0] or 'the interval is too wide'})" if reasons else ""


def _say(text: str) -> None:
    print(f"self-test: {text}", file=sys.stderr)
