"""`./study`: builds, verifies, measures and writes results, CSV, plots and a page."""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from pathlib import Path

from report.building import BENCHMARKS, build, isas_in_use
from report.errors import ReportError
from report.files import check_directory
from report.git import commit_name
from report.measure.benchmarks import Benchmarks, Json
from report.measure.command import RESULTS, add_time_options, budget_of, finished, measure_run
from report.measure.measurement import Part
from report.measure.machine import machine_facts
from report.row_options import (add_row_options, binarise_words, check_binarise_options, image_file,
                                input_words, positive)

SERIES = "^(thin_naccache_shinghal|edges_sobel|holes|localise_objects)/.*/end_to_end/"
"""What the default series of sizes measures."""

BATCHES = "^(batch_guo_hall|batch_zhang_suen|batch_naccache_shinghal)/"
"""Many small images; measured where a filter names them."""

EPILOG = """examples:
  ./study --quick
  ./study --image horse.png --filter 'simd|bitpacked'
  ./study --image parts.jpg --foreground dark --threshold 100
  ./study --size 1000 --size 3000
  THINBENCH_MAX_ISA=avx2 ./study --quick --out /tmp/avx2

Every command takes --no-install, too: do not look for packages. Others: pages, sweeps, many-images,
regress, compare, build, readme; see ./study COMMAND --help.

Exit status: 0 done, 1 something is missing or failed, 2 wrong usage, a variant that differs from its
reference, or no row that matches."""


def add_study_command(parser: argparse.ArgumentParser) -> None:
    """Its options."""
    parser.add_argument("--quick", action="store_true",
                        help="fewer sizes and less time: about a minute after the build")
    add_row_options(parser)
    parser.add_argument("--quality-image", metavar="FILE", type=image_file, action="append", default=[],
                        help="measure the quality of skeletons on this image as well, without "
                             "timing it; repeatable")
    parser.add_argument("--size", metavar="N", type=positive, action="append", default=[],
                        help="time every operation on a square of N x N pixels; repeatable")
    parser.add_argument("--out", metavar="DIR", type=Path,
                        help="where results go; default results/<machine>/<date>-<commit>")
    parser.add_argument("--all", action="store_true",
                        help="time every variant, not only the best of each ISA and the highest ISA "
                             "of each technique")
    parser.add_argument("--threads", metavar="LIST", type=_thread_counts, default=[2],
                        help="numbers of threads, such as 2,4,8, for variants with threads; default "
                             "2. They are timed where the library would use them: on images of "
                             "2^20 pixels and more; with --all on every image")
    add_time_options(parser, 300, 60)
    parser.add_argument("--no-peers", action="store_true",
                        help="do not time other projects' code and the copy")


def _thread_counts(text: str) -> list[int]:
    """Such as 2,4,8."""
    if not re.fullmatch("[0-9]{1,4}(,[0-9]{1,4})*", text):
        raise argparse.ArgumentTypeError(f"expected integers with commas between them, got '{text}'")
    counts = [int(one) for one in text.split(",")]
    if not all(2 <= count <= 1024 for count in counts):
        raise argparse.ArgumentTypeError(f"expected integers in [2, 1024], got '{text}'")
    return list(dict.fromkeys(counts))


def run_study(parser: argparse.ArgumentParser, options: argparse.Namespace) -> tuple[str, int]:
    """Returns the summary to print and the exit status."""
    check_binarise_options(parser, options, options.image + options.quality_image)
    check_directory(options.out or RESULTS)
    experiments = ("thinbench_study",) if _quality_images(options) else ()
    programs = build("release", BENCHMARKS + experiments, isas=isas_in_use() if options.quick else ())
    machine = machine_facts(programs / "thinbench_benchmarks", commit_name())
    benchmarks = Benchmarks(programs / "thinbench_benchmarks")
    run, measurement, complete = measure_run(benchmarks, _options_json(options), machine, options,
                                             lambda: [Part(benchmarks.verify(words), options=_short(options))
                                                      for words in plans_of(options)])
    write_pictures(programs / "thinbench_benchmarks", run.directory, options)
    if complete:
        measure_quality(programs / "thinbench-study", run.directory, options)
    from report.page.build import build_page  # pylint: disable=import-outside-toplevel
    return finished(measurement, complete, build_page(run.directory))


def _short(options: argparse.Namespace) -> list[str]:
    """So that a quick run, too, has more than a few processes: a neighbour stays for seconds."""
    return ["--seconds-per-row", "0.002"] if options.quick else []


def plans_of(options: argparse.Namespace) -> list[list[str]]:
    """The words of each plan: the images, the series of sizes, and sizes that were asked for."""
    common = ["--no-peers"] if options.no_peers else []
    common += [word for count in options.threads for word in ("--threads", str(count))]
    variants = "all" if options.all else "usual"
    plans = [[*common, *input_words(options), "--variants", variants, "--filter", options.filter]]
    if not options.filter:
        largest = 512 if options.quick else 4096
        squares = [side for step in range(7) if (side := 64 << step) <= largest and side not in options.size]
        if squares:  # without inputs, a plan is of the scene
            plans.append(["--no-peers", "--variants", "highest", "--filter", SERIES,
                          "--max-call", "0.3", *_inputs(squares)])
        plans.append(["--no-peers", "--variants", variants, "--filter", BATCHES,
                      "--input", "strokes_28_2000", "--input", "strokes_64_500"])
    if options.size:
        plans.append([*common, "--variants", variants, "--filter", options.filter,
                      *_inputs(list(dict.fromkeys(options.size)))])
    return plans


def _inputs(sizes: list[int]) -> list[str]:
    return [word for size in sizes for word in ("--input", f"square_{size}")]


def _options_json(options: argparse.Namespace) -> Json:
    """Images by their files' names, as directories are private."""
    return {"quick": options.quick, "filter": options.filter, "seconds": budget_of(options), "all": options.all,
            "peers": not options.no_peers, "threads": options.threads, "foreground": options.foreground,
            "threshold": options.threshold, "sizes": options.size,
            "images": [image.name for image in options.image]}


def write_pictures(program: Path, directory: Path, options: argparse.Namespace) -> None:
    """The inputs and what operations make of them, for the page."""
    _run(program, ["--pictures", str(directory / "pictures"), *input_words(options)], _shown(options))


def _quality_images(options: argparse.Namespace) -> list[Path]:
    """Those that were named for it and, unless only some rows are measured, those that are timed."""
    timed = [] if options.filter else options.image
    return [*timed, *options.quality_image]


def measure_quality(program: Path, directory: Path, options: argparse.Namespace) -> None:
    """Skeletons of the user's images; those of the built-in images are in results/experiments."""
    images = _quality_images(options)
    (directory / "experiments" / "quality.json").unlink(missing_ok=True)
    if images:
        words = [word for image in images for word in ("--image", str(image))]
        (directory / "experiments").mkdir(exist_ok=True)
        _run(program, ["experiment", "quality", *words, *binarise_words(options),
                       "--out", str(directory / "experiments" / "quality.json")], _shown(options))


def _shown(options: argparse.Namespace) -> tuple[str, ...]:
    """How lines begin that say nothing new: remarks on timed images, what is skipped, and files."""
    return ("skipped ", "wrote ", *(f"{kind}: {image}: " for image in options.image
                          for kind in ("note", "warning")))


def _run(program: Path, words: list[str], shown: tuple[str, ...]) -> None:
    """Lines that were shown before are left out."""
    with subprocess.Popen([program, *words], stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr
        failure = ""
        for line in process.stderr:
            if line.startswith(f"{program.name}: "):
                failure = line
            elif not line.startswith(shown):
                sys.stderr.write(line)
    if process.returncode != 0:
        sys.stderr.write(failure)
        raise ReportError(f"{program.name} {words[0]} failed; see the line above")
