"""The paper's claims, judged by what a run measured."""

from report.claims.claim import TITLE, Claim, Verdict, to_markdown
from report.claims.judge import judge

__all__ = ["TITLE", "Claim", "Verdict", "judge", "to_markdown"]
