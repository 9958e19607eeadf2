"""Fills the marked parts of README and docs/ with the figures of a run; nothing else is touched.

    <!-- headline: made by report readme -->        the first table
    <!-- speed CASE...: made by report readme -->   speed-ups of all techniques of these cases
    <!-- run: made by report readme -->             which run it was
    ...
    <!-- end -->
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path

from report.errors import ReportError
from report.files import write_file
from report.formatting import NOTHING, markdown_table, speedup_text
from report.measure.run import Run, load_run
from report.measure.timings import Row
from report.page.headline import readme_table
from report.page.operations import Rows, fastest

MARK = re.compile(r"(<!-- (\w+)([^>]*?): made by report readme -->\n).*?(<!-- end -->)", re.DOTALL)


def fill_documents(directory: Path, documents: Sequence[Path]) -> str:
    """Returns what was done. Nothing is written unless every document has marks that are known."""
    rows = Rows(load_run(directory))
    texts = {document: _filled(document, rows) for document in documents}
    for document, text in texts.items():
        write_file(document, text.encode())
    return f"filled from {directory}: {', '.join(path.name for path in documents)}"


def marked(directory: Path) -> list[Path]:
    """README.md and the pages of docs/ that have marks."""
    return [path for path in (directory / "README.md", *sorted((directory / "docs").glob("*.md")))
            if MARK.search(path.read_text(encoding="utf-8"))]


def _filled(document: Path, rows: Rows) -> str:
    try:
        text = document.read_text(encoding="utf-8")
    except OSError as error:
        raise ReportError(f"{document}: cannot be read: {error.strerror}") from None
    if not MARK.search(text):
        raise ReportError(f"{document}: no '<!-- headline: made by report readme -->' with its "
                          "'<!-- end -->', and no other mark")
    return MARK.sub(lambda found: f"{found[1]}{_part(found[2], found[3].split(), rows, document)}"
                                  f"{found[4]}", text)


def _part(name: str, words: list[str], rows: Rows, document: Path) -> str:
    if name == "headline":
        return readme_table(rows.headlines())
    if name == "speed" and words:
        return speed_table(rows, words)
    if name == "run":
        return _run_line(rows.run, document)
    raise ReportError(f"{document}: '{name}': expected headline, speed CASE... or run")


def speed_table(rows: Rows, cases: Sequence[str]) -> str:
    """A line for each technique and ISA, the fastest first, a column for each case."""
    found: dict[tuple[str, str], dict[str, Row]] = {}
    for case in cases:
        for row in sorted(rows.of(case), key=lambda row: row.time_ns):
            if not row.is_reference and (not row.peer or row.technique == _equal_peer(rows, case)):
                found.setdefault((row.technique, row.isa), {})[case] = row
    lines = [[f"`{technique}`", isa, *(speedup_text(own[case]) if case in own else NOTHING
                                       for case in cases)]
             for (technique, isa), own in found.items()]
    return markdown_table(["technique", "ISA", *(f"`{case}`" for case in cases)], lines,
                          frozenset(range(2, 2 + len(cases))))


def _equal_peer(rows: Rows, case: str) -> str:
    best = fastest(rows.own(case))
    return best.peer_name if best else ""


def _run_line(run: Run, document: Path) -> str:
    where = os.path.relpath(run.directory, document.parent)
    machine = run.machine
    return (f"Run of commit {machine['commit']} on {machine['cpu']['name']} "
            f"({machine['fingerprint']}), one thread: [all timings]({where}/timings.csv).\n")
