"""Makes every output of a run in memory, then puts all of them on disk."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from report.claims import Claim, judge
from report.claims import to_markdown as to_claims_markdown
from report.errors import ReportError
from report.experiment_layout import table_block, to_experiments_markdown
from report.experiment_tables import make_tables
from report.experiments import load_experiments
from report.latex import latex_tables
from report.limit_rows import load_limits
from report.limits import limits_table
from report.loading import load_study
from report.model import Study
from report.page import to_html
from report.plots import make_plots
from report.summary import to_text
from report.tables import to_csv, to_markdown

PAGE, CSV, MARKDOWN = "index.html", "timings.csv", "timings.md"
EXPERIMENTS, CLAIMS, LIMITS = "experiments.md", "claims.md", "limits.md"


def build(directory: Path) -> str:
    """Writes tables, plots and the page into `directory`; returns the summary to print.

    Nothing is written before everything has been made, and no file takes its
    name before all of them are complete.
    """
    study = load_study(directory)
    experiments = load_experiments(directory)
    tables = make_tables(study, experiments)
    claims = judge(study, experiments)
    limits = limits_table(study, load_limits(directory))
    plots = make_plots(study)
    outputs: dict[str, bytes] = {}
    shown = [*tables, *([limits] if limits else [])]
    for plot in [*plots, *(table.plot for table in shown if table.plot)]:
        outputs[f"plots/{plot.stem}.svg"] = plot.svg
        outputs[f"plots/{plot.stem}.png"] = plot.png
        outputs[f"plots/{plot.stem}.csv"] = plot.csv.encode()
    outputs[CSV] = to_csv(study.rows).encode()
    outputs[MARKDOWN] = to_markdown(study).encode()
    if tables:
        outputs[EXPERIMENTS] = to_experiments_markdown(tables).encode()
    outputs[CLAIMS] = to_markdown_claims(claims, study).encode()
    if limits:
        outputs[LIMITS] = table_block(limits).encode()
    latex = latex_tables(study, tables, claims)
    outputs |= {name: text.encode() for name, text in latex.items()}
    outputs[PAGE] = to_html(study, plots, tables, claims, limits, list(latex)).encode()
    summary = to_text(study)
    _write_all(directory, outputs)
    return f"{summary}\nPage: {directory / PAGE}\nCSV:  {directory / CSV}"


def claims_text(directory: Path) -> str:
    """The judged claims of the run in `directory`, as Markdown."""
    study = load_study(directory)
    return to_markdown_claims(judge(study, load_experiments(directory)), study)


def to_markdown_claims(claims: list[Claim], study: Study) -> str:
    """The claims, under a line that says which run they come from."""
    machine = study.machine
    return to_claims_markdown(claims, f"Run of commit {machine.commit} on {machine.cpu_name} "
                                      f"({machine.fingerprint}).")


def _write_all(directory: Path, outputs: dict[str, bytes]) -> None:
    """Writes everything under temporary names first, then renames, which is atomic."""
    staged: list[tuple[Path, Path]] = []
    try:
        for name, data in outputs.items():
            path = directory / name
            path.parent.mkdir(exist_ok=True)
            temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
            staged.append((temporary, path))
            temporary.write_bytes(data)
        for temporary, path in staged:
            temporary.replace(path)
    except OSError as error:
        raise ReportError(f"{error.filename or directory}: cannot be written: {error.strerror}; "
                          "a directory that may be written to is needed") from None
    finally:
        for temporary, _ in staged:
            _forget(temporary)


def _forget(temporary: Path) -> None:
    """Removes what is left of an attempt; where nothing could be written, nothing is."""
    with suppress(OSError):
        temporary.unlink()
