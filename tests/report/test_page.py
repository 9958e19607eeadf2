"""The page as a file: numbers, links, size, and what it says of doubtful runs."""

from __future__ import annotations

import base64
import csv
import io
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import pytest
from PIL import Image
from conftest import all_rows, build, make_facts, make_rows

from report.errors import ReportError
from report.formatting import duration, times
from report.measure.run import load_run
from report.measure.timings import to_csv
from report.page.html import chart_js
from report.page.operations import Rows


class Elements(HTMLParser):
    """Collects identifiers, references and unclosed elements."""

    VOID = {"meta", "link", "img", "input", "br"}

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.references: list[str] = []
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        if found.get("id") and "svg" not in self.open:
            self.ids.append(str(found["id"]))
        self.references += [str(found[key]) for key in ("href", "src") if found.get(key)]
        self.open += [] if tag in self.VOID else [tag]

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in self.VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag, f"</{tag}> closes something else"


def test_every_link_leads_somewhere_and_nothing_comes_from_elsewhere(built):
    page = Elements(built.text("index.html"))
    links = [one for one in page.references if not one.startswith("data:")]
    assert any(one.startswith("#") for one in links) and "timings.csv" in links
    for link in links:
        target, _, anchor = link.partition("#")
        assert "://" not in link
        assert not target or (built.directory / unquote(target)).is_file(), link
        assert not anchor or re.search(rf'id="{anchor}"', built.text("index.html")), link


def test_the_page_is_well_formed_and_identifiers_are_unique(built):
    page = Elements(built.text("index.html"))
    assert page.open == [] and len(page.ids) == len(set(page.ids))


def test_the_page_has_at_most_4_mb(built):
    assert (built.directory / "index.html").stat().st_size <= 4_000_000


def test_names_are_escaped(built):
    assert "Fake &lt;CPU&gt;" in built.text("index.html")
    assert "no <avx2>" not in built.text("index.html")


def test_page_markdown_and_terminal_have_the_figures_of_timings_csv(built):
    with (built.directory / "timings.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    found = [row for row in rows if row["operation"] == "thin_guo_hall" and row["threads"] == "1"
             and row["scope"] == "end_to_end" and row["border"] == "keep"]
    best = min((row for row in found if row["peer"] == "0"),
               key=lambda row: float(row["time_ns"]))
    figures = (duration(float(best["time_ns"])), times(float(best["speedup_vs_reference"])),
               times(float(best["speedup_vs_peer"])))
    assert figures == ("64.0 µs", "156×", "1,406×")
    for text in (built.text("index.html"), built.text("timings.md"), built.stdout):
        assert all(figure in text for figure in figures)


def test_useful_rules_come_before_the_printed_one(built):
    cases = [line.case for line in Rows(load_run(built.directory)).headlines()]
    assert cases.index("thin_guo_hall") < cases.index("thin_naccache_shinghal")


def test_a_copy_of_another_case_is_the_bound_but_has_no_speedup(built):
    line = Rows(load_run(built.directory)).headline("thin_guo_hall")
    assert line and line.copy and line.copy.time_ns == 4000
    assert line.copy.speedup_vs_reference is None


def test_a_clean_run_carries_no_flags_and_no_warning(built):
    page = built.text("index.html").split("<script>const FAMILIES")[0]
    assert 'class="warning"' not in page and 'class="flag"' not in page and "noisy" not in page


@pytest.mark.parametrize(("flags", "failed", "said"), [
    ("", 2, "The controls of 2 of 9 cases failed"), ("open", 0, "had too few quiet moments"),
    ("open", 0, "others shared the processor for 60 % of the time. About 4 times as long would do")])
def test_doubts_are_told_on_the_first_screen_and_in_the_terminal(make, flags, failed, said):
    facts = make_facts(all_rows())
    built = make([replace(row, flags=flags) for row in all_rows()], controls=facts["controls"] | {"failed": failed},
                 state=facts["state"] | {"quiet": 0.4, "longer": 4.0})
    assert 'class="warning"' in built.text("index.html").split("<table")[0] and said in built.stdout


@pytest.mark.parametrize(("rows", "name"), [
    (make_rows("euler_number_4"), "Euler number"),
    ([replace(row, scope="kernel") for row in make_rows("thin_mb2")[1:]], "Page: ")],
    ids=["one operation", "no end-to-end rows"])
def test_a_run_of_few_rows_has_a_page(make, rows, name):
    built = make(rows)
    assert name in built.stdout and f'id="{rows[0].operation}"' in built.text("index.html")


def png(pixels):
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, "PNG")
    return stream.getvalue()


def test_large_images_are_scaled_down(make):
    noise = np.random.RandomState(1).randint(0, 256, (900, 3000), np.uint8)
    page = make(files={"pictures/scene_grey.png": png(noise)}).text("index.html")
    found = re.search(r'src="data:image/png;base64,([^"]*)" alt="the picture, scene, scaled down"', page)
    assert found
    with Image.open(io.BytesIO(base64.b64decode(found[1]))) as image:
        assert image.width > 300 and round(image.width / image.height, 1) == 3.3
    assert len(page) < 2_000_000


def test_parameter_sweeps_are_plotted_useful_rules_first(make):
    rows = [replace(row, sweep="size") for row in all_rows()]
    part = make(files={"sweeps/timings.csv": to_csv(rows).encode()}).text("index.html").split('id="sweeps"')[1]
    assert "side of the square, pixels" in part
    assert part.index("Guo-Hall thinning") < part.index("thinning by the paper")


def test_the_same_run_gives_the_same_bytes(built, capsys):
    files = [path for path in built.directory.iterdir() if path.is_file()]
    before = {path: path.read_bytes() for path in files}
    build(built.directory, capsys)
    assert before == {path: path.read_bytes() for path in files}


def test_a_missing_library_is_named_with_its_package(tmp_path):
    with pytest.raises(ReportError, match="install the package libjs-chart.js"):
        chart_js(Path(tmp_path / "chart.min.js"))
