"""What a judged claim consists of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from report.experiment_layout import Table, columns
from report.tables import markdown_line

TITLE = "The paper's claims, judged"
LEAD = ("Figures and verdicts are made from the data of this run; none is typed by hand. Intervals "
        "are 95 % or better where a row was timed six times or more, else the range of its times.")
HEADER = ("Claim", "Verdict", "Figure", "Why", "Measured by")


class Verdict(Enum):
    """What the data says."""

    HOLDS = "holds"
    PARTLY = "holds in part"
    FAILS = "does not hold"
    OPEN = "not measured in this run"

    @staticmethod
    def of(parts: Sequence[bool]) -> Verdict:
        """All, none or some of the parts of a claim are right."""
        if all(parts):
            return Verdict.HOLDS
        return Verdict.PARTLY if any(parts) else Verdict.FAILS


@dataclass(frozen=True)
class Claim:
    """A claim with what was found."""

    claim: str
    verdict: Verdict
    figure: str
    why: str
    command: str


def open_claim(claim: str, command: str) -> Claim:
    """What the run has no data for."""
    return Claim(claim, Verdict.OPEN, "", "The run holds no data for it.", command)


def to_table(claims: list[Claim]) -> Table:
    """All claims, for the page."""
    rows = tuple((c.claim, c.verdict.value, c.figure, c.why, c.command) for c in claims)
    return Table(TITLE, LEAD, columns(HEADER, []), rows, "")


def to_markdown(claims: list[Claim], origin: str) -> str:
    """All claims, a section each; `origin` says of which run."""
    lines = [f"# {TITLE}", "", LEAD, "", origin, "",
             markdown_line(["Claim", "Verdict"]), markdown_line(["---", "---"])]
    lines += [markdown_line([c.claim, c.verdict.value]) for c in claims]
    for claim in claims:
        lines += ["", f"## {claim.claim}", "", f"**Verdict: it {claim.verdict.value}.**"
                  if claim.verdict is not Verdict.OPEN else f"**Verdict: {claim.verdict.value}.**"]
        lines += ["", f"{claim.figure[0].upper()}{claim.figure[1:]}."] if claim.figure else []
        lines += ["", claim.why, "", f"Measured by `{claim.command}`."]
    return "\n".join(lines) + "\n"
