"""How much of kernels/ all tests run. Run as `python3 -m tests.coverage.run` by ./check coverage.

Runs ctest on the build with coverage mapping, merges what the programs counted and compares lines and branches with
the limits. explained.txt says of each file with a gap why no test runs it; a gap without a reason is an error."""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from report.building import build
from report.errors import ReportError
from report.formatting import counted

ROOT = Path(__file__).resolve().parents[2]
EXPLAINED = Path(__file__).with_name("explained.txt")
BUILD = ROOT / "build" / "coverage"
REQUIRED_LINES, REQUIRED_BRANCHES = 98.0, 95.0


@dataclass
class FileCoverage:
    """Of one source file, over all programs, ISAs and template arguments."""

    lines: dict[int, int] = field(default_factory=dict)
    """How often each line ran."""
    branches: dict[tuple[int, int], tuple[int, int]] = field(default_factory=dict)
    """By line and column of a condition: how often it was true and false."""

    def missed_lines(self) -> list[int]:
        return sorted(line for line, count in self.lines.items() if count == 0)

    def outcomes(self) -> dict[tuple[int, int], tuple[int, int]]:
        """Without conditions that the compiler knows: they count nothing although their line runs."""
        return {place: counts for place, counts in self.branches.items()
                if any(counts) or self.lines.get(place[0], 0) == 0}

    def missed_outcomes(self) -> list[str]:
        return [f"{line}:{column} never {name}" for (line, column), counts in sorted(self.outcomes().items())
                for name, count in zip(("true", "false"), counts, strict=True) if count == 0]

    def has_gap(self) -> bool:
        return bool(self.missed_lines() or self.missed_outcomes())


def parse_lcov(text: str, files: dict[str, FileCoverage]) -> None:
    """Adds the counts of lines."""
    lines: dict[int, int] = {}
    for record in text.splitlines():
        key, _, value = record.partition(":")
        if key == "SF":
            lines = files[value].lines
        elif key == "DA":
            line, count = map(int, value.split(",")[:2])
            lines[line] = lines.get(line, 0) + count


def parse_branches(exported: Any, files: dict[str, FileCoverage]) -> None:
    """Adds the outcomes of conditions in llvm-cov's JSON; instantiations of a template are one."""
    for source in exported["data"][0]["files"]:
        branches = files[source["filename"]].branches
        for line, column, _, _, taken, not_taken, *_ in source["branches"]:
            before = branches.get((line, column), (0, 0))
            branches[line, column] = (before[0] + taken, before[1] + not_taken)


def drop_compile_time(exported: Any, files: dict[str, FileCoverage]) -> None:
    """Forgets constexpr and consteval functions that never ran: the compiler has evaluated them."""
    counts: dict[tuple[str, int, int], int] = defaultdict(int)
    for function in exported["data"][0]["functions"]:
        first, _, last, *_ = function["regions"][0]
        counts[function["filenames"][0], first, last] += function["count"]
    for (name, first, last), count in counts.items():
        if count > 0 or name not in files or not is_for_compilers(Path(name).read_text(encoding="utf-8"), first):
            continue
        found = files[name]
        found.lines = {line: n for line, n in found.lines.items() if not first <= line <= last}
        found.branches = {at: n for at, n in found.branches.items() if not first <= at[0] <= last}


def is_for_compilers(source: str, line: int) -> bool:
    """Whether the function whose body begins in this line, counted from 1, is declared constexpr or consteval."""
    declaration = []
    for text in reversed(source.splitlines()[:line]):
        if declaration and (not text.strip() or text.rstrip().endswith((";", "}", "{", ":"))):
            break
        declaration.append(text.partition("//")[0])
    return re.search(r"\bconst(expr|eval)\b", "\n".join(reversed(declaration))) is not None


def explanations(text: str) -> dict[str, str]:
    """Of lines `file: reason`."""
    pairs = (line.partition(": ") for line in text.splitlines() if line and not line.startswith("#"))
    return {name: reason for name, _, reason in pairs}


def share(covered: int, count: int) -> float:
    return 100.0 * covered / count if count else 100.0


def summary(files: dict[str, FileCoverage]) -> tuple[list[str], float, float]:
    """A table by directory; percentages of all lines and outcomes."""
    totals: dict[str, list[int]] = defaultdict(lambda: [0, 0, 0, 0])
    for name, found in files.items():
        numbers = (len(found.lines) - len(found.missed_lines()), len(found.lines),
                   2 * len(found.outcomes()) - len(found.missed_outcomes()), 2 * len(found.outcomes()))
        for group in (name.split("/")[1], "all"):
            totals[group] = [a + b for a, b in zip(totals[group], numbers, strict=True)]
    table = [f"{'kernels/':<12}{'lines':>14}{'%':>8}{'branches':>14}{'%':>8}"]
    for group in [*sorted(totals.keys() - {"all"}), "all"]:
        lines, all_lines, outcomes, all_outcomes = totals[group]
        table.append(f"{group:<12}{f'{lines}/{all_lines}':>14}{share(lines, all_lines):>8.2f}"
                     f"{f'{outcomes}/{all_outcomes}':>14}{share(outcomes, all_outcomes):>8.2f}")
    total = totals["all"]
    return table, share(total[0], total[1]), share(total[2], total[3])


def gaps(files: dict[str, FileCoverage], reasons: dict[str, str]) -> tuple[list[str], list[str]]:
    """What no test runs, by file with its reason; and which files have none. A reason without a gap may only mean that
    the cross-check drew other images."""
    shown = [f"{name}: has a reason but no gap this time" for name in reasons
             if name not in files or not files[name].has_gap()]
    wrong = []
    for name, found in sorted(files.items()):
        if not found.has_gap():
            continue
        lines = ", ".join(map(str, found.missed_lines()))
        shown.append(f"{name}: {reasons.get(name, 'NOT EXPLAINED')}")
        shown += [f"    lines {lines}"] if lines else []
        shown += [f"    {outcome}" for outcome in found.missed_outcomes()]
        if name not in reasons:
            wrong.append(f"{name} has a gap that explained.txt does not explain")
    return shown, wrong


def export(programs: Path, library: Path, profiles: Path) -> dict[str, FileCoverage]:
    """By path from the root. Every program of the build holds the kernels; some hold more of them than others."""
    merged = profiles / "all.profdata"
    subprocess.run(["llvm-profdata", "merge", "-sparse", "-o", str(merged),
                    *map(str, profiles.glob("*.profraw"))], check=True)
    objects = [argument for path in sorted(programs.iterdir()) if path.is_file() and os.access(path, os.X_OK)
               for argument in ("-object", str(path))]
    command = ["llvm-cov", "export", f"-instr-profile={merged}", str(library), *objects]
    sources = [str(ROOT / "kernels")]
    found: dict[str, FileCoverage] = defaultdict(FileCoverage)
    parse_lcov(subprocess.run([*command, "-format=lcov", *sources], check=True, capture_output=True, text=True).stdout,
               found)
    exported = json.loads(subprocess.run([*command, *sources], check=True, capture_output=True).stdout)
    parse_branches(exported, found)
    drop_compile_time(exported, found)
    return {str(Path(name).resolve().relative_to(ROOT)): files for name, files in found.items()}


def check_counts(log: str) -> None:
    """Fails if programs could not add their counts, as another has taken the name of their file."""
    lost = re.findall(r"^LLVM Profile Error: Profile Merging of file (\S+) failed", log, re.MULTILINE)
    if lost:
        raise ReportError(f"the counts of {counted(len(lost), 'test')} are lost; the first: {lost[0]} is of another program")


def main() -> int:
    parser = argparse.ArgumentParser(prog="./check coverage", description=__doc__)
    parser.add_argument("--report-only", action="store_true", help="take the counts of the last run of the tests")
    arguments = parser.parse_args()
    profiles = BUILD / "profiles"
    if not arguments.report_only:
        build("coverage")
        shutil.rmtree(profiles, ignore_errors=True)
        environment = os.environ | {"LLVM_PROFILE_FILE": f"{profiles}/%2m.profraw"}
        tests = subprocess.run(["ctest", "--preset", "coverage", "--parallel", str(os.cpu_count())], cwd=ROOT,
                               env=environment, check=False)
        if tests.returncode != 0:
            return tests.returncode
        check_counts((BUILD / "Testing" / "Temporary" / "LastTest.log").read_text(encoding="utf-8", errors="replace"))
    if not profiles.is_dir():
        raise ReportError("there are no counts of an earlier run; leave out --report-only")
    files = export(BUILD / "bin", BUILD / "python" / "thinbench" / "libthinbench.so", profiles)
    shown, wrong = gaps(files, explanations(EXPLAINED.read_text(encoding="utf-8")))
    table, lines, branches = summary(files)
    print("\n".join([*shown, "", *table]))
    if lines < REQUIRED_LINES or branches < REQUIRED_BRANCHES:
        wrong.append(f"required are {REQUIRED_LINES:g} % of lines and {REQUIRED_BRANCHES:g} % of branches")
    print(f"{lines:.2f} % of lines, {branches:.2f} % of branches")
    for line in wrong:
        print(f"coverage: {line}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except ReportError as error:
        sys.exit(f"check: {error}")
