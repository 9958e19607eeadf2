"""`./study sweeps`: builds, verifies and measures parameter sweeps."""

from __future__ import annotations

import argparse
from pathlib import Path

from report.building import BENCHMARKS, build
from report.files import check_directory, write_file
from report.git import commit_name
from report.measure.benchmarks import Benchmarks
from report.measure.command import RESULTS, add_part_options, budget_of, finished, measure_run
from report.measure.machine import machine_facts
from report.measure.measurement import Part
from report.measure.run import RUN, SAMPLES, TIMINGS, Run
from report.measure.timings import read_csv
from report.sweeps.plans import BY_NAME, SWEEPS, plan_words
from report.sweeps.series import DIRECTORY, sweep_series, sweeps_markdown

MARKDOWN = "sweeps.md"

EPILOG = f"""sweeps:
{chr(10).join(f"  {sweep.name:<10} {sweep.what}" for sweep in SWEEPS)}

examples:
  ./study sweeps --quick --out /tmp/run
  ./study sweeps --only density --only size
  ./study sweeps --resume

Ctrl-C leaves what was measured; the same command with --resume continues.
Exit status: 0 done, 1 something is missing or failed, 2 wrong usage or a variant that differs from its
reference, 130 interrupted."""


def add_sweeps_command(parser: argparse.ArgumentParser) -> None:
    """Its options."""
    parser.add_argument("--quick", action="store_true",
                        help="smaller images, coarser steps: half a minute instead of five")
    parser.add_argument("--only", metavar="NAME", choices=list(BY_NAME), action="append",
                        default=[], help=f"this sweep: {', '.join(BY_NAME)}; repeatable")
    add_part_options(parser, 300, 30, DIRECTORY)


def run_sweeps(_parser: argparse.ArgumentParser, options: argparse.Namespace) -> tuple[str, int]:
    """Returns the summary to print and the exit status."""
    check_directory(options.out or RESULTS)
    programs = build("release", BENCHMARKS)
    machine = machine_facts(programs / "thinbench_benchmarks", commit_name())
    chosen = {"quick": options.quick, "sweeps": list(dict.fromkeys(options.only)) or list(BY_NAME),
              "seconds": budget_of(options)}
    benchmarks = Benchmarks(programs / "thinbench_benchmarks")
    run, measurement, complete = measure_run(
        benchmarks, chosen, machine, options,
        lambda: [_part(benchmarks, name, options.quick, machine["cores"]) for name in chosen["sweeps"]], DIRECTORY)
    return finished(measurement, complete, _summary(run))


def _part(benchmarks: Benchmarks, name: str, quick: bool, cores: int) -> Part:
    return Part(benchmarks.verify(plan_words(BY_NAME[name], quick, cores)), name,
                ["--seconds-per-row", "0.002" if quick else "0.005"])


def _summary(run: Run) -> str:
    """Writes the tables."""
    directory = run.directory
    scene = read_csv(directory.parent / TIMINGS) if (directory.parent / TIMINGS).exists() else []
    write_file(directory / MARKDOWN, sweeps_markdown(run, scene).encode())
    text = f"{len(sweep_series(run.rows))} curves; {directory} holds {MARKDOWN}, {TIMINGS}, {RUN} and {SAMPLES}"
    if not (directory.parent / RUN).exists():
        return text
    return f"{text}; ./study build {directory.parent} shows them on the page of the run"
