"""Options of `./study regress` and the order in which things are done."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable
from pathlib import Path

from report.building import BENCHMARKS, ROOT, build
from report.errors import ReportError
from report.files import to_json, write_file, write_files
from report.git import commit_name, git, is_clean
from report.measure.benchmarks import Benchmarks, Json
from report.measure.measurement import measured
from report.measure.machine import machine_facts
from report.regress import counts, output, self_test, stored, times
from report.regress.machine_code import same_isas
from report.regress.verdicts import EXIT_STATUS, WRONG_USAGE, Layer, Verdict, exit_status
from report.row_options import (add_row_options, binarise_words, check_binarise_options,
                                input_words)

BASELINES = ROOT / "results" / "baselines"

FILTER = ("^(thin_naccache_shinghal|thin_zhang_suen|thin_guo_hall|midpoint_scan|edges_sobel|holes|"
          "localise_objects)/(bitpacked|bitpacked_runs|simd_bitpacked|simd_bitpacked_tiles|"
          "simd_bitpacked_row|simd_16bit|simd_runs)/[a-z0-9.]+/1/")

EPILOG = """Two layers.
Instructions are exact on the busiest machine: FAIL where a row takes over 1 % more,
or another number of iterations. Times: without --against, they (speed-ups, where references moved)
are compared with the baseline of this processor, compiler and flags, in the same state of the
machine; a row may lose 10 % (20 % on images beyond the cache). With --against both builds are
measured side by side, and a row may lose 2.5 %; the commit is built once, in build/against/, and
rows whose machine code is the same pass unmeasured. What is not clear is measured further, and is
FAIL only if two rounds in a row say so.

examples:
  ./study regress --against main
  ./study regress --base-build ../old/build/release/bin
  ./study regress --counts-only --against origin/main --junit regress.xml --github
  ./study regress --update --reason 'two rows of runs are read at once'

Exit status: 1 FAIL where either layer fails, else what times say (with --counts-only instructions):
0 PASS, 3 INCONCLUSIVE, 4 nothing was compared. 2 wrong usage, or something went wrong."""

Builder = Callable[[Path, tuple[str, ...]], Path]


def add_regress_command(parser: argparse.ArgumentParser) -> None:
    """Its options."""
    parser.add_argument("--against", metavar="COMMIT",
                        help="compare the working tree with a commit, not with the baseline")
    parser.add_argument("--base-build", metavar="DIR", type=_programs,
                        help="compare with the programs in DIR, such as build/release/bin of "
                             "another clone, not with a commit that is built first")
    add_row_options(parser, FILTER)
    parser.add_argument("--all", action="store_true", help="show rows that passed as well")
    parser.add_argument("--judge-threads", action="store_true",
                        help="judge rows with threads as well: on an otherwise idle machine only")
    parser.add_argument("--baselines", metavar="DIR", type=Path,
                        default=BASELINES,
                        help="where baselines are; default results/baselines")
    parser.add_argument("--update", action="store_true",
                        help="make this run the baseline; needs --reason and a quiet machine")
    parser.add_argument("--reason", metavar="TEXT", help="why, for the baseline's history")
    layers = parser.add_mutually_exclusive_group()
    layers.add_argument("--no-instructions", action="store_true",
                        help="only times; with --update the counts stay as they are")
    layers.add_argument("--counts-only", action="store_true",
                        help="only instructions: exact on shared machines, and quick")
    parser.add_argument("--junit", metavar="FILE", type=Path, help="write verdicts as JUnit XML")
    parser.add_argument("--bencher", metavar="FILE", type=Path,
                        help="write speed-ups, times and instructions in Bencher Metric Format")
    parser.add_argument("--github", action="store_true",
                        help="print annotations of GitHub Actions and append to the job's summary, "
                             "where something is wrong")
    parser.add_argument("--self-test", action="store_true",
                        help="show how often the check is right about known slowdowns and loads")
    parser.add_argument("--quick", action="store_true", help="with --self-test: fewer attempts")


def _programs(text: str) -> Path:
    path = Path(text)
    if not (path / "thinbench-study").is_file():
        raise argparse.ArgumentTypeError(f"'{text}' holds no program thinbench-study")
    return path.resolve()


def build_programs(root: Path, targets: tuple[str, ...]) -> Path:
    """The programs of a working tree."""
    return build("release", targets, root)


def run_regress(parser: argparse.ArgumentParser, options: argparse.Namespace,
                builder: Builder = build_programs) -> tuple[str, int]:
    """Returns what to print and the exit status."""
    _check(parser, options)
    try:
        return _run(options, builder)
    except ReportError as error:
        known = error.status in (EXIT_STATUS[Verdict.SKIPPED], EXIT_STATUS[Verdict.INCONCLUSIVE])
        raise ReportError(f"regress: {error}", error.status if known else WRONG_USAGE) from None


def _check(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    check_binarise_options(parser, options, options.image)
    if options.quick and not options.self_test:
        parser.error("--quick needs --self-test")
    if options.reason is not None and not options.update:
        parser.error("--reason needs --update")
    if options.against is not None and options.base_build is not None:
        parser.error("--against builds a commit, --base-build is a build: give one of them")
    if options.base_build and not options.counts_only and not (options.base_build / "thinbench_benchmarks").is_file():
        parser.error(f"--base-build: '{options.base_build}' holds no program thinbench_benchmarks, which only "
                     "--counts-only does without")
    if options.update:
        _check_update(parser, options)
    if options.against is not None and git("rev-parse", "--verify", "--quiet",
                               f"{options.against}^{{commit}}") is None:
        parser.error(f"there is no commit '{options.against}' in this clone; a shallow one lacks "
                     "most of them, and without git there are none")


def _check_update(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if not options.reason:
        parser.error("--update needs --reason TEXT, which the history keeps")
    if options.against or options.base_build or options.counts_only:
        parser.error("--update makes a baseline; it excludes --against, --base-build and "
                     "--counts-only")
    if _is_part(options) and options.baselines == BASELINES:
        parser.error("--update replaces all rows of a baseline; with --filter or --image it needs --baselines DIR")
    if not is_clean():
        parser.error("--update needs a clone without changes: a baseline names its commit")


def _run(options: argparse.Namespace, builder: Builder) -> tuple[str, int]:
    if options.self_test:
        return self_test.run(builder(ROOT, BENCHMARKS), options.quick)
    programs = builder(ROOT, _targets(options))
    machine = machine_facts(programs / "thinbench_benchmarks", commit_name())
    if options.update:
        return _update(options, programs, machine), 0
    found = _compare(options, programs, _base_programs(options, builder), machine)
    _write(options, found)
    text = output.to_annotations(found) if options.github else ""
    return (text + output.to_text(found, options.all),
            exit_status(found.instructions, found.times, options.counts_only))


def _targets(options: argparse.Namespace) -> tuple[str, ...]:
    return BENCHMARKS + (() if options.no_instructions else ("thinbench_study", "thinbench_counted_calls"))


def _base_programs(options: argparse.Namespace, builder: Builder) -> Path | None:
    """The programs of the other build. A commit is checked out and built below build/, once."""
    base: Path | None = options.base_build
    if base is not None or not options.against:
        return base
    commit = git("rev-parse", f"{options.against}^{{commit}}")
    tree = ROOT / "build" / "against" / str(commit)
    # By force, as the directory of an earlier one may have been deleted.
    if not tree.exists() and git("worktree", "add", "--force", "--quiet", "--detach", str(tree),
                                 str(commit)) is None:
        raise ReportError(f"cannot check out {options.against}")
    _check_programs(options, tree)
    return builder(tree, _targets(options))


def _check_programs(options: argparse.Namespace, tree: Path) -> None:
    needed = "bench/study" if options.counts_only else "bench/measure/probe.cpp"
    if not (tree / needed).exists():
        raise ReportError(f"nothing was compared: commit {options.against} has no {needed}",
                          EXIT_STATUS[Verdict.SKIPPED])


def _compare(options: argparse.Namespace, programs: Path, before: Path | None,
             machine: Json) -> output.Outcome:
    isas = machine["isa_available"]
    same = same_isas(before, programs, isas) if before else set()
    exact = counts.not_compared("--no-instructions")
    if same == set(isas):
        exact = counts.Counts(Layer(Verdict.PASS, [], "instructions: not counted, as both builds "
                                                      "are the same machine code"))
    elif not options.no_instructions:
        exact = _compare_counts(options, programs, before, machine)
    layer = Layer(Verdict.SKIPPED, [], "times are not compared: --counts-only")
    if not options.counts_only:
        layer = _compare_times(options, programs, before, same, machine)
    return output.Outcome(exact.layer, layer, exact.instructions)


def _compare_counts(options: argparse.Namespace, programs: Path, before: Path | None,
                    machine: Json) -> counts.Counts:
    words, file = _count_words(options), _files(options, machine)[1]
    if before is None and not file.exists():
        return counts.not_compared(f"there is no '{file}'; ./study regress --update writes it")
    try:
        old = (counts.count(before / "thinbench-study", words) if before
               else counts.read_counts(file))
        return counts.compare(old, counts.count(programs / "thinbench-study", words),
                              is_part=before is None and _is_part(options))
    except ReportError as error:
        if error.status != WRONG_USAGE:
            raise
        return counts.not_compared(str(error))  # such as a filter without rows on one thread


def _compare_times(options: argparse.Namespace, programs: Path, before: Path | None,
                   same: set[str], machine: Json) -> Layer:
    benchmarks, words = Benchmarks(programs / "thinbench_benchmarks"), _words(options)
    if before is None:
        return times.against_stored(benchmarks, words, machine, _files(options, machine)[0],
                                    options.judge_threads, _is_part(options))
    return times.between_builds((Benchmarks(before / "thinbench_benchmarks"), benchmarks), words, same,
                                options.judge_threads)


def _is_part(options: argparse.Namespace) -> bool:
    """Whether other rows are chosen than a baseline holds."""
    return bool(options.filter != FILTER or options.image)


def _update(options: argparse.Namespace, programs: Path, machine: Json) -> str:
    """Counts first, so that a baseline never lacks its counts."""
    file, counts_file = _files(options, machine)
    previous = stored.read_baseline(file)
    outputs: dict[str, bytes] = {}
    if not options.no_instructions:
        outputs[counts_file.name] = to_json(counts.count(programs / "thinbench-study",
                                                         _count_words(options)))
    benchmarks = Benchmarks(programs / "thinbench_benchmarks")
    facts = benchmarks.verify(_words(options))
    now = stored.measured_from(facts, measured(benchmarks, facts, stored.UPDATE_PROCESSES))
    if why_not := stored.why_unfit(now):
        raise ReportError(f"no baseline was written: {why_not}; a quiet machine is needed",
                          EXIT_STATUS[Verdict.INCONCLUSIVE])
    baseline = stored.baseline_from(now, machine, options.filter, options.reason, previous)
    write_files(options.baselines, {file.name: to_json(baseline)} | outputs)
    return f"{file}: {len(baseline['rows'])} rows"


def _files(options: argparse.Namespace, machine: Json) -> tuple[Path, Path]:
    """The baseline of times and that of instructions."""
    name = machine["fingerprint"]
    return options.baselines / f"{name}.json", options.baselines / f"{name}-instructions.json"


def _words(options: argparse.Namespace) -> list[str]:
    variants = "usual" if options.filter == FILTER else "all"
    return ["--no-peers", "--variants", variants, "--filter", options.filter,
            *input_words(options)]


def _count_words(options: argparse.Namespace) -> list[str]:
    """Instructions are counted on a small copy of the scene or of the first image."""
    images = (["--image", str(options.image[0]), *binarise_words(options)] if options.image
              else [])
    return ["--filter", options.filter, *images]


def _write(options: argparse.Namespace, found: output.Outcome) -> None:
    if options.junit:
        write_file(options.junit, output.to_junit(found))
    if options.bencher:
        write_file(options.bencher, to_json(output.to_bencher(found)))
    summary = os.environ.get("GITHUB_STEP_SUMMARY")
    if options.github and summary:
        try:
            with open(summary, "a", encoding="utf-8") as stream:
                stream.write(output.to_markdown(found))
        except OSError as error:
            print(f"GITHUB_STEP_SUMMARY: '{summary}' cannot be written: {error.strerror}", file=sys.stderr)
