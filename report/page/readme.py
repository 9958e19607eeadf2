"""Fills the marked parts of a README with the figures of a run; nothing else is touched."""

from __future__ import annotations

import os
import re
from pathlib import Path

from report.errors import ReportError
from report.files import write_file
from report.measure.run import Run, load_run
from report.page.headline import readme_table
from report.page.operations import Rows


def fill_readme(directory: Path, readme: Path) -> str:
    """Returns what was done."""
    rows = Rows(load_run(directory))
    try:
        text = readme.read_text(encoding="utf-8")
    except OSError as error:
        raise ReportError(f"{readme}: cannot be read: {error.strerror}") from None
    text = _replaced(text, "headline", readme_table(rows.headlines()), readme)
    text = _replaced(text, "run", _run_line(rows.run, readme), readme)
    write_file(readme, text.encode())
    return f"{readme}: filled from {directory}"


def _replaced(text: str, name: str, new: str, readme: Path) -> str:
    begin, end = f"<!-- {name}: made by report readme -->", f"<!-- end of {name} -->"
    pattern = re.compile(f"{re.escape(begin)}\n.*?{re.escape(end)}", re.DOTALL)
    if not pattern.search(text):
        raise ReportError(f"{readme}: no '{begin}' with its '{end}'; both marks are needed")
    return pattern.sub(lambda _: f"{begin}\n{new}{end}", text, count=1)


def _run_line(run: Run, readme: Path) -> str:
    where = os.path.relpath(run.directory, readme.parent)
    machine = run.machine
    return (f"Run of commit {machine['commit']} on {machine['cpu']['name']} "
            f"({machine['fingerprint']}), one thread: [all timings]({where}/timings.csv), "
            f"[the paper's claims, judged](report/CLAIMS.md). `python3 -m report build {where}` "
            "makes its page.\n")
