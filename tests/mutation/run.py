"""Mutation testing of the code that decides pixels: small changes to a copy of kernels/, one at a
time, each of which a test should notice."""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

# pylint: disable=wrong-import-position
from choice import (Candidate, Equivalent, Result, append_result, candidates,  # noqa: E402
                    next_of, read_equivalents, read_results, stale)
from families import FAMILIES, programs  # noqa: E402
from report.progress import Progress  # noqa: E402
from trial import ALL_ISAS, QUICK_ISAS, ROOT, Build, Trial, TreeError, copy_sources  # noqa: E402

KERNELS = ROOT / "kernels"
EQUIVALENTS = Path(__file__).with_name("equivalent.json")
REQUIRED = 98  # per cent of the mutants that count
EXAMPLES = """Examples:
  python3 tests/mutation/run.py                      about 330 mutants, or the rest of them
  python3 tests/mutation/run.py --family edges -n 10
  python3 tests/mutation/run.py -n 0                 the summary of what was done

The results are build/mutation/results.jsonl; delete the file to start again. A survivor needs a test, or an entry in
tests/mutation/equivalent.json that says why none can notice it; without one, the next start tries it again.
Exit status 0: enough were killed; 1: too many survived; 2: wrong use, or the copy cannot be built."""

Queues = Sequence[Sequence[Candidate]]


def main(arguments: Sequence[str] | None = None) -> int:
    """The program."""
    options = _options(arguments)
    families = [one for one in FAMILIES if not options.family or one.name in options.family]
    queues = [candidates(family, KERNELS, options.seed) for family in families]
    equivalents = read_equivalents(EQUIVALENTS)
    options.directory.mkdir(parents=True, exist_ok=True)
    file = options.directory / "results.jsonl"
    results = read_results(file)
    try:
        if options.number:
            sources, built = options.directory / "tree", programs(families)
            copy_sources(sources)
            trial = Trial(sources, Build(sources, options.directory / "quick", QUICK_ISAS, built),
                          Build(sources, options.directory / "thorough", ALL_ISAS, built))
            run = Run(trial, file, results, equivalents, time.monotonic() + 60 * options.minutes)
            run.try_all(queues, -(-options.number // len(families)))
    except TreeError as error:
        print(f"run.py: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nstopped; start again to go on", file=sys.stderr)
    tried = [(one, results[one.key]) for queue in queues for one in queue if one.key in results]
    return report(tried, equivalents)


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python3 tests/mutation/run.py", description=__doc__,
                                     epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-n", "--number", type=int, default=330,
                        help="mutants that count, over all families (default: 330)")
    parser.add_argument("--family", action="append", choices=[family.name for family in FAMILIES],
                        help="only this one; may be repeated")
    parser.add_argument("--seed", type=int, default=1, help="of the choice (default: 1)")
    parser.add_argument("--minutes", type=float, default=240,
                        help="stop after this time (default: 240)")
    parser.add_argument("--directory", type=Path, default=ROOT / "build" / "mutation",
                        help="of the copy, its builds and the results (default: build/mutation)")
    options = parser.parse_args(arguments)
    if options.number < 0:
        parser.error(f"--number: expected an integer of at least 0, got '{options.number}'")
    return options


class Run:
    """Tries mutants until enough count or the time is over, and keeps each result at once."""

    def __init__(self, trial: Trial, file: Path, results: dict[str, Result],
                 equivalents: Sequence[Equivalent], end: float) -> None:
        self.trial, self.file, self.results, self.end = trial, file, results, end
        self.equivalents = equivalents

    def try_all(self, queues: Queues, wanted: int) -> None:
        """Survivors of earlier runs first; then a few of each family in rotation, so that an
        interrupted run covers all evenly."""
        self._try([one for queue in queues for one in queue
                   if self._state(one) == "survived" and not self._is_explained(one)])
        progress = Progress("mutants", wanted * len(queues))
        while few := [one for queue in queues for one in next_of(queue, wanted, self.results)]:
            self._try(few)
            if time.monotonic() > self.end:
                return
            progress.set(sum(one.key in self.results and self.results[one.key].counts()
                             for queue in queues for one in queue))

    def _try(self, chosen: Sequence[Candidate]) -> None:
        """One file after another: that of the mutant before is built again."""
        for one in sorted(chosen, key=lambda candidate: candidate.file):
            if time.monotonic() > self.end:
                return
            result = self.trial.result(one, self._is_explained(one))
            self.results[one.key] = result
            append_result(self.file, one.key, result)
            if result.state == "survived" and not self._is_explained(one):
                print(f"survived: {one}", flush=True)

    def _state(self, one: Candidate) -> str:
        return self.results[one.key].state if one.key in self.results else "unknown"

    def _is_explained(self, one: Candidate) -> bool:
        return any(entry.describes(one) for entry in self.equivalents)


def report(tried: Sequence[tuple[Candidate, Result]], equivalents: Sequence[Equivalent]) -> int:
    """Prints what became of the mutants; returns the exit status."""
    lines: dict[str, Counter[str]] = {}
    for one, result in tried:
        state, is_listed = result.state, any(entry.describes(one) for entry in equivalents)
        if state == "survived":
            state = "equivalent" if is_listed else state
        elif state == "killed" and is_listed:
            print(f"listed as equivalent, but killed by {result.test}: {one}")
        if state == "survived":
            print(f"survived: {one}")
        for name in (one.family.name, "all"):
            lines.setdefault(name, Counter())[state] += 1
            lines[name]["seconds"] += round(result.seconds)
    for entry in stale(equivalents, KERNELS):
        print(f"stale in {EQUIVALENTS.name}: {entry.file}: {entry.before}")
    heads = ("killed", "survived", "equivalent", "same code", "not compiled", "seconds")
    total = lines.pop("all", Counter())
    print("".join(f"{head:>13}" for head in ("family", *heads)))
    for name, counts in [*lines.items(), ("all", total)]:
        print(f"{name:>13}" + "".join(f"{counts[head]:>13}" for head in heads))
    counted = total["killed"] + total["survived"]
    if counted == 0:
        return 0
    share = 100 * total["killed"] / counted
    print(f"killed: {total['killed']} of {counted}, {share:.1f} %; required: {REQUIRED} %")
    return 0 if share >= REQUIRED else 1


if __name__ == "__main__":
    sys.exit(main())
