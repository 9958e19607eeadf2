"""Makes every output of a run in memory, then puts all of them on disk."""

from __future__ import annotations

import os
from collections.abc import Iterable
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
from report.plot_style import Plot
from report.plots import make_plots
from report.summary import to_text
from report.sweeps import Section, load_section
from report.sweeps.journal import MAIN
from report.sweeps.section import CSV as SWEEPS_CSV
from report.sweeps.section import MARKDOWN as SWEEPS_MARKDOWN
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
    sweeps = load_section(directory, study.machine.fingerprint)
    plots = make_plots(study)
    shown = [*tables, *([limits] if limits else [])]
    outputs = _plot_files([*plots, *(table.plot for table in shown if table.plot)])
    outputs[CSV] = to_csv(study.rows).encode()
    outputs[MARKDOWN] = to_markdown(study).encode()
    if tables:
        outputs[EXPERIMENTS] = to_experiments_markdown(tables).encode()
    outputs[CLAIMS] = to_markdown_claims(claims, study).encode()
    if limits:
        outputs[LIMITS] = table_block(limits).encode()
    if sweeps:
        outputs |= _sweep_files(sweeps)
    latex = latex_tables(study, tables, claims)
    outputs |= {name: text.encode() for name, text in latex.items()}
    outputs[PAGE] = to_html(study, plots, tables, claims, limits, list(latex), sweeps).encode()
    summary = to_text(study)
    _write_all(directory, outputs)
    return f"{summary}\nPage: {directory / PAGE}\nCSV:  {directory / CSV}"


def build_sweeps(directory: Path) -> str:
    """Writes tables and plots of the sweeps in `directory`, which needs no study."""
    sweeps = load_section(directory)
    if sweeps is None:
        raise ReportError(f"{directory}: holds no samples of sweeps; thinbench_sweeps --out "
                          f"{directory / MAIN} makes some")
    _write_all(directory, _sweep_files(sweeps))
    return f"CSV:    {directory / SWEEPS_CSV}\nTables: {directory / SWEEPS_MARKDOWN}"


def claims_text(directory: Path) -> str:
    """The judged claims of the run in `directory`, as Markdown."""
    study = load_study(directory)
    return to_markdown_claims(judge(study, load_experiments(directory)), study)


def to_markdown_claims(claims: list[Claim], study: Study) -> str:
    """The claims, under a line that says which run they come from."""
    machine = study.machine
    return to_claims_markdown(claims, f"Run of commit {machine.commit} on {machine.cpu_name} "
                                      f"({machine.fingerprint}).")


def _plot_files(plots: Iterable[Plot]) -> dict[str, bytes]:
    files: dict[str, bytes] = {}
    for plot in plots:
        files[f"plots/{plot.stem}.svg"] = plot.svg
        files[f"plots/{plot.stem}.png"] = plot.png
        files[f"plots/{plot.stem}.csv"] = plot.csv.encode()
    return files


def _sweep_files(sweeps: Section) -> dict[str, bytes]:
    return _plot_files(sweeps.plots) | sweeps.outputs


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
