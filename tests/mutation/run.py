"""Mutation testing of the code that decides pixels: small changes to a copy of kernels/, one at a
time, each of which a test should notice."""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

# pylint: disable=wrong-import-position
from choice import (Candidate, Equivalents, Result, candidates,  # noqa: E402
                    read_equivalents, stale, to_try)
from families import FAMILIES  # noqa: E402
from report.errors import ReportError  # noqa: E402
from report.files import read_json, to_json, write_file  # noqa: E402
from report.progress import Progress  # noqa: E402
from trial import ROOT, prepare  # noqa: E402

KERNELS = ROOT / "kernels"
EQUIVALENTS = Path(__file__).with_name("equivalent.json")
REQUIRED = 98  # per cent of the mutants that count
EXAMPLES = """Examples:
  python3 tests/mutation/run.py                      about 330 mutants, or the rest of them
  python3 tests/mutation/run.py --family edges -n 10
  python3 tests/mutation/run.py -n 0                 the summary of what was done

The results are build/mutation/results.json; delete the file to start again. A survivor needs a test, or an entry in
tests/mutation/equivalent.json that says why none can notice it; without one, the next start tries it again.
Exit status 0: enough were killed; 1: too many survived; 2: wrong use, or the copy cannot be built."""


def main(arguments: Sequence[str] | None = None) -> int:
    """The program."""
    options = _options(arguments)
    families = [one for one in FAMILIES if not options.family or one.name in options.family]
    queues = [candidates(family, KERNELS, options.seed) for family in families]
    equivalents = read_equivalents(EQUIVALENTS)
    file = options.directory / "results.json"
    try:
        known = read_json(file) if file.exists() else {}
        results = {key: Result(**result) for key, result in known.items()}
        if options.number:
            checks = (check for family in families for check in family.checks + family.thorough)
            trial = prepare(options.directory.resolve(), sorted({check.split()[0] for check in checks}))
            wanted, end = -(-options.number // len(families)), time.monotonic() + 60 * options.minutes
            progress = Progress("mutants", wanted * len(families))
            for one in to_try(queues, wanted, results, equivalents):
                if time.monotonic() > end:
                    break
                result = results[one.key] = trial.result(one, one.is_in(equivalents))
                write_file(file, to_json({key: asdict(result) for key, result in results.items()}))
                if result.state == "survived" and not one.is_in(equivalents):
                    print(f"survived: {one}", flush=True)
                progress.set(sum(result.counts() for _, result in tried(queues, results)))
    except ReportError as error:
        print(f"run.py: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nstopped; start again to go on", file=sys.stderr)
    return report(tried(queues, results), equivalents)


def tried(queues: Sequence[Sequence[Candidate]], results: Mapping[str, Result]) -> list[tuple[Candidate, Result]]:
    """Mutants with their results."""
    return [(one, results[one.key]) for queue in queues for one in queue if one.key in results]


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python3 tests/mutation/run.py", description=__doc__, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-n", "--number", type=int, default=330,
                        help="mutants that count, over all families (default: 330)")
    parser.add_argument("--family", action="append", choices=[family.name for family in FAMILIES],
                        help="only this one; may be repeated")
    parser.add_argument("--seed", type=int, default=1, help="of the choice (default: 1)")
    parser.add_argument("--minutes", type=float, default=240, help="stop after this time (default: 240)")
    parser.add_argument("--directory", type=Path, default=ROOT / "build" / "mutation",
                        help="of the copy, its builds and the results (default: build/mutation)")
    options = parser.parse_args(arguments)
    if options.number < 0:
        parser.error(f"--number: expected an integer of at least 0, got '{options.number}'")
    return options


def report(mutants: Sequence[tuple[Candidate, Result]], equivalents: Equivalents) -> int:
    """Prints what became of them; returns the exit status."""
    lines: dict[str, Counter[str]] = defaultdict(Counter)
    for one, result in mutants:
        state, is_listed = result.state, one.is_in(equivalents)
        if state == "killed" and is_listed:
            print(f"listed as equivalent, but killed by {result.test}: {one}")
        elif state == "survived" and is_listed:
            state = "equivalent"
        elif state == "survived":
            print(f"survived: {one}")
        lines[one.family.name] += Counter({state: 1, "seconds": round(result.seconds)})
    for file, before, _ in stale(equivalents, KERNELS):
        print(f"stale in {EQUIVALENTS.name}: {file}: {before}")
    heads = ("killed", "survived", "equivalent", "same code", "not compiled", "seconds")
    total: Counter[str] = sum(lines.values(), Counter())
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
