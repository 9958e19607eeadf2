"""results/checks.json: which checks passed, on which commit. `./check --record WHAT` runs
`python3 -m report.checks WHAT COMMAND...`; docs/testing.md shows the file as a table."""

from __future__ import annotations

import datetime
import json
import re
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from report.building import ROOT
from report.errors import ReportError
from report.files import read_json, write_file
from report.formatting import markdown_table
from report.git import git
from report.measure.sampler import Json

RECORDS = ROOT / "results" / "checks.json"
HEADER = ("command", "commit", "date", "processor", "minutes", "result")

SUMMARIES = (r"tests failed out of (?P<tests>\d+)", r"(?P<text>\d+ passed.*) in ", r"(?P<text>killed: .*)",
             r"(?P<text>\d+ targets, .*)", r"(?P<text>memory: .*)", r"(?P<text>every type has one definition)",
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


def record(what: str, command: Sequence[str], records: Path = RECORDS) -> int:
    """Runs a check; an entry is written only where it passed. Returns its exit status."""
    commit = clean_commit()
    start, lines = time.monotonic(), []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, errors="replace") as process:
        assert process.stdout
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line.rstrip("\n"))
    if process.returncode == 0:
        known = read_json(records) if records.exists() else {}
        known[what] = {"command": " ".join(["./check", *command[1:]]), "commit": commit,
                       "date": datetime.date.today().isoformat(), "processor": processor(),
                       "minutes": round((time.monotonic() - start) / 60, 1), "result": summary(lines)}
        write_file(records, (json.dumps(known, indent=1, sort_keys=True) + "\n").encode())
    return process.returncode


def clean_commit() -> str:
    """What is checked; notes of other checks do not change it."""
    commit = git("rev-parse", "--short=10", "HEAD")
    if commit is None:
        raise ReportError("--record: needs a clone, with git, as a record names its commit")
    if git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!results/checks.json"):
        raise ReportError("--record: tracked files differ from the commit; commit them first")
    return commit


def processor(file: Path = Path("/proc/cpuinfo")) -> str:
    """As the system names it."""
    found = re.search(r"^model name\s*: (.*)", file.read_text(encoding="utf-8"), re.MULTILINE)
    return found[1] if found else "unknown"


def checks_table(records: Path = RECORDS) -> str:
    """As Markdown, a line for each check that was recorded."""
    known: Json = read_json(records)
    rows = [[f"`{one['command']}`", *(str(one[key]) for key in HEADER[1:])] for _, one in sorted(known.items())]
    return markdown_table(HEADER, rows, frozenset((4,)))


def main(arguments: Sequence[str]) -> int:
    """WHAT COMMAND..."""
    try:
        return record(arguments[0], arguments[1:])
    except ReportError as error:
        print(f"check: {error}", file=sys.stderr)
        return error.status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
