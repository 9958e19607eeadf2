"""Verdicts as text, JUnit, Bencher Metric Format and annotations of GitHub Actions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree import ElementTree

from report.formatting import duration, markdown_table
from report.measure.estimates import Estimate
from report.measure.benchmarks import Json
from report.regress.verdicts import Layer, RowVerdict, Times, Verdict

ORDER = [Verdict.FAIL, Verdict.INCONCLUSIVE, Verdict.SKIPPED, Verdict.PASS]


@dataclass(frozen=True)
class Outcome:
    """All that the check found."""

    instructions: Layer
    times: Layer
    counts: dict[str, int]  # instructions by row

    @property
    def layers(self) -> dict[str, Layer]:
        """By name."""
        return {"instructions": self.instructions, "times": self.times}

    @property
    def summary(self) -> str:
        """The last line."""
        return ", ".join(f"{name} {layer.verdict}" for name, layer in self.layers.items())


def to_text(outcome: Outcome, show_all: bool) -> str:
    """Rows that did not pass, or all, and the verdicts of the layers."""
    lines: list[str] = []
    for layer in outcome.layers.values():
        for row in sorted(layer.rows, key=lambda row: ORDER.index(row.verdict)):
            if show_all or row.verdict != Verdict.PASS:
                lines.append(f"{row.verdict:12} {row.name}: {about(row)}")
        lines += [layer.summary] if layer.summary else []
    return "\n".join([*lines, outcome.summary])


def about(row: RowVerdict) -> str:
    """What a verdict rests on, in one line."""
    parts = [row.reason] if row.reason else []
    if row.change:
        parts.append(f"speed {_percent(row.change.value)} ({_percent(row.change.low)} to "
                     f"{_percent(row.change.high)}, tolerated -{100 * row.limit:.1f} %)")
    if row.before and row.now:
        parts.append(_times_text(row.before, row.now))
    return "; ".join(parts) or "as before"


def to_junit(outcome: Outcome) -> bytes:
    """FAIL is a failure, SKIPPED and INCONCLUSIVE are skipped."""
    root = ElementTree.Element("testsuites", name="thinbench regress")
    for name, layer in outcome.layers.items():
        rows = layer.rows or [RowVerdict(name, layer.verdict, layer.summary)]
        found = [row.verdict for row in rows]
        failures = found.count(Verdict.FAIL)
        passed = found.count(Verdict.PASS)
        suite = ElementTree.SubElement(root, "testsuite", name=name, tests=str(len(rows)),
                                       failures=str(failures), errors="0",
                                       skipped=str(len(rows) - failures - passed))
        for row in rows:
            case = ElementTree.SubElement(suite, "testcase", classname=name, name=row.name)
            if row.verdict != Verdict.PASS:
                kind = "failure" if row.verdict == Verdict.FAIL else "skipped"
                ElementTree.SubElement(case, kind, message=f"{row.verdict}: {about(row)}")
    ElementTree.indent(root)
    text: bytes = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
    return text


def to_bencher(outcome: Outcome) -> Json:
    """Bencher Metric Format: benchmarks, their measures, and of each its value and interval."""
    found: Json = {}
    for row in outcome.times.rows:
        if row.now:
            found[row.name] = {"latency": {"value": row.now.row}}
            if row.speedup:
                found[row.name]["speedup"] = _metric(row.speedup)
    for name, number in outcome.counts.items():
        found.setdefault(name, {})["instructions"] = {"value": number}
    return found


def to_annotations(outcome: Outcome) -> str:
    """Commands of GitHub Actions: an error for each FAIL, one warning for all INCONCLUSIVE rows."""
    lines = [f"::error title={layer} FAIL::{_escaped(f'{row.name}: {about(row)}')}"
             for layer, row in _rows(outcome, Verdict.FAIL)]
    doubtful = [row for _, row in _rows(outcome, Verdict.INCONCLUSIVE)]
    if doubtful:
        lines.append(f"::warning title=INCONCLUSIVE::{len(doubtful)} rows, the first is "
                     f"{_escaped(f'{doubtful[0].name}: {about(doubtful[0])}')}")
    return "".join(f"{line}\n" for line in lines)


def to_markdown(outcome: Outcome) -> str:
    """The job's summary; empty where nothing is wrong."""
    rows = [(layer, row) for verdict in (Verdict.FAIL, Verdict.INCONCLUSIVE) for layer, row in _rows(outcome, verdict)]
    if not rows:
        return ""
    lines = [[str(row.verdict), layer, f"`{row.name}`", about(row)] for layer, row in rows]
    return f"### thinbench: {outcome.summary}\n\n" + markdown_table(["verdict", "layer", "row", ""], lines)


def _rows(outcome: Outcome, verdict: Verdict) -> Iterator[tuple[str, RowVerdict]]:
    for name, layer in outcome.layers.items():
        yield from ((name, row) for row in layer.rows if row.verdict == verdict)


def _metric(estimate: Estimate) -> Json:
    return {"value": estimate.value, "lower_value": estimate.low, "upper_value": estimate.high}


def _percent(ratio: float) -> str:
    return f"{100 * (ratio - 1):+.1f} %"


def _times_text(before: Times, now: Times) -> str:
    text = f"{duration(before.row)} before, {duration(now.row)} now"
    if before.reference and now.reference:
        text += f"; reference {duration(before.reference)} before, {duration(now.reference)} now"
    return text


def _escaped(text: str) -> str:
    return text.replace("%", "%25").replace("\n", "%0A")
