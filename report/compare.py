"""`./study compare`: one page and one table out of runs of different machines or commits."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from report.errors import ReportError
from report.files import check_directory, write_files
from report.formatting import counted, markdown_table, templates
from report.measure.run import Run, load_run
from report.measure.timings import END_TO_END, Row

PAGE, TABLE, MARKDOWN = "comparison.html", "comparison.csv", "comparison.md"

EPILOG = """Runs are compared with the first one: ratios of times, and of speed-ups over the scalar
reference of the same run. Inputs that are not equal pixel by pixel are not compared.

examples:
  ./study compare results/*/2026-*
  ./study compare before after --out /tmp/comparison

Exit status: 0 done, 1 a directory holds no run or nothing can be compared, 2 wrong usage."""

COLUMNS = ("run", "machine", "commit", "time_ns", "high_ns", "speedup_vs_reference", "speedup_low", "speedup_high", "flags")
"""Those of timings.csv in the table."""

Key = tuple[str, str]
"""Name of a row and of its parameter sweep."""


def add_compare_command(parser: argparse.ArgumentParser) -> None:
    """Its options."""
    parser.add_argument("runs", metavar="DIR", type=Path, nargs="+",
                        help="directory of a run; two or more")
    parser.add_argument("--out", metavar="DIR", type=Path, default=Path("comparison"),
                        help="where page and tables go; default ./comparison")


def run_compare(parser: argparse.ArgumentParser, options: argparse.Namespace) -> str:
    """Returns the summary to print."""
    if len(options.runs) < 2:
        parser.error(f"expected two runs or more, got {options.runs[0]} alone")
    check_directory(options.out)
    return compare_runs([load_run(directory) for directory in options.runs], options.out)


def compare_runs(runs: Sequence[Run], out: Path) -> str:
    """Writes the page and both tables."""
    comparison = Comparison(runs)
    page = templates(Path(__file__).parent).get_template("compare.html.j2").render(comparison=comparison)
    write_files(out, {PAGE: page.encode(), TABLE: comparison.csv().encode(),
                      MARKDOWN: comparison.markdown().encode()})
    return (f"{len(comparison.lines)} rows of {len(runs)} runs; {out} holds {PAGE}, {TABLE} and "
            f"{MARKDOWN}" + "".join(f"\n{remark}" for remark in comparison.remarks))


@dataclass(frozen=True)
class Line:
    """Rows that stand beside each other, one for each run; None where a run lacks it."""

    name: str
    sweep: str
    rows: tuple[Row | None, ...]
    clocks: tuple[float, ...]
    """Of each run over that of the first, or 1."""

    @property
    def title(self) -> str:
        """With the sweep."""
        return f"{self.name} (sweep {self.sweep})" if self.sweep else self.name

    def time_ratio(self, index: int) -> float | None:
        """How many times as fast as in the first run; in cycles where both ran on the same processor, whose clock
        moves."""
        ratio = self._ratio(index, lambda row: 1 / row.time_ns)
        return ratio * self.clocks[index] if ratio else None

    def speedup_ratio(self, index: int) -> float | None:
        """The same of speed-ups over the reference."""
        return self._ratio(index, lambda row: row.speedup_vs_reference)

    def _ratio(self, index: int, value: Callable[[Row], float | None]) -> float | None:
        first, other = self.rows[0], self.rows[index]
        if first is None or other is None:
            return None
        above, below = value(other), value(first)
        return above / below if above and below else None


class Comparison:
    """What the page and the tables show."""

    def __init__(self, runs: Sequence[Run]) -> None:
        _check_different(runs)
        self.runs = runs
        self.labels = [chr(ord("A") + number) if number < 26 else f"run {number + 1}"
                       for number in range(len(runs))]
        self.remarks: list[str] = []
        rows = [self._comparable(run, label) for run, label in zip(runs, self.labels)]
        clocks = tuple(_clock(runs[0], run) for run in runs)
        self.lines = _lines([{(row.name, row.sweep): row for row in own} for own in rows], clocks)
        if not self.lines:
            raise ReportError("the runs have no row in common; was another image or filter "
                              "measured?" + "".join(f" {remark}" for remark in self.remarks))
        self.best = _lines([_best(own) for own in rows], clocks)
        self.differences = list(_differences([_facts(run) for run in runs]))
        self.remarks += list(_only_in_one(rows, self.labels))
        if any(clock != 1 for clock in clocks):
            self.remarks.append("ratios are of clock cycles where processors are of one kind, whose clock moves: "
                                "they may differ from those of the times shown")

    def _comparable(self, run: Run, label: str) -> list[Row]:
        """Without rows of inputs that are another image in the first run."""
        first = _pixels(self.runs[0])
        others = {name for name, pixels in _pixels(run).items()
                  if name in first and pixels != first[name]}
        self.remarks += [f"{label}: input '{name}' has other pixels than in A, not compared"
                         for name in sorted(others)]
        return [row for row in run.rows if row.input not in others]

    def csv(self) -> str:
        """A line for each row and run; the row's own columns as in timings.csv."""
        cells = [{"row": line.name, "sweep": line.sweep, **{name: getattr(row, name) for name in COLUMNS},
                  "times_as_fast": line.time_ratio(index), "speedup_ratio": line.speedup_ratio(index)}
                 for line in self.lines for index, row in enumerate(line.rows) if row]
        return str(pd.DataFrame(cells).to_csv(index=False, float_format="%.4g", lineterminator="\n"))

    def markdown(self) -> str:
        """Runs, differences, and the fastest row of each case and input."""
        parts = ["# Comparison of runs\n",
                 markdown_table(["", "run", "processor", "commit", "date"], self.heading())]
        parts += [f"- {remark}" for remark in self.remarks] + [""] * bool(self.remarks)
        parts += ["## What differs\n", markdown_table(["", *self.labels], self.differences),
                  "## Fastest on one thread, end to end\n", markdown_table(self.columns(), self.cells())]
        return "\n".join(parts)

    def heading(self) -> list[list[str]]:
        """A line for each run."""
        return [[label, run.facts["run"], run.machine["cpu"]["name"], run.machine["commit"],
                 run.machine["date"]] for run, label in zip(self.runs, self.labels)]

    def columns(self) -> list[str]:
        """Of cells()."""
        each = [f"{label}: {what}" for label in self.labels
                for what in ("technique", "µs", "× reference")]
        return ["case and input", *self._ratio_columns(), *each]

    def cells(self) -> list[list[str]]:
        """The fastest rows."""
        return [[line.title, *self._ratios(line),
                 *(cell for row in line.rows for cell in _row_cells(row))] for line in self.best]

    def all_columns(self) -> list[str]:
        """Of all_cells()."""
        each = [f"{label}: {what}" for what in ("µs", "× reference") for label in self.labels]
        return ["row", *self._ratio_columns(), *each]

    def all_cells(self) -> list[list[str]]:
        """All rows that the first run and another one have."""
        found = []
        for line in self.lines:
            cells = [_row_cells(row) for row in line.rows]
            found.append([line.title, *self._ratios(line), *(cell[1] for cell in cells),
                          *(cell[2] for cell in cells)])
        return found

    def _ratio_columns(self) -> list[str]:
        return [f"{label}: times as fast as A" for label in self.labels[1:]]

    def _ratios(self, line: Line) -> list[str]:
        return [_number(line.time_ratio(index)) for index in range(1, len(self.runs))]


def _check_different(runs: Sequence[Run]) -> None:
    seen: dict[str, Path] = {}
    for run in runs:
        identity = f"{run.facts['run']} {run.machine['date']}"
        if identity in seen:
            raise ReportError(f"{run.directory} and {seen[identity]} hold the same run; expected "
                              "different runs")
        seen[identity] = run.directory


def _pixels(run: Run) -> dict[str, tuple[str, str]]:
    return {item["name"]: (item["hash"], item["grey_hash"]) for item in run.facts["inputs"]}


def _clock(first: Run, run: Run) -> float:
    """The cycle of a run over that of the first one, where the processors are of the same kind."""
    kinds = [[one.machine["cpu"].get(key) for key in ("vendor", "family", "model", "stepping")] for one in (first, run)]
    return float(run.facts["state"]["cycle_ns"] / first.facts["state"]["cycle_ns"]) if kinds[0] == kinds[1] else 1.0


SHOWN = 3
"""Names in a remark."""


def _only_in_one(runs: Sequence[Sequence[Row]], labels: Sequence[str]) -> Iterator[str]:
    """Rows that only one run has, which are compared with nothing."""
    names = [{f"{row.name}{f' (sweep {row.sweep})' if row.sweep else ''}": None for row in rows} for rows in runs]
    for label, own in zip(labels, names):
        alone = [name for name in own if sum(name in other for other in names) == 1]
        if alone:
            more = f" and {len(alone) - SHOWN} more" if len(alone) > SHOWN else ""
            yield f"only {label} has {counted(len(alone), 'row')}: {', '.join(alone[:SHOWN])}{more}"


def _lines(runs: Sequence[dict[Key, Row]], clocks: tuple[float, ...]) -> list[Line]:
    """What the first run and at least one other have, in the order of the first."""
    lines = [Line(*key, tuple(rows.get(key) for rows in runs), clocks) for key in runs[0]]
    return [line for line in lines if any(line.rows[1:])]


def _best(rows: Sequence[Row]) -> dict[Key, Row]:
    """The project's fastest row on one thread, end to end, of each case and input."""
    best: dict[Key, Row] = {}
    for row in rows:
        if row.peer or row.scope != END_TO_END or row.threads != 1:
            continue
        key = (f"{row.case} / {row.input}", row.sweep)
        if key not in best or row.time_ns < best[key].time_ns:
            best[key] = row
    return best


def _facts(run: Run) -> dict[str, Any]:
    """What may explain a difference, by its path."""
    machine = {name: value for name, value in run.machine.items()
               if name not in ("schema", "options")}
    facts = {"machine": machine, "options": run.facts["options"], "state": run.facts["state"],
             "controls": run.facts["controls"]}
    return dict(_flattened("", facts))


def _flattened(prefix: str, value: Any) -> Iterator[tuple[str, Any]]:
    if isinstance(value, dict):
        for name, item in value.items():
            yield from _flattened(f"{prefix}.{name}" if prefix else name, item)
    else:
        yield prefix, value


def _differences(runs: Sequence[dict[str, Any]]) -> Iterator[list[str]]:
    """Facts that are not equal everywhere; of lists what not all of them have."""
    for name in dict.fromkeys(name for facts in runs for name in facts):
        values = [facts.get(name) for facts in runs]
        if all(value == values[0] for value in values):
            continue
        yield [name, *(_own_items(value, values) for value in values)]


def _own_items(value: Any, values: Sequence[Any]) -> str:
    if not isinstance(value, list):
        return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)
    shared = [item for item in value
              if all(isinstance(other, list) and item in other for other in values)]
    own = [_item_text(item) for item in value if item not in shared]
    return ", ".join(own) or "nothing more"


def _item_text(item: Any) -> str:
    return " ".join(map(str, item.values())) if isinstance(item, dict) else str(item)


def _row_cells(row: Row | None) -> tuple[str, str, str]:
    """Technique, time and speed-up."""
    if row is None:
        return "", "", ""
    flag = " !" if row.flags else ""
    return (f"{row.technique} {row.isa}", f"{row.time_ns / 1000:.4g}{flag}",
            _number(row.speedup_vs_reference))


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.4g}"
