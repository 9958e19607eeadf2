"""Builds and runs the fuzz targets, as ./check fuzz does:
`python3 -m tests.fuzz.run [--seconds N | --hours N] [--jobs N] [TARGET...]`."""

from __future__ import annotations

import argparse
import math
import os
import re
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path

from report.building import build
from report.errors import ReportError
from report.formatting import counted
from report.progress import Progress

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "asan"
WORK = BUILD / "fuzz"
SOURCES = ROOT / "tests" / "fuzz"
LONGEST_INPUT = 4096  # bytes
SLOWEST_INPUT = 60  # seconds
# A decoder may ask for memory in vain; images are small.
ENVIRONMENT = {"THINBENCH_MAX_PIXELS": "1048576",
               "ASAN_OPTIONS": "allocator_may_return_null=1:detect_leaks=1",
               "UBSAN_OPTIONS": "print_stacktrace=1"}


@dataclass(frozen=True)
class Outcome:
    """What became of one target."""

    target: str
    status: int
    seconds: float
    executions: int
    coverage: int  # edges
    found: tuple[Path, ...]
    log: Path

    @property
    def failed(self) -> bool:
        return self.status != 0 or bool(self.found)


def targets() -> list[str]:
    """Every target has seeds."""
    return sorted(path.stem for path in SOURCES.glob("*.seeds"))


def command_of(target: str, seconds: int, corpus: Path, found: Path) -> list[str]:
    """New inputs stay in the corpus, so that the next run goes on from there."""
    words = SOURCES / f"{target}.dict"
    return [str(BUILD / "bin" / f"fuzz_{target}"), f"-max_total_time={seconds}",
            f"-max_len={LONGEST_INPUT}", f"-timeout={SLOWEST_INPUT}", "-rss_limit_mb=4096",
            f"-artifact_prefix={found}/", "-print_final_stats=1",
            *([f"-dict={words}"] if words.exists() else []), str(corpus),
            str(WORK / "seeds" / target)]


def run(target: str, seconds: int) -> Outcome:
    """Runs one target until it finds something. What an earlier run found comes first."""
    corpus, found = WORK / "corpus" / target, WORK / "found" / target
    log = WORK / "log" / f"{target}.log"
    for directory in (corpus, found, log.parent):
        directory.mkdir(parents=True, exist_ok=True)
    for path in found.iterdir():
        path.rename(corpus / path.name)
    start = time.monotonic()
    with log.open("w", encoding="utf-8") as out:
        status = subprocess.run(command_of(target, seconds, corpus, found), stdout=out,
                                stderr=subprocess.STDOUT, cwd=BUILD, check=False,
                                env=os.environ | ENVIRONMENT).returncode
    text = log.read_text(encoding="utf-8", errors="replace")
    return Outcome(target, status, time.monotonic() - start, last_number(r"^#(\d+)", text),
                   last_number(r" cov: (\d+) ", text), tuple(sorted(found.iterdir())), log)


def last_number(pattern: str, text: str) -> int:
    """The number in the last match."""
    numbers: list[str] = re.findall(pattern, text, re.MULTILINE)
    return int(numbers[-1]) if numbers else 0


def run_all(names: Sequence[str], total: float, jobs: int) -> list[Outcome]:
    """Splits the time among the targets, `jobs` of which run at a time."""
    each = max(1, round(total * jobs / len(names)))
    expected = each * math.ceil(len(names) / jobs)
    progress = Progress("fuzzing", expected)
    start = time.monotonic()
    with ThreadPoolExecutor(jobs) as pool:
        pending = [pool.submit(run, name, each) for name in names]
        while wait(pending, timeout=1).not_done:
            progress.set(min(time.monotonic() - start, expected))
    progress.close()
    return [result.result() for result in pending]


def table(outcomes: Sequence[Outcome]) -> str:
    """A line per target."""
    lines = [f"{'target':16} {'executions':>12} {'per second':>11} {'edges':>7}  found"]
    for outcome in outcomes:
        speed = outcome.executions / max(outcome.seconds, 1)
        found = ", ".join(str(path) for path in outcome.found) or "nothing"
        if outcome.failed and not outcome.found:
            found = f"ended with status {outcome.status}; see {outcome.log}"
        lines.append(f"{outcome.target:16} {outcome.executions:12,} {speed:11,.0f} "
                     f"{outcome.coverage:7,}  {found}")
    executions = sum(outcome.executions for outcome in outcomes)
    failures = sum(outcome.failed for outcome in outcomes)
    return "\n".join([*lines, f"{counted(len(outcomes), 'target')}, {executions:,} executions, {failures} failed"])


def positive(text: str) -> float:
    """An argument that must be a number above 0."""
    try:
        value = float(text)
    except ValueError:
        value = 0
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"expected a number above 0, got '{text}'")
    return value


def parse(arguments: Sequence[str]) -> argparse.Namespace:
    """Exits with status 2 and one line if they are wrong."""
    parser = argparse.ArgumentParser(prog="./check fuzz", description="Runs the fuzz targets.")
    length = parser.add_mutually_exclusive_group()
    length.add_argument("--seconds", type=positive, default=60.0, metavar="N",
                        help="time for all targets together; default: 60")
    length.add_argument("--hours", type=positive, metavar="N", help="the same in hours")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N",
                        help="targets at a time; default: one per processor")
    parser.add_argument("targets", nargs="*", metavar="TARGET", help="default: all")
    chosen = parser.parse_args(arguments)
    known = targets()
    for name in chosen.targets:
        if name not in known:
            parser.error(f"no target is named '{name}'; known: {', '.join(known)}")
    if chosen.jobs < 1:
        parser.error(f"--jobs: expected 1 or more, got {chosen.jobs}")
    chosen.targets = chosen.targets or known
    return chosen


def main(arguments: Sequence[str]) -> int:
    """The exit status: 1 if something was found."""
    chosen = parse(arguments)
    try:
        build("asan", [f"fuzz_{name}" for name in chosen.targets])
    except ReportError as error:
        print(f"check: {error}", file=sys.stderr)
        return error.status
    total = chosen.hours * 3600 if chosen.hours else chosen.seconds
    outcomes = run_all(chosen.targets, total, min(chosen.jobs, len(chosen.targets)))
    print(table(outcomes))
    return int(any(outcome.failed for outcome in outcomes))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
