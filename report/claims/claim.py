"""What a judged claim consists of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

TITLE = "The paper's claims, judged"
LEAD = "Figures and verdicts are computed from the data of one run and from the experiments."


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


def judged(claim: str, parts: Sequence[bool], figure: str, holds: str, otherwise: str, command: str) -> Claim:
    """With the reason why all parts hold, or else why not."""
    verdict = Verdict.of(parts)
    return Claim(claim, verdict, figure, holds if verdict is Verdict.HOLDS else otherwise, command)


def open_claim(claim: str, command: str) -> Claim:
    """One without data."""
    return Claim(claim, Verdict.OPEN, "", "There is no data for it.", command)


def to_markdown(claims: list[Claim], origin: str) -> str:
    """All claims, a section each; `origin` says of which run."""
    return "\n".join([f"# {TITLE}", "", LEAD, "", origin, "", *map(_section, claims)])


def _section(claim: Claim) -> str:
    verdict = claim.verdict.value if claim.verdict is Verdict.OPEN else f"it {claim.verdict.value}"
    figure = f"{claim.figure[0].upper()}{claim.figure[1:]}. " if claim.figure else ""
    return (f"## {claim.claim}\n\n**{verdict[0].upper()}{verdict[1:]}.** {figure}{claim.why} "
            f"Measured by `{claim.command}`.\n")
