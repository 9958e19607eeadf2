"""`./study sweeps`: builds, verifies and measures parameter sweeps."""

from __future__ import annotations

import argparse
from pathlib import Path

from report.building import ROOT, build
from report.errors import ReportError
from report.files import check_directory, write_file
from report.git import commit_name
from report.measure.converge import measure_until_converged
from report.measure.run import RUN, SAMPLES, TIMINGS, load_run, machine_facts, write_run
from report.measure.sampler import Json, Sampler, Samples
from report.measure.timings import read_csv
from report.row_options import positive
from report.study import RESULTS, default_directory
from report.sweeps.journal import NAME, Journal, Part
from report.sweeps.plans import BY_NAME, SWEEPS, plan_words
from report.sweeps.series import DIRECTORY, sweep_series, sweeps_markdown

MARKDOWN = "sweeps.md"
COMPILERS = "compilers"
"""Where the runs of two compilers go instead."""

GCC = "release"
"""The preset of what is measured."""

EPILOG = f"""sweeps:
{chr(10).join(f"  {sweep.name:<10} {sweep.what}" for sweep in SWEEPS)}

examples:
  ./study sweeps --quick --out /tmp/run
  ./study sweeps --only density --only size
  ./study sweeps --resume
  ./study sweeps --compiler clang

Ctrl-C leaves what was measured; the same command with --resume continues.
Exit status: 0 done, 1 something is missing or failed, 2 wrong usage or a variant that differs from its
reference, 130 interrupted."""


def add_sweeps_command(parser: argparse.ArgumentParser) -> None:
    """Its options."""
    parser.add_argument("--quick", action="store_true",
                        help="smaller images, coarser steps: half a minute instead of five")
    parser.add_argument("--only", metavar="NAME", choices=list(BY_NAME), action="append",
                        default=[], help=f"this sweep: {', '.join(BY_NAME)}; repeatable")
    parser.add_argument("--seconds", metavar="N", type=positive,
                        help="budget of time for measuring; default 300, with --quick 30. Each "
                             "result is measured at least three times, in fresh processes")
    parser.add_argument("--resume", action="store_true",
                        help="continue what was interrupted; other options must be the same")
    parser.add_argument("--compiler", choices=("clang",),
                        help="build with Clang, too, and measure the sweep isa with both builds, "
                             "interleaved")
    parser.add_argument("--out", metavar="DIR", type=Path,
                        help=f"directory of a run, which gets a directory {DIRECTORY}, or "
                             f"{COMPILERS}; default results/<machine>/<date>-<commit>")


def run_sweeps(parser: argparse.ArgumentParser, options: argparse.Namespace) -> str:
    """Returns the summary to print."""
    if options.compiler and options.only not in ([], ["isa"]):
        parser.error("--compiler measures the sweep isa; leave out --only")
    check_directory(options.out or RESULTS)
    presets = [GCC] + ([options.compiler] if options.compiler else [])
    builds = {preset: Build(preset, build(preset, ("thinbench_study", "thinbench_sampler")))
              for preset in presets}
    below = COMPILERS if options.compiler else DIRECTORY
    directory = (options.out or _default(options, builds[GCC].machine, below)) / below
    key = _key(options, builds)
    journal = _resumed(directory, key) if options.resume else _begun(directory, key, builds)
    complete = _measure(journal, builds, key["seconds"])
    runs = _write(directory, journal, builds, key)
    if not complete:
        raise ReportError(f"interrupted; {directory} holds what was measured, and the same command "
                          "with --resume continues", 130)
    journal.close()
    return _summary(directory, runs)


class Build:
    """Programs of one compiler."""

    def __init__(self, preset: str, programs: Path) -> None:
        self.preset = preset
        self.machine = machine_facts(programs / "thinbench-study", commit_name())
        self.sampler = Sampler(programs / "thinbench_sampler")


def _default(options: argparse.Namespace, machine: Json, below: str) -> Path:
    """Today's run; to resume the newest of this commit, as directories start with the date."""
    if not options.resume:
        return default_directory(machine)
    runs = ROOT / "results" / str(machine["fingerprint"])
    found = sorted(runs.glob(f"*-{machine['commit']}/{below}/{NAME}"))
    if not found:
        raise ReportError(f"no unfinished sweeps of commit {machine['commit']} on this machine; "
                          "leave out --resume, or name the directory with --out")
    return found[-1].parent.parent


def _key(options: argparse.Namespace, builds: dict[str, Build]) -> Json:
    """What must not change when a measurement is continued."""
    sweeps = options.only or (["isa"] if options.compiler else list(BY_NAME))
    return {"quick": options.quick, "sweeps": list(dict.fromkeys(sweeps)),
            "seconds": options.seconds or (30 if options.quick else 300),
            "commit": builds[GCC].machine["commit"],
            "machines": [one.machine["fingerprint"] for one in builds.values()]}


def _resumed(directory: Path, key: Json) -> Journal:
    if not (directory / NAME).exists():
        raise ReportError(f"there is no '{directory / NAME}' to continue; leave out --resume")
    return Journal.load(directory / NAME, key)


def _begun(directory: Path, key: Json, builds: dict[str, Build]) -> Journal:
    """Plans all sweeps, which verifies their rows."""
    if (directory / NAME).exists():
        raise ReportError(f"'{directory}' holds an unfinished measurement: continue it with "
                          "--resume, delete it, or choose another --out")
    cores = builds[GCC].machine["cores"]
    parts = [Part(one.preset, name,
                  Samples(one.sampler.plan(plan_words(BY_NAME[name], key["quick"], cores))))
             for one in builds.values() for name in key["sweeps"]]
    return Journal.begin(directory / NAME, key, parts)


def _measure(journal: Journal, builds: dict[str, Build], seconds: int) -> bool:
    """Whether it came to its end."""
    jobs = [(builds[part.build].sampler, part.samples) for part in journal.parts]
    try:
        measure_until_converged(jobs, seconds, on_process=journal.append)
    except KeyboardInterrupt:
        return False
    return True


def _write(directory: Path, journal: Journal, builds: dict[str, Build], key: Json) -> list[Path]:
    """A run for each build, of the sweeps that at least one process has measured."""
    runs = []
    for one in builds.values():
        parts = [(part.sweep, part.samples) for part in journal.parts
                 if part.build == one.preset and part.samples.processes]
        if not parts:
            continue
        place = directory / one.preset if len(builds) > 1 else directory
        run_name = f"{directory.resolve().parent.name}/{directory.name}"
        options = {name: key[name] for name in ("quick", "sweeps", "seconds")}
        write_run(place, one.machine, options, parts, run_name)
        runs.append(place)
    return runs


def _summary(directory: Path, runs: list[Path]) -> str:
    """Tables, and the comparison of two compilers."""
    if len(runs) > 1:
        from report.compare import compare_runs  # pylint: disable=import-outside-toplevel
        return compare_runs([load_run(run) for run in runs], directory)
    run = load_run(directory)
    scene = read_csv(directory.parent / TIMINGS) if (directory.parent / TIMINGS).exists() else []
    write_file(directory / MARKDOWN, sweeps_markdown(run, scene).encode())
    text = f"{len(sweep_series(run.rows))} curves; {directory} holds {MARKDOWN}, {TIMINGS}, {RUN} and {SAMPLES}"
    if not (directory.parent / RUN).exists():
        return text
    return f"{text}; ./study build {directory.parent} shows them on the page of the run"
