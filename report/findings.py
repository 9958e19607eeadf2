"""What a run shows: the fastest variants and how far the numbers can be trusted."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from statistics import median

from report.formatting import duration, percent, scope_label, three_digits
from report.model import END_TO_END, KERNEL, NOISY_PERCENT, SCENE, Row, Study

PAPER_THINNING = "thin_naccache_shinghal"


@dataclass(frozen=True)
class Finding:
    """The reference and the fastest variants of one case on one input, and the peers in the scope of
    the best."""

    case: str
    input: str
    reference: Row
    end_to_end: Row | None
    kernel: Row | None
    peers: tuple[Row, ...] = ()

    @property
    def best(self) -> Row | None:
        """The row to quote: end to end where it was timed, since it is what a caller waits for."""
        return self.end_to_end or self.kernel


@dataclass(frozen=True)
class Noise:
    """How much the repetitions of a run disagree."""

    rows: int
    noisy_rows: int
    typical_percent: float | None


def find(study: Study) -> list[Finding]:
    """One finding for each case and each input outside the size sweep."""
    return [_find_one(study.select(case, name), case, name)
            for case in study.cases for name in study.pictures if study.select(case, name)]


def noise_of(study: Study) -> Noise:
    """Counts noisy rows; the typical spread is the median over the rows."""
    spreads = [row.spread_percent for row in study.rows if row.spread_percent is not None]
    return Noise(len(study.rows), sum(row.is_noisy for row in study.rows),
                 median(spreads) if spreads else None)


def main_sentence(findings: list[Finding]) -> str:
    """How fast the paper's thinning is now, or else, in this order, any thinning, any operation.

    A net's reference is slow arithmetic, so its speed-ups are larger and say less: nets come last.
    """
    rows = [finding.best for finding in findings if finding.best]
    rows = [row for row in rows if row.name.input == SCENE] or rows
    if not rows:
        return ("Only reference rows or the size sweep were timed, so no variant can be named "
                "fastest.")
    place = min(_place_in_headline(row) for row in rows)
    top = max((row for row in rows if _place_in_headline(row) == place),
              key=lambda row: row.speedup)
    return (f"Fastest: {top.name.variant_label} runs {top.name.case.name} on {top.name.input} in "
            f"{duration(top.median_ns)} {_scope_words(top)}, {three_digits(top.speedup)} times as "
            f"fast as the scalar reference ({duration(top.reference_ns)}){_interval_words(top)}.")


def speedup_sentence(study: Study) -> str:
    """How the speed-ups were measured."""
    rows = [row for row in study.rows if not row.name.is_reference]
    paired = [row.paired for row in rows if row.paired]
    if not paired:
        return ("Speed-ups are ratios of medians: this run has no speedups.csv, so no intervals "
                "are known.")
    doubtful = sum(ratio.is_inconclusive for ratio in paired)
    controls = "all controls passed" if not doubtful else (
        f"{doubtful} are inconclusive, as a control failed")
    return (f"Speed-ups of {len(paired)} of {len(rows)} rows were measured in pairs by "
            f"{max(ratio.processes for ratio in paired)} processes, {controls}; the others are "
            "ratios of medians.")


def noise_sentence(noise: Noise) -> str:
    """How noisy the run was."""
    if noise.typical_percent is None:
        return "Each row was timed once, so how noisy the run was is unknown."
    return (f"Noise: the typical row spreads by {percent(noise.typical_percent)}; "
            f"{noise.noisy_rows} of {noise.rows} rows spread by more than {NOISY_PERCENT:g} % "
            "and are flagged.")


def fastest(rows: Iterable[Row]) -> Row | None:
    """The row of the smallest median, if there are rows."""
    ordered = sorted(rows, key=lambda row: row.median_ns)
    return ordered[0] if ordered else None


def _find_one(rows: list[Row], case: str, input_name: str) -> Finding:
    variants = [row for row in rows if not row.name.is_reference and not row.is_peer]
    best = {scope: fastest(row for row in variants if row.name.scope == scope)
            for scope in (END_TO_END, KERNEL)}
    reference = next(row for row in rows if row.name.is_reference)
    quoted = END_TO_END if best[END_TO_END] else KERNEL
    peers = tuple(row for row in rows if row.is_peer and row.name.scope == quoted)
    return Finding(case, input_name, reference, best[END_TO_END], best[KERNEL], peers)


def _place_in_headline(row: Row) -> int:
    case = row.name.case.name
    wanted = (case == PAPER_THINNING, case.startswith("thin_"), not case.startswith("net_"))
    return wanted.index(True) if True in wanted else len(wanted)


def _interval_words(row: Row) -> str:
    if row.paired is None:
        return ""
    return f", interval {three_digits(row.paired.low)} to {three_digits(row.paired.high)}"


def _scope_words(row: Row) -> str:
    return scope_label(row.name.scope) if row.name.scope == END_TO_END else "(kernel)"
