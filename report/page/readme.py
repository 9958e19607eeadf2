"""Fills the marked parts of README and docs/ with the figures of a run; nothing else is touched.

    <!-- headline: made by report readme -->               the first table
    <!-- speed CASE...: made by report readme -->          speed-ups of the techniques of these cases,
                                                           CASE@INPUT for another image
    <!-- claims: made by report readme -->                 the paper's claims, judged
    <!-- quality: made by report readme -->                skeletons of the scene, by results/experiments
    <!-- run: made by report readme -->                    which run it was
    <!-- pages: made by report readme -->                  ratios on real pictures, by `./study pages`
    <!-- many-images EXPERIMENT: made by report readme --> a table of `./study many-images`, and its run
    ...
    <!-- end -->

A directory fills the parts of what it holds: a run, many images, or both.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import pandas as pd

from report.claims import judge
from report.claims import to_markdown as claims_to_markdown
from report.errors import ReportError
from report.files import write_file
from report.formatting import NOTHING, markdown_table, speedup_text, three_digits
from report.many_images.results import CSV
from report.many_images.results import read_csv as read_many_images
from report.many_images.tables import TABLES
from report.measure.run import RUN, Run, load_run
from report.measure.timings import Row
from report.page.experiments import experiment_tables, load_experiments
from report.page.headline import readme_table
from report.page.operations import Rows
from report.page.sentences import origin
from report.pages import MARKDOWN, load_pages, ratios_table

MARK = re.compile(r"(<!-- ([\w-]+)([^>]*?): made by report readme -->\n).*?(<!-- end -->)", re.DOTALL)

MANY_IMAGES = Path("many-images", CSV)
"""In the directory of a run."""

Maker = Callable[[list[str], Path], str]
"""Takes the words after the first, and where the document is."""

NAMES = ("headline", "speed", "run", "pages", "claims", "quality", "many-images")


def fill_documents(directory: Path, documents: Sequence[Path]) -> str:
    """Returns what was done. Nothing is written unless every document has marks that are known."""
    makers = makers_of(directory)
    texts = {document: filled(document, makers) for document in documents}
    for document, text in texts.items():
        write_file(document, text.encode())
    return f"filled {', '.join(makers)} from {directory}: {', '.join(path.name for path in documents)}"


def marked(directory: Path) -> list[Path]:
    """README.md, the judged claims and the pages of docs/ that have marks."""
    return [path for path in (directory / "README.md", directory / "report" / "CLAIMS.md",
                              *sorted((directory / "docs").glob("*.md")))
            if MARK.search(path.read_text(encoding="utf-8"))]


def makers_of(directory: Path) -> dict[str, Maker]:
    """By the first word of a mark. Raises ReportError where the directory holds nothing to quote."""
    many = directory / MANY_IMAGES
    makers: dict[str, Maker] = {"quality": lambda _, __: _quality()}
    if (directory / RUN).exists() or not many.exists():
        rows = Rows(load_run(directory))
        makers |= {"headline": lambda _, __: readme_table(rows.headlines()),
                   "speed": lambda cases, _: speed_table(rows, cases),
                   "claims": lambda _, __: claims_to_markdown(judge(rows, load_experiments(directory)),
                                                              origin(rows.run)),
                   "run": lambda _, folder: _run_line(rows, folder)}
    if pages := load_pages(directory):
        makers["pages"] = partial(_pages, pages)
    if many.exists():
        results = read_many_images(many)
        makers["many-images"] = lambda words, folder: _many_images(results, words, many, folder)
    return makers


def filled(document: Path, makers: dict[str, Maker]) -> str:
    """Its text with new figures."""
    try:
        text = document.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ReportError(f"{document}: cannot be read: {getattr(error, 'strerror', error)}") from None
    names = [mark[2] for mark in MARK.finditer(text)]
    unknown = [name for name in names if name not in NAMES]
    if unknown or not names:
        what = f"'{unknown[0]}' is not a mark" if unknown else "there is no mark"
        raise ReportError(f"{document}: {what}; expected '<!-- NAME: made by report readme -->' and "
                          f"its '<!-- end -->', NAME one of {', '.join(NAMES)}")

    def part(found: re.Match[str]) -> str:
        maker = makers.get(found[2])
        return f"{found[1]}{maker(found[3].split(), document.parent)}{found[4]}" if maker else found[0]
    return MARK.sub(part, text)


def speed_table(rows: Rows, cases: Sequence[str]) -> str:
    """A line for each technique on its fastest ISA and on AVX2, the fastest first, a column for each case."""
    found: dict[tuple[str, str], dict[str, Row]] = {}
    fastest: set[tuple[str, str]] = set()
    for case in cases:
        timed = rows.of(*case.split("@"))
        peers = {row.peer_name for row in timed}
        seen: set[str] = set()
        for row in sorted(timed, key=lambda row: row.time_ns):
            if row.is_reference or row.peer and row.technique not in peers:
                continue
            found.setdefault((row.technique, row.isa), {})[case] = row
            if row.technique not in seen:
                fastest.add((row.technique, row.isa))
            seen.add(row.technique)
    lines = [[f"`{technique}`", isa, *(speedup_text(own[case]) if case in own else NOTHING
                                       for case in cases)]
             for (technique, isa), own in found.items() if isa == "avx2" or (technique, isa) in fastest]
    titles = [f"`{case.replace('@', '` on `')}`" for case in cases]
    return markdown_table(["technique", "ISA", *titles], lines, frozenset(range(2, 2 + len(cases))))


def _quality() -> str:
    """The first table of the experiment, without the columns that are on the page only."""
    table = experiment_tables(load_experiments())[0]
    kept = [i for i, title in enumerate(table.header) if title not in {"Ends", "Branches", "Largest"}]
    rows = [[row[i] for i in kept] for row in table.rows]
    return markdown_table([table.header[i] for i in kept], rows, frozenset(range(1, len(kept))))


def _run_line(rows: Rows, folder: Path) -> str:
    run = rows.run
    where = os.path.relpath(run.directory, folder)
    machine = run.machine
    return (f"Run of commit {machine['commit']} on {machine['cpu']['name']} "
            f"({machine['fingerprint']}), one thread: [all timings]({where}/timings.csv).\n")


def _pages(run: Run, _: list[str], folder: Path) -> str:
    where = os.path.relpath(run.directory, folder)
    open_rows = sum(row.flags == "open" for row in run.rows)
    failed, groups = (run.facts["controls"][name] for name in ("failed", "groups"))
    return (f"{ratios_table(run.rows)}\nOne thread: [all pictures]({where}/{MARKDOWN}). "
            f"{open_rows:,} of {len(run.rows):,} results had too few quiet moments, and the controls of {failed} of "
            f"{groups} operations on pictures failed.\n")


def _many_images(results: pd.DataFrame, words: list[str], file: Path, folder: Path) -> str:
    if len(words) != 1 or words[0] not in TABLES:
        raise ReportError(f"'many-images {' '.join(words)}': expected one of {', '.join(TABLES)}")
    one = results.iloc[0]
    return (f"{TABLES[words[0]](results)}\nRun of commit {one.commit} on {one.processor} ({one.machine}), {one.cores} "
            f"cores: [all figures]({os.path.relpath(file, folder)}).\n")
