"""The sweeps of a run as a section: files, plots and tables."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from report.errors import ReportError
from report.experiment_layout import Table, table_block
from report.plot_style import Plot, styled
from report.sweeps.journal import load_journals
from report.sweeps.model import REFERENCE, Journal
from report.sweeps.plot_curves import plot_depths, plot_enlargements, plot_sizes, plot_threads
from report.sweeps.plot_density import plot_density
from report.sweeps.plot_levels import plot_levels
from report.sweeps.tables import compiler_table, levels_table, to_csv

TITLE = "Sweeps"
CSV, MARKDOWN = "sweeps.csv", "sweeps.md"


@dataclass(frozen=True)
class Section:
    """All that the page and the files show of the sweeps."""

    sentence: str
    plots: tuple[Plot, ...]
    tables: tuple[Table, ...]
    csv: str

    @property
    def outputs(self) -> dict[str, bytes]:
        """The files of the section by name; plots are not among them."""
        return {CSV: self.csv.encode(), MARKDOWN: self._markdown().encode()}

    def _markdown(self) -> str:
        figures = [f"![{plot.alt}](plots/{plot.stem}.svg)\n\n{plot.caption}\n"
                   for plot in self.plots]
        return "\n".join([f"# {TITLE}\n", f"{self.sentence}\n", *figures,
                          *map(table_block, self.tables)])


def load_section(directory: Path, fingerprint: str | None = None) -> Section | None:
    """None for runs without sweeps. `fingerprint` is that of the study in the same folder."""
    main, builds = load_journals(directory)
    journals = ([main] if main else []) + builds
    if not any(journal.points for journal in journals):
        return None
    if main and fingerprint and main.machine.fingerprint != fingerprint:
        raise ReportError(f"{directory / main.name}: fingerprint is {main.machine.fingerprint}; it "
                          f"must be {fingerprint}, as of the other files of the run")
    with styled():
        plots = _plots(main) if main else []
    tables = (levels_table(main.of("isa"), main.machine.isa_available) if main else None,
              compiler_table(builds))
    return Section(_sentence([main] if main else builds), tuple(plots),
                   tuple(table for table in tables if table), to_csv(journals))


def _plots(journal: Journal) -> list[Plot]:
    caches = journal.machine.caches
    found = (plot_density(journal.of("density")), plot_sizes(journal.of("size"), caches),
             plot_threads(journal.of("threads")), plot_depths(journal.of("depth")), plot_enlargements(journal.of("enlarged")),
             plot_levels(journal.of("isa"), journal.machine.isa_available))
    return [plot for plot in found if plot]


def _sentence(journals: list[Journal]) -> str:
    """Of what was measured and how; journals of several builds have the same points."""
    journal = journals[0]
    by_reference = sum(point.proved_against == REFERENCE for point in journal.points)
    others = len(journal.points) - by_reference
    compilers = " and by ".join(each.compiler for each in journals)
    is_partial = any(each.is_partial for each in journals)
    partly = (f" The run is not complete: {len(journal.points)} of {journal.planned} points were "
              "reached, not all in every round." if is_partial else "")
    proofs = (f" {by_reference} points were proved against their references, {others} against "
              "another row, as the reference would take long; sweeps.csv says which."
              if others else " Every point was proved against its reference.")
    return (f"{len(journal.points)} points{' of the quick plan' if journal.is_quick else ''}, end "
            f"to end, each measured once in each of {journal.rounds} rounds in random order, at "
            f"commit {journal.machine.commit} built by {compilers}. Values are medians over "
            "the rounds; bands and bars reach from the 2nd to the 8th of 9 ordered samples, or to "
            "the outermost of less than 6. Times are processor time on one thread, and wall time "
            f"where threads are compared.{partly}{proofs}")
