"""index.html: one file that needs no other."""

from __future__ import annotations

import re
from pathlib import Path

from jinja2 import Environment
from markupsafe import Markup, escape

from report.claims import Claim
from report.errors import ReportError
from report.formatting import counted, duration, flag_text, interval, templates, times, variant
from report.page.charts import chart_groups
from report.page.families import FAMILIES
from report.page.operations import Headline, Rows, peer_title
from report.page.pictures import Pictures
from report.page.provenance import provenance, skipped
from report.page.sections import IMPLIED, sections
from report.page.sentences import date_of, sentences, warnings
from report.page.tables import Table
from report.sweeps.series import load_sweep_rows

CHART_JS = Path("/usr/share/javascript/chart.js/chart.min.js")
NO_BREAK = "\N{NO-BREAK SPACE}"
FILES = ("timings.csv", "timings.md", "claims.md", "overview.svg")


def to_html(rows: Rows, lines: list[Headline], svg: str, claims: list[Claim],
            experiments: list[Table]) -> str:
    """The page; `svg` is the overview."""
    run = rows.run
    pictures = Pictures(run.directory, rows)
    sweeps = load_sweep_rows(run.directory)
    return _environment().get_template("page.html.j2").render(
        run=run, date=date_of(run), lines=lines, input=rows.input, claims=claims, files=FILES,
        overview=Markup(svg), sentences=[*map(_with_figures, sentences(rows, lines))],
        warnings=warnings(run), peers=_peers(rows, lines), pictures=pictures.first(),
        sections=sections(rows, pictures),
        charts=chart_groups(rows, [*sweeps, *run.rows]), experiments=experiments,
        facts=provenance(run), skipped=skipped(run), families=[vars(one) for one in FAMILIES],
        implied=IMPLIED, chart_js=Markup(chart_js()))


def chart_js(path: Path = CHART_JS) -> str:
    """The library, as the distribution packages it."""
    try:
        text = path.read_text(encoding="utf-8")
    except OSError:
        raise ReportError(f"{path} is missing; install the package libjs-chart.js") from None
    return re.sub(r"^//# sourceMappingURL=.*$", "", text.replace("</script", r"<\/script"),
                  flags=re.MULTILINE)


def _environment() -> Environment:
    environment = templates(Path(__file__).parent)
    environment.filters |= {"duration": duration, "times": times, "variant": variant,
                            "flag": flag_text}
    environment.globals |= {"interval": interval, "counted": counted}
    return environment


def _with_figures(sentence: str) -> Markup:
    """Numbers stay on one line with their units."""
    text = str(escape(sentence)).replace(" %", f"{NO_BREAK}%")
    return Markup(re.sub(r"\*\*(.+?)\*\*", lambda found: "<strong>" + found[1].replace(
        " ", NO_BREAK) + "</strong>", text))


def _peers(rows: Rows, lines: list[Headline]) -> str:
    """The heading of the column of peers."""
    names = {peer_title(rows.run, line.peer.technique) for line in lines if line.peer}
    return " or ".join(sorted(names)) or "Peer of equal output"
