"""The sentences of the first screen, and what a reader must be warned of."""

from __future__ import annotations

import datetime
from collections.abc import Iterable

from report.formatting import counted, duration, interval, three_digits, times, variant
from report.measure.run import Run
from report.measure.timings import END_TO_END, Row
from report.page.operations import PRINTED_RULE, Headline, Rows, peer_title, title
from report.page.table_two import PAPER_MACHINE, PAPER_RULE

NEAR_FASTEST = 1.05
"""How many times the time of the fastest variant what the library takes may need."""

MAX_LONGER = 8
"""How many times as long a run is advised to be; what is far more is not known well."""

MAX_FLAGGED = 0.05
"""Share of rows without enough quiet moments from which the page warns."""


def sentences(rows: Rows, lines: list[Headline]) -> list[str]:
    """What was measured, against whom, against the paper, and why it can be trusted; `**` marks
    figures."""
    found = [_fastest(rows, lines), _peers(rows, lines), choice_text(rows.run.rows), _paper(rows), _verified(rows.run)]
    return [sentence for sentence in found if sentence]


def warnings(run: Run) -> list[str]:
    """Why figures may be wrong; none after a good run."""
    found = []
    flagged = sum(row.flags == "open" for row in run.rows)
    controls = run.facts["controls"]
    if controls["failed"]:
        found.append(f"The controls of {controls['failed']} of {counted(controls['groups'], 'case')} failed: differences "
                     "between the rows of these cases, which are flagged, say nothing.")
    if flagged > MAX_FLAGGED * len(run.rows):
        found.append(f"{flagged} of {counted(len(run.rows), 'result')} had too few quiet moments: {_shared(run)}")
    return found


def _shared(run: Run) -> str:
    """What a run lacked, and how much longer one would need."""
    state = run.facts["state"]
    if "quiet" not in state:
        return "measure for longer, with --seconds."
    more = (f"About {state['longer']:.0f} times as long would do: --seconds N, or --resume after Ctrl-C."
            if state["longer"] <= MAX_LONGER else "Try again when the machine is quieter.")
    return f"others shared the processor for {100 * (1 - state['quiet']):.0f} % of the time. {more}"


def warning_text(run: Run) -> str:
    """The warnings as a paragraph of Markdown, or nothing."""
    return "".join(f"**{text}** " for text in warnings(run))[:-1] + "\n\n" * bool(warnings(run))


def date_of(run: Run) -> str:
    """When it was measured, such as 22 November 2026."""
    text = str(run.machine["date"]).replace("Z", "+00:00")
    date = datetime.datetime.fromisoformat(text)
    return f"{date.day} {date:%B %Y}"


def origin(run: Run) -> str:
    """Which run it was."""
    return (f"Run of commit {run.machine['commit']} on {run.machine['cpu']['name']} "
            f"({run.machine['fingerprint']}), {date_of(run)}.")


def _fastest(rows: Rows, lines: list[Headline]) -> str:
    if not lines:
        return ""
    best = lines[0].best
    speedup = ""
    if best.speedup_vs_reference is not None:
        speedup = (f": **{times(best.speedup_vs_reference)}** ({interval(best.speedup_low, best.speedup_high)}) as fast "
                   "as plain C++")
    return (f"{_capital(title(lines[0].case))} of {best.width} × {best.height} pixels takes "
            f"**{duration(best.time_ns)}** on one core{speedup}, by {variant(best)}.")


def _peers(rows: Rows, lines: list[Headline]) -> str:
    found = [(line, line.best.speedup_vs_peer) for line in lines
             if line.peer and line.best.speedup_vs_peer]
    if not found:
        return ""
    peer = peer_title(rows.run, found[0][0].best.peer_name)
    parts = [f"{line.label} **{times(ratio)}**"
             for line, ratio in found]
    return (f"With output equal in every pixel it is faster than {peer}: {', '.join(parts)}, each "
            "on one thread.")


def choice_text(rows: Iterable[Row]) -> str:
    """Whether what the library takes is the fastest, and where not; of settled rows."""
    groups: dict[tuple[str, str, str], list[Row]] = {}
    for row in rows:
        if row.threads == 1 and row.scope == END_TO_END and not (row.peer or row.is_reference or row.flags):
            groups.setdefault((row.case, row.input, row.sweep), []).append(row)
    ratios = {key: chosen.time_ns / min(row.time_ns for row in own) for key, own in groups.items() if len(own) > 1
              for chosen in own if chosen.default}
    slower = [f"{case} on {image} ({three_digits(ratio)}\N{MULTIPLICATION SIGN} its time)"
              for (case, image, _), ratio in ratios.items() if ratio > NEAR_FASTEST]
    if not ratios:
        return ""
    return (f"In **{len(ratios) - len(slower)} of {len(ratios)}** cases the variant that the library takes is within "
            f"{100 * (NEAR_FASTEST - 1):.0f} % of the fastest" + (f"; not in {', '.join(slower)}." if slower else "."))


def _paper(rows: Rows) -> str:
    line = rows.headline(PRINTED_RULE)
    if line is None or (line.best.width, line.best.height) != (510, 412):
        return ""
    seconds = line.best.time_ns / 1e9
    return (f"The paper's rule took {PAPER_RULE.seconds} s on a {PAPER_MACHINE} for an image of this "
            f"size; here it takes **{duration(line.best.time_ns)}**, "
            f"about **{float(f'{PAPER_RULE.seconds / seconds:.2g}'):,.0f}×** as fast.")


def _verified(run: Run) -> str:
    controls = run.facts["controls"]
    same, slowed = controls["same"], controls["slowed"]
    text = f"Each of the **{run.facts['verified']:,}** variants timed gave its reference's output first."
    if same and slowed:
        text += (f" Controls, medians of {controls['groups']} cases: a row against itself "
                 f"{same:.3f}, one with a delay of about a tenth {slowed:.3f}; {controls['failed']} failed.")
    return text


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
