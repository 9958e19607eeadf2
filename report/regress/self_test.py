"""`./study regress --self-test`: how often the check is right where the truth is known."""

from __future__ import annotations

import copy
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from report.measure.run import machine_facts
from report.measure.sampler import Json, Sampler
from report.regress import builds, stored, times
from report.regress.verdicts import RowVerdict, Verdict, decide

FILTER = ("^(skeleton_scan/.*bitpacked|edges_sobel/simd_16bit|holes/.*_runs)/[a-z0-9.]+/1/"
          "end_to_end/")
BUSY_LOOP = "while :; do :; done"
COMPILER = "while :; do echo '#include <regex>' | c++ -std=c++20 -O2 -x c++ -c -o /dev/null -; done"
LOADS: dict[str, Sequence[str]] = {"idle": (), "one loop": (BUSY_LOOP,),
                                   "two loops": (BUSY_LOOP, BUSY_LOOP), "compiler": (COMPILER,)}
NEEDED = {10: 0.9, 5: 0.8}
"""Share of attempts in which a slowdown of so many percent must be FAIL."""

WARM_UP_SECONDS = 0.5


def run(programs: Path, quick: bool) -> tuple[str, int]:
    """The table and the exit status: 0 where everything holds."""
    sampler = Sampler(programs / "thinbench_sampler")
    machine = machine_facts(programs / "thinbench", "self-test")
    plan = sampler.plan(["--no-peers", "--variants", "highest", "--filter", FILTER])
    lines, good = ["Same build, other load between baseline and check (rows):"], True
    decided = 0
    for text, found in _stored_lines(sampler, plan, machine, 8 if quick else 20):
        lines.append(text)
        good &= found[Verdict.FAIL] == 0
        decided += found[Verdict.PASS]
    if decided == 0:  # then no FAIL shows nothing
        lines.append("  no row was decided: repeat this on an idle machine")
        good = False
    lines.append("Two builds, one row slowed down (attempts):")
    for percent, share in NEEDED.items():
        text, right = _slowdown_line(sampler, plan, percent, share, 3 if quick else 10)
        lines.append(text)
        good &= right
    lines.append("self-test " + ("PASS" if good else "FAIL"))
    return "\n".join(lines), 0 if good else 1


def _stored_lines(sampler: Sampler, plan: Json, machine: Json,
                  attempts: int) -> Iterator[tuple[str, Counter[Verdict]]]:
    """Every load follows every other one, and itself."""
    loads = list(LOADS)
    for attempt in range(attempts):
        before, now = loads[attempt % 4], loads[(attempt + attempt // 4) % 4]
        with _load(LOADS[before]):
            first = stored.measured_from(times.measure(sampler, plan))
        baseline = stored.baseline_from(first, machine, FILTER, "self-test", None)
        with _load(LOADS[now]):
            rows = times.verdicts_against(baseline, (sampler, plan), times.cache_bytes(machine),
                                          False)
        found = Counter(row.verdict for row in rows)
        _say(f"baseline {attempt + 1} of {attempts}")
        yield f"  {before:9} -> {now:9}  {_counted(found)}{_why(rows)}", found


def _slowdown_line(sampler: Sampler, plan: Json, percent: int, share: float,
                   attempts: int) -> tuple[str, bool]:
    common = builds.common_plan(plan, plan)[0]
    found: Counter[Verdict] = Counter()
    others: Counter[Verdict] = Counter()
    for attempt in range(attempts):
        group = common["groups"][attempt % len(common["groups"])]
        names = [entry["name"] for entry in group["entries"] if entry["role"] == "row"]
        name = names[attempt % len(names)]
        before, now = (_slowed(common | {"groups": [group]}, name, percent, extra)
                       for extra in (False, True))
        rows = decide(partial(times.attempt_between, (sampler, before), (sampler, now), False))
        for row in rows:
            (found if row.name == name else others)[row.verdict] += 1
        _say(f"{percent} % slower, attempt {attempt + 1} of {attempts}")
    good = found[Verdict.FAIL] >= share * attempts and others[Verdict.FAIL] == 0
    return f"  {percent:2} % slower  {_counted(found)}   other rows: {_counted(others)}", good


def _slowed(plan: Json, name: str, percent: int, extra: bool) -> Json:
    """Epochs of the row and of the controls that repeat it have calls that are not counted."""
    changed = copy.deepcopy(plan)
    parts = 100 // percent
    for entry in changed["groups"][0]["entries"]:
        if entry["name"] == name:
            calls = entry["calls"] / entry["counted"] * (1 + percent / 100 * extra)
            entry["counted"] = parts * max(1, round(entry["counted"] / parts))
            entry["calls"] = round(entry["counted"] * calls)
    return changed


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
