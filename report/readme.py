"""Fills the tables of a README with the figures of a run: between marks, nothing else is touched.

The headline and the line on the run must be marked; the other tables where the README wants them."""

from __future__ import annotations

import os
import re
from pathlib import Path

from report.errors import ReportError
from report.experiment_layout import markdown_table
from report.loading import load_study
from report.model import Study
from report.short_tables import SHORT_TABLES


def fill_readme(directory: Path, readme: Path) -> str:
    """Writes the tables of the run in `directory` into `readme`; returns what was done."""
    study = load_study(directory)
    text = _read(readme)
    names = [name for name in SHORT_TABLES if name == "headline" or _begin(name) in text]
    for name in names:
        table = SHORT_TABLES[name](study)
        text = _replaced(text, name, markdown_table(table.header, table.rows), readme)
    text = _replaced(text, "run", _run_line(study, readme), readme)
    temporary = readme.with_name(f".{readme.name}.{os.getpid()}.tmp")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(readme)
    return f"{readme}: {len(names)} tables of {directory}"


def _read(readme: Path) -> str:
    try:
        return readme.read_text(encoding="utf-8")
    except OSError as error:
        raise ReportError(f"{readme}: cannot be read: {error.strerror}") from None


def _begin(name: str) -> str:
    return f"<!-- {name}: made by report readme -->"


def _replaced(text: str, name: str, table: str, readme: Path) -> str:
    begin, end = _begin(name), f"<!-- end of {name} -->"
    pattern = re.compile(f"{re.escape(begin)}\n.*?{re.escape(end)}", re.DOTALL)
    if not pattern.search(text):
        raise ReportError(f"{readme}: no '{begin}' with its '{end}'; both marks are needed")
    return pattern.sub(lambda _: f"{begin}\n{table}{end}", text, count=1)


def _run_line(study: Study, readme: Path) -> str:
    where = os.path.relpath(study.directory, readme.parent)
    return (f"Run of commit {study.machine.commit} on {study.machine.cpu_name} "
            f"({study.machine.fingerprint}), one thread: [page]({where}/index.html) (open it from a "
            f"clone), [all rows]({where}/timings.md), [the paper's claims, judged](report/CLAIMS.md).\n")
