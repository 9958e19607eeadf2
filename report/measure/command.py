"""What the commands that measure share: where a run goes, how long it takes, how it goes on."""

from __future__ import annotations

import argparse
import datetime
from collections.abc import Callable
from pathlib import Path

from report.building import ROOT
from report.errors import ReportError
from report.measure.benchmarks import Benchmarks, Json
from report.measure.estimates import NEEDED_PROCESSES
from report.measure.measurement import UNFINISHED, Measurement, Part
from report.measure.run import Run, write_run
from report.row_options import positive

RESULTS = ROOT / "results"


def add_time_options(parser: argparse.ArgumentParser, seconds: int, quick: int) -> None:
    """--seconds and --resume; budget_of() knows the defaults."""
    parser.add_argument("--seconds", metavar="N", type=positive,
                        help=f"budget of time for measuring; default {seconds}, with --quick {quick}. Everything is "
                             f"measured by at least {NEEDED_PROCESSES} fresh processes")
    parser.add_argument("--resume", action="store_true",
                        help="continue what Ctrl-C ended; the other options must be the same")
    parser.set_defaults(budget=(seconds, quick))


def budget_of(options: argparse.Namespace) -> int:
    """Seconds."""
    return int(options.seconds or options.budget[options.quick])


def default_directory(machine: Json) -> Path:
    """Below results/, by machine, date and commit."""
    today = datetime.datetime.now(datetime.timezone.utc).date()
    return RESULTS / str(machine["fingerprint"]) / f"{today}-{machine['commit']}"


def run_directory(options: argparse.Namespace, machine: Json, below: str = "") -> Path:
    """--out, or today's run; to resume the newest of this commit, as directories start with the date. `below` is
    where in it the command writes."""
    if options.out or not options.resume:
        return (options.out or default_directory(machine)) / below
    runs = RESULTS / str(machine["fingerprint"])
    found = sorted(runs.glob(f"*-{machine['commit']}/{below + '/' if below else ''}{UNFINISHED}"))
    if not found:
        raise ReportError(f"nothing of commit {machine['commit']} was interrupted on this machine; leave out --resume, "
                          "or name the directory with --out")
    return found[-1].parent


def add_part_options(parser: argparse.ArgumentParser, seconds: int, quick: int, below: str) -> None:
    """The same and --out, of a command that writes into a directory below that of a run."""
    add_time_options(parser, seconds, quick)
    parser.add_argument("--out", metavar="DIR", type=Path,
                        help=f"directory of a run, which gets a directory {below}; default "
                             "results/<machine>/<date>-<commit>")


def measure_run(benchmarks: Benchmarks, chosen: Json, machine: Json, options: argparse.Namespace,
                make: Callable[[], list[Part]], below: str = "") -> tuple[Run, Measurement, bool]:
    """Writes the run of a new measurement, or with --resume of the interrupted one. Returns whether it came to its end,
    too. `chosen` are the options that must be the same then. Raises KeyboardInterrupt where not every part was
    measured."""
    directory = run_directory(options, machine, below)
    key = chosen | {"commit": machine["commit"], "machine": machine["fingerprint"]}
    measurement = Measurement.resume(directory, key) if options.resume else Measurement.begin(directory, key, make)
    complete = measurement.run(benchmarks, budget_of(options))
    if not all(part.tables for part in measurement.parts):
        raise KeyboardInterrupt
    name = f"{directory.resolve().parent.name}/{below}" if below else ""
    return write_run(directory, machine, chosen, measurement.parts, name), measurement, complete


def finished(measurement: Measurement, complete: bool, text: str) -> tuple[str, int]:
    """What to print, and the exit status: 130 where Ctrl-C ended the measurement, which --resume continues."""
    if complete:
        measurement.close()
        return text, 0
    return f"{text}\nInterrupted: this is what was measured until then. The same command with --resume goes on.", 130
