"""The page in a browser: wide, on a phone, dark, and without scripts."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import CHROMIUM, Browser, Look, Tab
from conftest import Run
from PIL import Image, ImageStat
from test_limits import make_limits
from test_provenance import TABLE_TWO
from test_quality import make_quality

from report.build import build

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")

PHONE = Look(width=390, height=844)
LOOKS = {"desktop": Look(), "phone": PHONE, "dark": Look(dark=True),
         "dark phone": Look(390, 844, dark=True), "no scripts": Look(scripts=False)}


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run with every section."""
    directory = Run(tmp_path_factory.mktemp("page") / "run").write()
    (directory / "limits.json").write_text(json.dumps(make_limits()))
    (directory / "experiments").mkdir()
    for name, data in (("quality", make_quality()), ("table-2", TABLE_TWO)):
        (directory / f"experiments/{name}.json").write_text(json.dumps(data))
    build(directory)
    return directory / "index.html"


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    """One for all tests."""
    with Browser(tmp_path_factory.mktemp("profile")) as opened:
        yield opened


@pytest.mark.parametrize("look", LOOKS.values(), ids=LOOKS)
def test_nothing_is_complained_of_and_nothing_scrolls_sideways(browser, page, look):
    tab = Tab(browser, page, look)
    assert tab.value("innerWidth") == look.width
    assert tab.value("document.documentElement.scrollWidth") <= look.width
    assert tab.complaints() == []


def test_errors_of_a_page_are_seen(browser, tmp_path):
    (tmp_path / "bad.html").write_text("<script>console.error('a'); throw new Error('b')</script>")
    assert len(Tab(browser, tmp_path / "bad.html").complaints()) == 2


def test_every_table_can_be_sorted_by_every_column(browser, page):
    tab = Tab(browser, page)
    tables = tab.value("document.querySelectorAll('table').length")
    assert tables >= 4
    assert tab.value("document.querySelectorAll('thead th:not(:has(button))').length") == 0


def column(tab: Tab, table: str, number: int) -> list[str]:
    """The texts of a column."""
    rows = f"document.querySelector('{table}').tBodies[0].rows"
    found = tab.value(f"Array.from({rows}, row => row.cells[{number}].textContent.trim())")
    assert isinstance(found, list)
    return found


def click_on(tab: Tab, table: str, number: int) -> None:
    tab.value(f"document.querySelector('{table}').tHead.rows[0].cells[{number}]"
              ".querySelector('button').click()")


def test_numbers_are_sorted_as_numbers_and_a_second_click_turns_the_order(browser, page):
    tab = Tab(browser, page)
    for table, number in (("#timings", 7), ("#limits table", 6), ("#experiments table", 3)):
        click_on(tab, table, number)
        up = [float(text.split()[0].replace(",", "")) for text in column(tab, table, number)]
        assert up == sorted(up), table
        click_on(tab, table, number)
        down = [float(text.split()[0].replace(",", "")) for text in column(tab, table, number)]
        assert down == up[::-1] or down == sorted(up, reverse=True), table
    assert tab.complaints() == []


def test_rows_are_filtered_by_words_and_scope(browser, page):
    tab = Tab(browser, page)
    tab.value("""(() => { const form = document.getElementById('filters');
        form.elements.text.value = 'simd AVX512'; form.elements.scope.value = 'kernel';
        form.dispatchEvent(new Event('input')); })()""")
    shown = tab.value("Array.from(document.querySelectorAll('#timings tbody tr'))"
                      ".filter(row => !row.hidden).map(row => row.textContent)")
    assert shown and all("kernel" in text and "avx512" in text for text in shown)
    assert tab.value("document.getElementById('shown').textContent").startswith(f"{len(shown)} of ")


def test_figures_tell_their_numbers_to_a_pointer(browser, page):
    tab = Tab(browser, page)
    titles = tab.value("Array.from(document.querySelectorAll('#plots svg g > title'),"
                       " title => title.textContent)")
    assert any(text.startswith("simd bitpacked (avx512), kernel: ") for text in titles)
    assert any(" 64²" in text for text in titles)
    assert tab.value("document.querySelectorAll('#limits svg g > title').length") == 2


def test_without_scripts_all_rows_stand_there_and_no_dead_control_does(browser, page):
    tab = Tab(browser, page, LOOKS["no scripts"])
    assert tab.value("document.querySelectorAll('#timings tbody tr').length") == 30
    assert tab.value("getComputedStyle(document.getElementById('filters')).display") == "none"
    assert tab.value("document.querySelectorAll('button').length") == 0


def luminance(colour: str) -> float:
    parts = [int(part) / 255 for part in colour[colour.index("(") + 1:-1].split(",")[:3]]
    red, green, blue = (p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


@pytest.mark.parametrize("dark", [False, True])
def test_words_stand_out_from_their_ground(browser, page, dark):
    tab = Tab(browser, page, Look(dark=dark))
    for words, ground in (("ink", "card"), ("ink", "page"), ("muted", "card"), ("muted", "page"),
                          ("accent", "card"), ("accent", "page"), ("ink", "accent-soft"),
                          ("flag", "flag-soft")):
        tab.value(f"document.body.style.color = 'var(--{words})',"
                  f" document.body.style.backgroundColor = 'var(--{ground})'")
        levels = sorted(luminance(tab.value(f"getComputedStyle(document.body).{key}"))
                        for key in ("color", "backgroundColor"))
        assert (levels[1] + 0.05) / (levels[0] + 0.05) >= 4.5, (words, ground)


@pytest.mark.parametrize(("dark", "low", "high"), [(False, 200, 255), (True, 0, 70)])
def test_page_and_figures_are_dark_where_the_reader_wants_it(browser, page, dark, low, high):
    tab = Tab(browser, page, Look(dark=dark))
    box = tab.value("(({x, y, width, height}) => [x, y + scrollY, width, height])"
                    "(document.querySelector('#limits svg').getBoundingClientRect())")
    for clip in (None, tuple(box)):
        with Image.open(io.BytesIO(tab.screenshot(clip))) as picture:
            assert low <= ImageStat.Stat(picture.convert("L")).median[0] <= high
