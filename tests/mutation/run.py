"""Mutation testing of the code that decides pixels: small changes to a copy of kernels/, one at a time, each of
which a test should notice."""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from queue import Queue

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

# pylint: disable=wrong-import-position
from choice import (Candidate, Equivalent, Result, append_result, candidates, read_equivalents,  # noqa: E402
                    read_results, result_of, stale)
from families import FAMILIES, Family, programs  # noqa: E402
from report.progress import Progress  # noqa: E402
from tree import Overlay, Tree, TreeError  # noqa: E402
from trial import Trial, Usual  # noqa: E402

RESULTS = "results.jsonl"
EQUIVALENTS = Path(__file__).with_name("equivalent.json")
BY_TURNS = 4
REQUIRED = 98  # per cent of the mutants that count
EXAMPLES = """Examples:
  python3 tests/mutation/run.py                      about 330 mutants, or the rest of them
  python3 tests/mutation/run.py --family edges -n 10
  python3 tests/mutation/run.py --again              those that survived, after a new test
  python3 tests/mutation/run.py -n 0                 the summary of what was done

The results are build/mutation/results.jsonl; delete the file to start again. A survivor needs a test, or an entry in
tests/mutation/equivalent.json that says why none can notice it.
Exit status 0: enough were killed; 1: too many survived; 2: wrong use, or the copy cannot be built."""


def main(arguments: Sequence[str] | None = None) -> int:
    """The program."""
    options = _options(arguments)
    families = [family for family in FAMILIES if not options.family or family.name in options.family]
    options.directory.mkdir(parents=True, exist_ok=True)
    results = read_results(options.directory / RESULTS)
    equivalents = read_equivalents(EQUIVALENTS)
    try:
        wanted = -(-options.number // len(families))
        if options.number > 0 or options.again:
            end = time.monotonic() + 60 * options.minutes
            trials = Trials(options.directory, options.jobs, programs(families))
            if not options.again:
                _try_all(trials, _queues(families, options.seed), wanted, end, results)
            if not options.quick:
                _try_survivors(trials, _queues(families, options.seed), end, results, equivalents)
    except TreeError as error:
        print(f"run.py: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nstopped; start again to go on", file=sys.stderr)
    chosen = _current(families, options.seed, results)
    return _report(chosen, equivalents)


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python3 tests/mutation/run.py", description=__doc__, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-n", "--number", type=int, default=330,
                        help="mutants that count, over all families (default: 330)")
    parser.add_argument("--family", action="append", choices=[family.name for family in FAMILIES],
                        help="only this one; may be repeated")
    parser.add_argument("--seed", type=int, default=1, help="of the choice (default: 1)")
    parser.add_argument("--again", action="store_true", help="only try those that survived once more")
    parser.add_argument("--quick", action="store_true", help="leave out the thorough tests of those that survive")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at a time (default: 1)")
    parser.add_argument("--minutes", type=float, default=240, help="stop after this time (default: 240)")
    parser.add_argument("--directory", type=Path, default=ROOT / "build" / "mutation",
                        help="of the copy, its build and the results (default: build/mutation)")
    options = parser.parse_args(arguments)
    if options.number < 0 or options.jobs < 1:
        parser.error("--number must be at least 0 and --jobs at least 1")
    return options


class Trials:
    """Several trials at a time, each in a directory of its own, and the file of results."""

    def __init__(self, directory: Path, jobs: int, tested: Sequence[str]) -> None:
        tree = Tree(directory)
        tree.prepare(jobs, tested)
        usual = Usual(tree, directory / "seconds.json")
        self.jobs, self.free = jobs, Queue[Trial]()
        for job in range(jobs):
            self.free.put(Trial(Overlay(tree, directory / f"mutant-{job}"), usual))
        self.pool = ThreadPoolExecutor(jobs)
        self.file = directory / RESULTS

    def results(self, chosen: Sequence[tuple[Family, Candidate]], thorough: bool) -> Iterator[Result]:
        """Each is kept at once."""
        waiting = [self.pool.submit(self._result, family, candidate, thorough) for family, candidate in chosen]
        for future in as_completed(waiting):
            result = future.result()
            append_result(self.file, result)
            if result.state == "survived":
                print(f"survived: {_text(result)}", flush=True)
            yield result

    def _result(self, family: Family, candidate: Candidate, thorough: bool) -> Result:
        trial = self.free.get()
        try:
            start = time.monotonic()
            verdict = trial.judge(family, candidate.file, candidate.mutation, thorough)
            return result_of(candidate, verdict.state, verdict.test, time.monotonic() - start)
        finally:
            self.free.put(trial)


Queues = dict[Family, list[Candidate]]


def _queues(families: Sequence[Family], seed: int) -> Queues:
    return {family: candidates(family, ROOT / "kernels", seed) for family in families}


def _try_all(trials: Trials, queues: Queues, wanted: int, end: float, results: dict[str, Result]) -> None:
    """A few of each family in rotation: an interrupted run covers all evenly; the choice depends on the seed alone."""
    counted = Counter({family: 0 for family in queues})
    tried = Counter({family: 0 for family in queues})
    progress = Progress("mutants", wanted * len(queues))
    while time.monotonic() < end:
        chosen = []
        for family, queue in queues.items():
            few = queue[tried[family]:][:min(BY_TURNS, wanted - counted[family])]
            tried[family] += len(few)
            chosen += [(family, one) for one in few]
        if not chosen:
            return
        for result in trials.results([one for one in chosen if one[1].key not in results], thorough=False):
            results[result.key] = result
            progress.advance(result.counts())
        for family, candidate in chosen:
            counted[family] += results[candidate.key].counts()
        progress.set(sum(counted.values()), wanted * len(queues))


def _try_survivors(trials: Trials, queues: Queues, end: float, results: dict[str, Result],
                   equivalents: Sequence[Equivalent]) -> None:
    """Those that survived the quick checks, by the thorough ones; not those that are explained."""
    listed = {(one.file, one.before, one.after) for one in equivalents}
    chosen = [(family, one) for family, queue in queues.items() for one in queue
              if one.key in results and results[one.key].state == "survived" and
              (one.file, one.before, one.after) not in listed]
    progress = Progress("survivors", len(chosen))
    for start in range(0, len(chosen), trials.jobs):
        if time.monotonic() > end:
            return
        for result in trials.results(chosen[start:start + trials.jobs], thorough=True):
            results[result.key] = result
            progress.advance(1)


def _current(families: Sequence[Family], seed: int, results: dict[str, Result]) -> list[Result]:
    """Results for the sources as they are."""
    keys = [one.key for family in families for one in candidates(family, ROOT / "kernels", seed)]
    return [results[key] for key in keys if key in results]


def _text(result: Result) -> str:
    return f"kernels/{result.file}:{result.line}\n  - {result.before}\n  + {result.after}"


def _report(results: Sequence[Result], equivalents: list[Equivalent]) -> int:
    listed = {(one.file, one.before, one.after) for one in equivalents}
    survivors = [one for one in results if one.state == "survived"]
    excused = [one for one in survivors if (one.file, one.before, one.after) in listed]
    for one in survivors:
        if one not in excused:
            print(f"survived: {_text(one)}")
    for one in results:
        if one.state == "killed" and (one.file, one.before, one.after) in listed:
            print(f"listed as equivalent, but killed by {one.test}: {_text(one)}")
    for entry in stale(equivalents, ROOT / "kernels"):
        print(f"stale in {EQUIVALENTS.name}: {entry.file}: {entry.before}")
    print(_table(results, excused))
    killed = sum(one.state == "killed" for one in results)
    counted = sum(one.counts() for one in results) - len(excused)
    if counted == 0:
        return 0
    print(f"killed: {killed} of {counted}, {100 * killed / counted:.1f} %; required: {REQUIRED} %")
    return 0 if 100 * killed >= REQUIRED * counted else 1


def _table(results: Sequence[Result], excused: Sequence[Result]) -> str:
    heads = ("family", "killed", "survived", "equivalent", "same code", "not compiled", "seconds")
    lines = ["".join(f"{head:>13}" for head in heads)]
    names = list(dict.fromkeys(one.family for one in results))
    for name in [*names, "all"]:
        mine = [one for one in results if name in (one.family, "all")]
        equivalent = sum(one in excused for one in mine)
        states = Counter(one.state for one in mine)
        row = (name, states["killed"], states["survived"] - equivalent, equivalent, states["same code"],
               states["not compiled"], f"{sum(one.seconds for one in mine):.0f}")
        lines.append("".join(f"{cell:>13}" for cell in row))
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
