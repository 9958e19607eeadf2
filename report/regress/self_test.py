"""`./study regress --self-test`: how often the check is right where the truth is known."""

from __future__ import annotations

import copy
import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from itertools import islice
from pathlib import Path

from report.measure.run import machine_facts
from report.measure.sampler import Json, Process, Sampler, Samples
from report.regress import builds, stored, times
from report.regress.verdicts import MAX_ROUNDS, RowVerdict, Verdict, decide

FILTER = ("^(skeleton_scan/.*bitpacked|edges_sobel/simd_16bit|holes/.*_runs)/[a-z0-9.]+/1/"
          "end_to_end/")
BUSY_LOOP = "while :; do :; done"
COMPILER = "while :; do echo '#include <regex>' | c++ -std=c++20 -O2 -x c++ -c -o /dev/null -; done"
LOADS: dict[str, Sequence[str]] = {"idle": (), "one loop": (BUSY_LOOP,),
                                   "two loops": (BUSY_LOOP, BUSY_LOOP), "compiler": (COMPILER,)}
SLOWER = (0, 3, 5, 10)
"""Percent."""

NEEDED = {5: 0.8, 10: 0.9}
"""Share of trials in which a slowdown of so many percent must be FAIL."""

FALSE_ALARMS = 0.001
"""Share of trials without a slowdown that may be FAIL."""

RECORDED = 2 * builds.PAIRS * MAX_ROUNDS
"""Processes: a trial without a verdict to the end."""

WARM_UP_SECONDS = 0.5


def run(programs: Path, quick: bool) -> tuple[str, int]:
    """The tables and the exit status: 0 where everything holds."""
    sampler = Sampler(programs / "thinbench_sampler")
    machine = machine_facts(programs / "thinbench-study", "self-test")
    plan = sampler.plan(["--no-peers", "--variants", "highest", "--filter", FILTER])
    parts = [_replay(sampler, plan, 100 if quick else 500), _live(sampler, plan),
             _stored(sampler, plan, machine, 4 if quick else 16)]
    good = all(passed for _, passed in parts)
    return ("\n".join([*(text for text, _ in parts), f"self-test {'PASS' if good else 'FAIL'}"]),
            0 if good else 1)


def _replay(sampler: Sampler, plan: Json, trials: int) -> tuple[str, bool]:
    """Trials on recorded processes, one row of one build slowed down afterwards."""
    lines, good, alarms = [f"Two builds, {trials} trials each on recorded processes:",
                           "  load       slower   FAIL  INCONCLUSIVE  PASS   pairs"], True, 0
    for load, scripts in LOADS.items():
        with _load(scripts):
            groups = _record(sampler, plan, f"recording, {load}")
        for percent in SLOWER:
            found, pairs = replay(groups, percent, trials)
            lines.append(f"  {load:9}  {percent:4} %  " + "".join(
                f"{100 * found[verdict] / trials:{width}.1f} %" for verdict, width in
                ((Verdict.FAIL, 6), (Verdict.INCONCLUSIVE, 11), (Verdict.PASS, 6)))
                + f"  {pairs:.0f}")
            alarms += found[Verdict.FAIL] if percent == 0 else 0
            good &= found[Verdict.FAIL] >= NEEDED.get(percent, 0) * trials
    return "\n".join(lines), good and alarms <= FALSE_ALARMS * trials * len(LOADS)


def _record(sampler: Sampler, plan: Json, what: str) -> list[Samples]:
    """Processes of each group as a comparison of builds starts them."""
    common = builds.common_plan(plan, plan)[0]
    groups = [Samples(common | {"groups": [group]}) for group in common["groups"]]
    builds.measure_in_turn(what, [[(sampler, group)] for group in groups], range(RECORDED))
    return groups


def replay(groups: Sequence[Samples], percent: float, trials: int) -> tuple[Counter[Verdict], float]:
    """What becomes of a row that one build computes in so many percent more time, and the mean
    number of pairs that it takes. Each trial starts at another process."""
    dice = random.Random(percent)
    found: Counter[Verdict] = Counter()
    pairs = 0
    for _ in range(trials):
        group = dice.choice(groups)
        name = dice.choice([entry["name"] for entry in group.plan["groups"][0]["entries"]
                            if entry["role"] == "row"])
        pair = builds.Pair(Samples(group.plan), Samples(group.plan))
        source = _from(group, name, percent, dice)
        row, = decide(partial(_replayed_round, pair, source), {name})
        found[row.verdict] += 1
        pairs += len(pair.now.processes)
    return found, pairs / trials


def _from(group: Samples, name: str, percent: float,
          dice: random.Random) -> Iterator[tuple[Process, Process]]:
    """Pairs of neighbours in random order, the second of which is slower."""
    start, count = dice.randrange(len(group.processes)), len(group.processes)
    for index in range(0, count - 1, 2):
        both = [group.processes[(start + index + i) % count] for i in (0, 1)]
        dice.shuffle(both)
        yield both[0], _slower(both[1], group.plan["groups"][0], name, 1 + percent / 100)


def _slower(process: Process, group: Json, name: str, factor: float) -> Process:
    """The row and the controls that repeat it."""
    entries = [[[time * (factor if entry["name"] == name else 1) for time in layout]
                for layout in layouts]
               for entry, layouts in zip(group["entries"], process.groups[0])]
    return replace(process, groups=[entries])


def _replayed_round(pair: builds.Pair, source: Iterator[tuple[Process, Process]], _: int,
                    __: set[str] | None) -> list[RowVerdict]:
    for before, now in islice(source, builds.PAIRS):
        pair.before.processes.append(before)
        pair.now.processes.append(now)
    return list(builds.verdicts_of(pair, False))


def _live(sampler: Sampler, plan: Json) -> tuple[str, bool]:
    """Each slowdown once, of the row that the controls repeat."""
    common = builds.common_plan(plan, plan)[0]
    lines, good = ["Two builds, measured now (rows):"], True
    for percent, group in zip((5, 10), common["groups"]):
        name = group["entries"][-1]["name"]
        before = common | {"groups": [group]}
        now = _slowed(before, name, percent)
        _say(f"{percent} % slower")
        rows = decide(times.rounds_of((sampler, before), (sampler, now), False))
        found, others = (Counter(row.verdict for row in rows if (row.name == name) == slow)
                         for slow in (True, False))
        good &= found[Verdict.PASS] == 0 and others[Verdict.FAIL] == 0
        lines.append(f"  {percent:2} % slower  {_counted(found)}   other rows: {_counted(others)}")
    return "\n".join(lines), good


def _slowed(plan: Json, name: str, percent: int) -> Json:
    """With a further delay of this row and its controls, the last of which has one of 10 %."""
    changed = copy.deepcopy(plan)
    entries = changed["groups"][0]["entries"]
    delay = entries[-1]["delay_ns"] * percent / 10
    for entry in entries:
        if entry["name"] == name:
            entry["delay_ns"] += delay
    return changed


def _stored(sampler: Sampler, plan: Json, machine: Json, attempts: int) -> tuple[str, bool]:
    """Every load follows every other one, and itself. No row may be FAIL, and some must be PASS,
    as else no FAIL would show nothing."""
    lines = ["The same build and a baseline of it, under other loads (rows):"]
    total: Counter[Verdict] = Counter()
    loads = list(LOADS)
    for attempt in range(attempts):
        before, now = loads[attempt % 4], loads[(attempt + attempt // 4) % 4]
        _say(f"baseline {attempt + 1} of {attempts}")
        with _load(LOADS[before]):
            first = stored.measured_from(times.measure(sampler, plan))
        baseline = stored.baseline_from(first, machine, FILTER, "self-test", None)
        with _load(LOADS[now]):
            rows = times.verdicts_against(baseline, (sampler, plan), times.cache_bytes(machine),
                                          False)
        found = Counter(row.verdict for row in rows)
        lines.append(f"  {before:9} -> {now:9}  {_counted(found)}{_why(rows)}")
        total += found
    return "\n".join(lines), total[Verdict.FAIL] == 0 and total[Verdict.PASS] > 0


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
