"""Tables as LaTeX: plain tabular that needs no package, to be taken in with \\input."""

from __future__ import annotations

from report.claims import Claim
from report.experiment_layout import Column, Table, columns
from report.model import Study
from report.short_tables import SHORT_TABLES
from report.table_two import TITLE as TABLE_TWO

SYMBOLS = {"\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "%": r"\%", "_": r"\_", "&": r"\&",
           "#": r"\#", "$": r"\$", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
           "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}", '"': "''",
           "[": "{[}", "*": "{*}", "µ": r"\textmu{}", "×": r"$\times$", "²": r"\textsuperscript{2}",
           "→": r"$\rightarrow$", "\N{EN DASH}": "--", "\N{NO-BREAK SPACE}": "~", "\n": " "}
"""A line must not begin with [ or *, which the end of the line before would take as its own."""

TRANSLATION: dict[int, str] = {ord(symbol): text for symbol, text in SYMBOLS.items()}

CLAIMS_LAYOUT = r"p{0.40\linewidth}p{0.16\linewidth}p{0.36\linewidth}"


def latex_tables(study: Study, tables: list[Table], claims: list[Claim]) -> dict[str, str]:
    """By file name: the short tables, Table 2 and the claims; those without rows are left out."""
    short = {name: make(study) for name, make in SHORT_TABLES.items()}
    found = {name: (table.header, table.rows, "") for name, table in short.items()}
    found |= {"table_two": (table.header, table.rows, "")
              for table in tables if table.title == TABLE_TWO}
    found["claims"] = (columns(["Claim", "Verdict", "Figure"], []),
                       tuple((c.claim, c.verdict.value, c.figure) for c in claims), CLAIMS_LAYOUT)
    machine = study.machine
    origin = f"Run of commit {machine.commit} on {machine.cpu_name} ({machine.fingerprint})."
    return {f"{name}.tex": f"% {' '.join(origin.split())}\n" + tabular(header, rows, layout)
            for name, (header, rows, layout) in found.items() if rows}


def tabular(header: tuple[Column, ...], rows: tuple[tuple[str, ...], ...], layout: str = "") -> str:
    """The environment; `layout` takes the place of left and right columns."""
    layout = layout or "".join("r" if column.is_number else "l" for column in header)
    lines = [rf"\begin{{tabular}}{{{layout}}}", r"\hline",
             _line([column.label for column in header]), r"\hline", *map(_line, rows), r"\hline",
             r"\end{tabular}"]
    return "\n".join(lines) + "\n"


def escaped(text: str) -> str:
    """Text as LaTeX prints it; what stands between `back quotes` is set like a typewriter's."""
    parts = text.translate(TRANSLATION).split("`")
    if len(parts) % 2 == 0:  # one quote is left over
        parts[-2:] = [r"\textasciigrave{}".join(parts[-2:])]
    return "".join(rf"\texttt{{{part}}}" if place % 2 else part
                   for place, part in enumerate(parts))


def _line(cells: tuple[str, ...] | list[str]) -> str:
    return " & ".join(map(escaped, cells)) + r" \\"
