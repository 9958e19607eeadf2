"""`./study pages`: what the library takes for real pictures and drawn pages, beside other projects' code."""

from __future__ import annotations

import argparse
import statistics
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from report.building import BENCHMARKS, build
from report.errors import ReportError
from report.files import check_directory, write_file
from report.formatting import NOTHING, counted, markdown_table, times
from report.git import commit_name
from report.measure.benchmarks import Benchmarks, Json, with_rows
from report.measure.command import RESULTS, add_part_options, budget_of, finished, measure_run
from report.measure.machine import machine_facts
from report.measure.measurement import Part
from report.measure.run import TIMINGS, Run, load_run
from report.measure.timings import END_TO_END, Row
from report.page.operations import COPIES, label, place
from report.page.sentences import choice_text, warning_text
from report.progress import Progress
from report.row_options import add_filter_option

DIRECTORY = "pages"
"""Below the directory of a run."""
MARKDOWN = "pages.md"

INSTALLED = Path("/usr/lib/python3/dist-packages/skimage/data")
PICTURES = ("brick", "bw_text", "camera", "clock_motion", "coins", "grass", "gravel", "horse", "microaneurysms", "moon",
            "page", "text")
"""Grey pictures of the package python3-skimage."""

DRAWN = ("halftone_{}", "page_{}", "noise_{}_5_1", "noise_{}_41_1", "noise_{}_50_4")
SIDE, QUICK_SIDE = 2896, 1024
"""Of drawn pages: 8.4 megapixels."""

LARGE = 4_000_000
"""Pixels, from which pages have a table of their own."""
ABOUT_LARGE = (" These pages pass through memory, which other programs share; probes, which run within a core, do not "
               "notice them there.")

WITHOUT_SLOW = "^(?!(?:thin_[^/]*/opencv|holes/opencv_contours)/)(?=.*(?:{}))"
"""Of the rows of a filter, on drawn pages: OpenCV's thinning and contours take seconds there, beyond what is measured."""

OPERATIONS = ("^(thin_guo_hall|thin_zhang_suen|thin_guo_hall:keep|thin_zhang_suen:keep|thin_mb2|midpoint_scan|edges_sobel|"
              "holes|objects|fill_holes|euler_number|label_image|label_image_4|label_objects|label_regions|"
              "localise_objects|squared_distances|skeleton_graph)/.*/1/end_to_end/")

LIST = "files.txt"
"""Of a directory in YACCLAB's layout: the names of its images, one in a line."""
SUFFIXES = frozenset((".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".pbm", ".pgm", ".ppm", ".pnm", ".pam"))

EPILOG = f"""examples:
  ./study pages --quick
  ./study pages --images scans --seconds 600
  ./study pages --filter '^label_image'

A directory of images may have a list {LIST} of their names, as YACCLAB's datasets have. Images are binarised as
`thinbench run` does it. Every row is verified on every picture before it is timed.

Exit status: 0 done, 1 something is missing or failed, 2 wrong usage, or a variant that differs from its reference."""


def add_pages_command(parser: argparse.ArgumentParser) -> None:
    """Its options."""
    parser.add_argument("--quick", action="store_true", help="drawn pages of 1 instead of 8 megapixels, and less time")
    parser.add_argument("--images", metavar="DIR", type=Path, action="append", default=[],
                        help="the images of this directory instead; repeatable")
    add_filter_option(parser, OPERATIONS)
    add_part_options(parser, 300, 60, DIRECTORY)


def run_pages(_parser: argparse.ArgumentParser, options: argparse.Namespace) -> tuple[str, int]:
    """Returns the table and the exit status."""
    inputs = _inputs(options)
    check_directory(options.out or RESULTS)
    programs = build("release", BENCHMARKS)
    machine = machine_facts(programs / "thinbench_benchmarks", commit_name())
    chosen = {"filter": options.filter, "seconds": budget_of(options),
              "images": [Path(words[1]).name for words in inputs]}
    benchmarks = Benchmarks(programs / "thinbench_benchmarks")
    run, measurement, complete = measure_run(benchmarks, chosen, machine, options,
                                             lambda: _parts(benchmarks, inputs, options.filter), DIRECTORY)
    write_file(run.directory / MARKDOWN, pages_markdown(run).encode())
    return finished(measurement, complete, f"{pages_table(run.rows)}\n{run.directory} holds {MARKDOWN} and {TIMINGS}")


def _inputs(options: argparse.Namespace) -> list[list[str]]:
    """The words of each picture."""
    if options.images:
        paths = [path for directory in options.images for path in images_of(directory)]
        named: dict[str, Path] = {}
        for path in paths:
            if named.setdefault(path.stem, path) is not path:
                raise ReportError(f"--images: '{named[path.stem]}' and '{path}' have one name, '{path.stem}', in tables; "
                                  "rename one", 2)
        return [["--image", str(path)] for path in paths]
    missing = [name for name in PICTURES if not (INSTALLED / f"{name}.png").is_file()]
    if missing:
        raise ReportError(f"{INSTALLED}/{missing[0]}.png is missing; install python3-skimage, or name a directory "
                          "with --images")
    side = QUICK_SIDE if options.quick else SIDE
    return [*(["--image", str(INSTALLED / f"{name}.png")] for name in PICTURES),
            *(["--input", name.format(side)] for name in DRAWN)]


def images_of(directory: Path) -> list[Path]:
    """Those of its list, or all image files in it."""
    listed = directory / LIST
    try:
        if listed.is_file():
            lines = listed.read_text(encoding="utf-8").split("\n")
            found = [directory / name for line in lines if (name := line.strip())]
        else:
            found = sorted(path for path in directory.iterdir() if path.suffix.lower() in SUFFIXES)
    except (OSError, UnicodeDecodeError) as error:
        raise ReportError(f"--images: '{directory}' cannot be read: {getattr(error, 'strerror', error)}", 2) from None
    if not found:
        raise ReportError(f"--images: '{directory}' holds no image; expected files that end in "
                          f"{', '.join(sorted(SUFFIXES))}, or a list {LIST}", 2)
    return found


def _parts(benchmarks: Benchmarks, inputs: Sequence[Sequence[str]], rows: str) -> list[Part]:
    """One for each picture, so that a process loads no other."""
    progress = Progress("verifying pictures", len(inputs))
    parts = []
    for words in inputs:
        chosen = WITHOUT_SLOW.format(rows) if words[0] == "--input" else rows
        facts = benchmarks.verify(["--variants", "best", "--max-call", "0.3", "--filter", chosen, *words],
                                  remarks=not words[1].startswith(str(INSTALLED)))
        parts.append(Part(_without_unshown(facts)))
        progress.advance(1)
    progress.close()
    return parts


def _without_unshown(facts: Json) -> Json:
    """References and scalar variants verify, but would take most of the time."""
    return with_rows(facts, (name for name, row in facts["rows"].items() if row["default"] or row["peer"]))


@dataclass(frozen=True)
class Comparison:
    """An operation, the library's choice on one thread, on all pictures that the peer was timed on, if there is one."""

    case: str
    chosen: tuple[Row, ...]
    peer: str
    ratios: tuple[float, ...]
    """By how much the library is faster, picture by picture."""


def comparisons(rows: Iterable[Row]) -> list[Comparison]:
    """In the order of the page; a line for each peer."""
    chosen: dict[str, dict[str, Row]] = defaultdict(dict)
    peers: dict[str, dict[str, dict[str, Row]]] = defaultdict(lambda: defaultdict(dict))
    for row in rows:
        if row.is_choice:
            chosen[row.case][row.input] = row
        elif _is_peer(row):
            peers[row.case][row.technique][row.input] = row
    found = []
    for case in sorted(chosen, key=place):
        own = chosen[case]
        timed = {peer: both for peer, rows in sorted(peers[case].items())
                 if (both := [(row, rows[name]) for name, row in own.items() if name in rows])}
        if not timed:
            found.append(Comparison(case, tuple(own.values()), "", ()))
        for peer, both in timed.items():
            found.append(Comparison(case, tuple(row for row, _ in both), peer,
                                    tuple(theirs.time_ns / row.time_ns for row, theirs in both)))
    return found


def ratios_table(rows: Sequence[Row]) -> str:
    """For readers in a hurry: by how much the library is faster than the fastest peer of each picture, and whether all
    these peers give its output."""
    lines = []
    for case in dict.fromkeys(one.case for one in comparisons(rows) if one.ratios):
        own = {row.input: row for row in rows if row.is_choice and row.case == case}
        fastest = {name: min(peers, key=lambda row: row.time_ns) for name in own
                   if (peers := [row for row in rows if row.case == case and row.input == name and _is_peer(row)])}
        ratios = {name: peer.time_ns / own[name].time_ns for name, peer in fastest.items()}
        worst = min(ratios, key=lambda name: ratios[name])
        output = "equal" if all(peer.verified for peer in fastest.values()) else "other"
        lines.append([label(case), output, str(len(ratios)), times(ratios[worst]), worst,
                      times(statistics.geometric_mean(ratios.values())), times(max(ratios.values()))])
    return markdown_table(("operation", "output", "pictures", "worst ratio", "on", "mean", "best"), lines,
                          frozenset((2, 3, 5, 6)))


def _is_peer(row: Row) -> bool:
    return row.peer and row.technique not in COPIES and row.threads == 1 and row.scope == END_TO_END


def pages_table(rows: Iterable[Row]) -> str:
    """Per pixel: the mean and the worst picture. Against a peer: the worst, mean and best ratio. Means are geometric."""
    header = ("operation", "pictures", "ps/pixel", "worst", "on", "against", "worst ratio", "mean", "best")
    lines = []
    for one in comparisons(rows):
        slowest = max(one.chosen, key=lambda row: row.ns_per_pixel)
        mean = statistics.geometric_mean(row.ns_per_pixel for row in one.chosen)
        ratios = ([times(min(one.ratios)), times(statistics.geometric_mean(one.ratios)), times(max(one.ratios))]
                  if one.ratios else [NOTHING] * 3)
        lines.append([label(one.case), str(len(one.chosen)), f"{1000 * mean:,.0f}",
                      f"{1000 * slowest.ns_per_pixel:,.0f}", slowest.input, one.peer or NOTHING, *ratios])
    return markdown_table(header, lines, frozenset((1, 2, 3, 6, 7, 8)))


def pages_markdown(run: Run) -> str:
    """The tables, those of large pages apart, then every picture."""
    pictures = {row.input: row for row in run.rows}
    chosen = [row for row in run.rows if row.is_choice]
    cases = sorted({row.case for row in chosen}, key=place)
    cells = {(row.input, row.case): f"{1000 * row.ns_per_pixel:,.0f}{' !' if row.flags else ''}" for row in chosen}
    lines = [[name, f"{row.width} × {row.height}", *(cells.get((name, case), NOTHING) for case in cases)]
             for name, row in pictures.items()]
    small = [row for row in run.rows if row.width * row.height < LARGE]
    large = [row for row in run.rows if row.width * row.height >= LARGE]
    return (f"# Real pictures and drawn pages\n\n{counted(len(pictures), 'picture')}, end to end, one thread, commit "
            f"{run.machine['commit']} on {run.machine['cpu']['name']}. Ratios say how many times as fast as the peer "
            f"this project is; means are geometric. {choice_text(run.rows)}\n\n{warning_text(run)}"
            f"{_section('Pictures', small)}{_section('Pages of 4 megapixels or more', large, ABOUT_LARGE)}"
            "## Picoseconds per pixel\n\n`!` marks what did not settle or whose controls failed.\n\n" +
            markdown_table(("picture", "size", *map(label, cases)), lines, frozenset(range(2, 2 + len(cases)))))


def _section(title: str, rows: Sequence[Row], about: str = "") -> str:
    if not rows:
        return ""
    flagged = sum(bool(row.flags) for row in rows)
    return (f"## {title}\n\n{flagged} of {counted(len(rows), 'result')}, peers' included, are flagged.{about}\n\n"
            f"{pages_table(rows)}\n")


def load_pages(directory: Path) -> Run | None:
    """Of the pages that belong to a run."""
    path = directory / DIRECTORY
    return load_run(path) if (path / TIMINGS).exists() else None
