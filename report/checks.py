"""The table in docs/testing.md of which checks passed, on which commit. `./check --record WHAT` runs
`python3 -m report.checks COMMAND...`."""

from __future__ import annotations

import re
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from report.building import ROOT
from report.errors import ReportError
from report.files import write_file
from report.formatting import markdown_table
from report.git import git

DOCUMENT = ROOT / "docs" / "testing.md"
TABLE = re.compile(r"(?<=<!-- checks: made by check --record -->\n).*?(?=<!-- end -->)", re.DOTALL)
HEADER = ("command", "commit", "minutes", "result")

SUMMARIES = (r"tests failed out of (?P<tests>\d+)", r"(?P<text>\d+ passed.*) in ", r"(?P<text>killed: .*)",
             r"(?P<text>\d+ targets?, .*)", r"(?P<text>memory: .*)", r"(?P<text>every type has one definition)",
             r"^(?P<text>[\d.]+ % of lines, .*)")
"""How the commands say what they did: CTest, pytest, mutants, fuzz, soak, odr, coverage."""


def summary(lines: Sequence[str]) -> str:
    """What a check said last."""
    for line in reversed(lines):
        for pattern in SUMMARIES:
            if found := re.search(pattern, line):
                words = found.groupdict()
                return f"{int(words['tests']):,} tests" if "tests" in words else words["text"].strip()
    return "passed"


def record(command: Sequence[str], document: Path = DOCUMENT) -> int:
    """Runs a check; a row is written only where it passed. Returns its exit status."""
    commit = clean_commit()
    start, lines = time.monotonic(), []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, errors="replace") as process:
        assert process.stdout
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line.rstrip("\n"))
    if process.returncode == 0:
        minutes = f"{(time.monotonic() - start) / 60:.1f}"
        words = [word for word in command[1:] if word != "--no-install"]
        row = [f"`{' '.join(['./check', *words])}`", commit, minutes, summary(lines)]
        write_file(document, with_row(document.read_text(encoding="utf-8"), row).encode())
    return process.returncode


def with_row(text: str, row: Sequence[str]) -> str:
    """The document with a row, in place of that of the same check."""
    def check_of(cells: Sequence[str]) -> str:
        return " ".join(cells[0].strip("`").split()[:2])

    def table(found: re.Match[str]) -> str:
        cells = [[cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
                 for line in found[0].splitlines()[2:]]
        rows = {check_of(one): one for one in (*cells, row)}
        return markdown_table(HEADER, [one for _, one in sorted(rows.items())], frozenset((2,)))
    filled, found = TABLE.subn(table, text, count=1)
    if not found:
        raise ReportError("--record: docs/testing.md has no table of checks")
    return filled


def clean_commit() -> str:
    """What is checked; rows of other checks do not change it."""
    commit = git("rev-parse", "--short=10", "HEAD")
    if commit is None:
        raise ReportError("--record: needs a clone, with git, as a record names its commit")
    if git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!docs/testing.md"):
        raise ReportError("--record: tracked files differ from the commit; commit them first")
    return commit


def main(arguments: Sequence[str]) -> int:
    """COMMAND..."""
    try:
        return record(arguments)
    except ReportError as error:
        print(f"check: {error}", file=sys.stderr)
        return error.status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
