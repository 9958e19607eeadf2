"""The page in Chromium: wide, on a phone, dark, by keyboard and without scripts."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from conftest import all_rows, write_run
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from report.page.build import build_page
from tests.browser import Page, needs_chromium

pytestmark = needs_chromium

VISIBLE = ("Array.from(document.querySelectorAll('.is-chosen table.rows tbody tr'))"
           ".filter(row => !row.hidden)")
CHART = "Chart.getChart(document.querySelector('.is-chosen canvas'))"


@pytest.fixture(scope="module", name="address")
def _address(tmp_path_factory: pytest.TempPathFactory) -> str:
    directory = write_run(tmp_path_factory.mktemp("page") / "run", all_rows())
    build_page(directory)
    return (directory / "index.html").resolve().as_uri()


@pytest.fixture(scope="module", name="page")
def _page() -> Iterator[Page]:
    page = Page()
    yield page
    page.driver.quit()


def click(page: Page, selector: str) -> None:
    """Where a pointer would."""
    element = page.driver.find_element(By.CSS_SELECTOR, selector)
    page.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", element)
    element.click()


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize("width", [375, 1300])
def test_nothing_overflows_and_the_console_is_empty(page, address, width, dark):
    page.look(address, width, dark)
    page.value("document.querySelectorAll('details').forEach(one => { one.open = true })")
    assert page.value("innerWidth") == width
    assert page.value("document.documentElement.scrollWidth") <= width
    assert page.errors() == []


def test_choosing_an_operation_changes_plot_and_table_and_the_address_keeps_it(page, address):
    page.look(address)
    before = page.value(f"{CHART}.data.datasets.map(one => one.data)")
    assert page.until("document.querySelector('.is-chosen').id === 'thin_guo_hall'")
    click(page, ".list a[href='#edges_sobel']")
    assert page.value("document.querySelectorAll('.is-chosen').length") == 1
    assert page.until("document.querySelector('.is-chosen').id === 'edges_sobel'")
    assert page.value(f"{CHART}.data.datasets.map(one => one.data)") != before
    assert "opencv" in page.value(f"{VISIBLE}.map(row => row.dataset.technique)")
    assert page.driver.current_url.endswith("#edges_sobel")
    page.driver.refresh()
    assert page.until("document.querySelector('.is-chosen').id === 'edges_sobel'")
    assert page.errors() == []


def test_hovering_shows_time_interval_and_speedup(page, address):
    page.look(address + "#thin_guo_hall")
    canvas = page.driver.find_element(By.CSS_SELECTOR, ".is-chosen canvas")
    page.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
    x, y = page.value(f"(chart => {{ const index = chart.data.datasets.findIndex(one => one.label"
                      f" === 'SIMD on packed bits'); const point = chart.getDatasetMeta(index).data[0];"
                      f" return [point.x - chart.width / 2, point.y - chart.height / 2] }})({CHART})")
    ActionChains(page.driver).move_to_element_with_offset(canvas, round(x), round(y)).perform()
    assert page.until(f"{CHART}.tooltip.opacity > 0")
    tooltip = page.value(f"[{CHART}.tooltip.opacity, {CHART}.tooltip.title.join(),"
                         f" {CHART}.tooltip.body[0].lines.join('; ')]")
    assert tooltip[1] == "simd_bitpacked · avx512"
    assert tooltip[2] == "64.0 µs; up to 65.3 µs; 156× over plain C++"


@pytest.mark.parametrize(("key", "value"), [("isa", "avx2"), ("threads", "2"), ("scope", "kernel"),
                                            ("options", "border kept")])
def test_a_switch_changes_table_and_plot_alike(page, address, key, value):
    page.look(address + "#thin_guo_hall")
    click(page, f"label[for='thin_guo_hall-{key}-{value.replace(' ', '-')}']")
    rows = page.value(f"{VISIBLE}.map(row => ({{...row.dataset}}))")
    points = page.value(f"{CHART}.data.datasets.flatMap(one => one.data).length")
    assert rows and points == len(rows)
    assert all(row[key] == value for row in rows
               if row["isa"] != "native" and row["technique"] != "reference")


def test_a_table_is_searched_sorted_and_copied(page, address):
    page.look(address + "#thin_guo_hall")
    page.driver.find_element(By.CSS_SELECTOR, ".is-chosen input[type=search]").send_keys("SIMD avx")
    techniques = page.value(f"{VISIBLE}.map(row => row.dataset.technique)")
    assert set(techniques) == {"simd_bitpacked"} and len(techniques) == 2
    header = page.driver.find_element(
        By.XPATH, "//article[contains(@class, 'is-chosen')]//thead//button[text()='Time']")
    for order in (1, -1):
        header.click()
        times = page.value(f"{VISIBLE}.map(row => Number(row.dataset.ns))")
        assert times == sorted(times)[::order]
    page.driver.execute_script("navigator.clipboard.writeText = text => { window.copied = text }")
    click(page, ".is-chosen .copy")
    assert page.until("window.copied")
    lines = page.value("window.copied").splitlines()
    assert lines[0].startswith("Technique,ISA,") and len(lines) == 3


def test_switches_and_operations_are_reached_by_keyboard(page, address):
    page.look(address + "#thin_guo_hall")
    page.driver.find_element(By.ID, "thin_guo_hall-scope-end-to-end").send_keys(Keys.ARROW_RIGHT)
    assert page.value(f"{VISIBLE}.every(row => row.dataset.scope === 'kernel')")
    page.driver.find_element(By.CSS_SELECTOR, ".list a[href='#holes']").send_keys(Keys.ENTER)
    assert page.until("document.querySelector('.is-chosen').id === 'holes'")


def test_a_link_to_a_folded_part_opens_it_and_its_plots_are_drawn(page, address):
    page.look(address)
    click(page, "header a[href='#sweeps']")
    assert page.until("document.getElementById('sweeps').open")
    assert page.until("Chart.getChart(document.querySelector('#sweeps canvas'))?.data.datasets.length > 0")


def test_without_scripts_all_tables_stand_there_and_no_dead_control_does(address):
    page = Page("--blink-settings=scriptEnabled=false")
    try:
        page.driver.get(address)
        shown = [one.is_displayed() for one in page.driver.find_elements(By.CSS_SELECTOR, "table.rows")]
        assert len(shown) == 4 and all(shown)
        assert not any(one.is_displayed() for one in page.driver.find_elements(
            By.CSS_SELECTOR, "button, input, canvas"))
    finally:
        page.driver.quit()


@pytest.mark.parametrize("dark", [False, True])
def test_text_has_a_contrast_of_at_least_4_5(page, address, dark):
    page.look(address, dark=dark)
    for words, ground in (("ink", "card"), ("ink", "page"), ("muted", "card"), ("muted", "page"),
                          ("accent", "card"), ("accent", "soft"), ("ink", "soft"),
                          ("warn", "warn-soft"), ("good", "card"), ("bad", "card")):
        assert page.contrast(words, ground) >= 4.5, (words, ground)
