"""Tables, plots, page and printed summary of a run that is as it should be."""

from __future__ import annotations

import csv
import re
from html.parser import HTMLParser

import pytest
from conftest import OPERATION, SIZES, VARIANTS, Built, command, entries, jittered

from report.build import build
from report.findings import find
from report.loading import load_study
from report.model import is_sweep_input
from report.plot_sizes import choose_lines, plot_sizes
from report.plot_style import log_ticks, spread_out, styled
from report.summary import to_text

HEADER = ("operation,technique,isa,threads,scope,input,width,height,passes,median_ns,min_ns,"
          "ns_per_pixel,speedup_vs_reference,verified,repetitions,spread_percent,peer,"
          "speedup_low,speedup_high,speedup_from,plan_bytes,border,max_iterations")
PLOTS = (f"speedup_{OPERATION}_scene", f"sizes_{OPERATION}_end_to_end",
         f"sizes_{OPERATION}_kernel")
FILES = {f"{plot}.{ending}" for plot in PLOTS for ending in ("csv", "png", "svg")}

ADDRESS_ATTRIBUTES = ("src", "href", "xlink:href", "srcset", "data", "action", "poster")


class Addresses(HTMLParser):
    """Collects every address a page refers to."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        self.found += [value or "" for key, value in attributes if key in ADDRESS_ATTRIBUTES]


def test_csv_header_is_fixed(built: Built):
    assert built.text("timings.csv").splitlines()[0] == HEADER


def test_csv_holds_every_row_with_its_numbers(built: Built):
    rows = list(csv.DictReader(built.text("timings.csv").splitlines()))
    assert len(rows) == len(SIZES) * (1 + sum(1 + bool(kernel) for *_, kernel in VARIANTS))
    for row in rows:
        pixels = int(row["width"]) * int(row["height"])
        right = float(row["median_ns"]) / pixels
        assert float(row["ns_per_pixel"]) == pytest.approx(right, rel=1e-4)
        assert 0 < float(row["min_ns"]) <= float(row["median_ns"])
        assert row["verified"] == "1" and row["repetitions"] == "5"


def test_markdown_leaves_the_size_sweep_out_and_lists_the_fastest_first(built: Built):
    lines = built.text("timings.md").splitlines()
    assert "square" not in built.text("timings.md")
    assert "simd_bitpacked | avx512 | 2" in lines[2]
    assert len({line.count("|") for line in lines}) == 1


def test_page_is_self_contained(built: Built):
    page = built.text("index.html")
    assert len(page.encode()) < 3_000_000
    local = {"timings.csv", "timings.md", "claims.md", "headline.tex", "ladder.tex",
             "claims.tex"} | {f"plots/{name}" for name in FILES}
    for address in Addresses(page).found:
        assert address.startswith(("#", "data:")) or address in local, address
    assert not re.search(r"@import|url\((?!#)", page)


def test_page_links_lead_to_files(built: Built):
    for address in Addresses(built.text("index.html")).found:
        if not address.startswith(("#", "data:")):
            assert (built.directory / address).is_file(), address


def test_page_gives_each_identifier_once(built: Built):
    identifiers = re.findall(r'\sid="([^"]+)"', built.text("index.html"))
    assert len(identifiers) == len(set(identifiers))
    targets = re.findall(r'href="#([^"]+)"|url\(#([^)]+)\)', built.text("index.html"))
    assert {a or b for a, b in targets} <= set(identifiers)


def test_page_says_what_was_skipped_and_where_it_ran(built: Built):
    page = built.text("index.html")
    for words in ("this machine lacks avx512icl", "intel-6-143-8-1a2b3c4d", "abc1234", "GNU 12.2.0",
                  "xsimd 8.1.0", "Intel Xeon &lt;Platinum&gt;", "0123456789abcdef"):
        assert words in page


def test_page_describes_every_image(built: Built):
    page = built.text("index.html")
    assert page.count("<img") == 2 and page.count("<svg role=\"img\" aria-label=\"") == len(PLOTS)
    assert all('alt="' in tag for tag in re.findall(r"<img[^>]*>", page))


def test_plots_follow_the_dark_mode_of_the_page(built: Built):
    drawings = "".join(re.findall(r"<svg.*?</svg>", built.text("index.html"), re.DOTALL))
    assert "var(--ink)" in drawings and "var(--card)" in drawings
    assert "#1b1f24" not in drawings and "#fefefe" not in drawings


def test_text_of_users_is_escaped(run):
    name = '<b>$x^{|"&'
    for entry in run.timings["benchmarks"]:
        entry["name"] = entry["name"].replace("/scene/", f"/{name}/")
    run.rows["inputs"][0]["name"] = name
    build(run.write())
    assert "<b>" not in (run.directory / "index.html").read_text()
    assert "<b>$x^{\\|" in (run.directory / "timings.md").read_text()
    assert list((run.directory / "plots").glob("speedup_*.svg"))


def test_noisy_rows_are_flagged_and_kept(run):
    for factor, entry in enumerate(run.iterations("simd_bitpacked/avx2/1/kernel/scene"), 10):
        entry["cpu_time"] *= factor / 10
    printed = build(run.write())
    assert "1 of 30 rows spread by more than 5 %" in printed
    assert re.search(r"^ ~simd_bitpacked +avx2", printed, re.MULTILINE)
    assert (run.directory / "index.html").read_text().count('class="flag"') == 1
    assert (run.directory / "timings.md").read_text().count("(noisy)") == 1


def test_every_figure_has_its_numbers_in_a_table(built: Built):
    assert {path.name for path in (built.directory / "plots").iterdir()} == FILES
    for plot in PLOTS:
        rows = list(csv.DictReader(built.text(f"plots/{plot}.csv").splitlines()))
        assert rows and all(row["median_ns"] and row["operation"] == OPERATION for row in rows)
    assert {row["input"] for row in rows} == {"square_64", "square_1024"}


def test_nothing_temporary_is_left(built: Built):
    assert not [path for path in built.directory.rglob("*") if "tmp" in path.name]


def test_summary_fits_100_columns(built: Built, run):
    table = built.stdout.split("\nPage:")[0]
    assert max(map(len, table.splitlines())) <= 100
    for entry in run.timings["benchmarks"]:
        longer = entry["name"].replace("bitpacked", "bitpacked" * 9)
        entry["name"] = longer.replace("thin", "thin" * 40)
    assert max(map(len, to_text(load_study(run.write())).splitlines())) <= 100


def test_summary_marks_the_fastest_and_leaves_the_size_sweep_out(built: Built):
    marked = [line for line in built.stdout.splitlines() if line.startswith("* ")]
    assert re.match(r"\* simd_bitpacked +avx512 +2 ", marked[0])
    assert "square" not in built.stdout.split("\nPage:")[0]


def test_summary_ends_with_the_paths(built: Built):
    assert built.stdout.splitlines()[-2:] == [f"Page: {built.directory}/index.html",
                                              f"CSV:  {built.directory}/timings.csv"]


def test_main_sentence_names_variant_gain_and_reference(built: Built):
    assert re.search(r"Fastest: simd bitpacked \(avx512, 2 threads\) runs "
                     r"thin_naccache_shinghal on scene in 42\.\d µs end to end, "
                     r"(99|100|101)(\.\d)? times as fast as the scalar reference",
                     " ".join(built.stdout.split()))


def test_run_of_the_size_sweep_alone_is_reported(run):
    run.timings["benchmarks"] = [e for e in run.timings["benchmarks"] if "/scene/" not in e["name"]]
    assert "no variant can be named fastest" in build(run.write())
    assert not find(load_study(run.directory))


def test_each_technique_has_its_best_variant_in_the_size_plot(run):
    sweep = load_study(run.write()).sweep(OPERATION)
    lines = choose_lines(sweep, "kernel")
    assert [line[0].name.variant_label for line in lines] == [
        "reference", "bitpacked", "simd bitpacked (avx512, 2 threads)", "simd bitpacked (avx512)"]
    assert all([row.width for row in line] == [64, 1024] for line in lines)


def test_one_thread_is_not_drawn_twice_where_it_is_the_best(run):
    run.timings["benchmarks"] = [e for e in run.timings["benchmarks"]
                                 if "/avx512/2/" not in e["name"]]
    lines = choose_lines(load_study(run.write()).sweep(OPERATION), "kernel")
    assert [line[0].name.variant_label for line in lines] == [
        "reference", "bitpacked", "simd bitpacked (avx512)"]


def test_labels_of_the_size_plot_stay_within_their_panel_and_the_figure(run, monkeypatch):
    figures = []
    monkeypatch.setattr("report.plot_sizes.rendered", lambda figure, *_: figures.append(figure))
    for entry in run.timings["benchmarks"]:
        entry["name"] = entry["name"].replace("simd_bitpacked/avx512/", "simd_bitpacked/avx512icl/")
    with styled():
        plot_sizes(load_study(run.write()), OPERATION, "kernel")
    [figure] = figures
    figure.canvas.draw()
    left, right = (axes.get_tightbbox().x0 for axes in figure.axes), figure.bbox.width
    first_ends = max(text.get_window_extent().x1 for text in figure.axes[0].texts)
    last_ends = max(text.get_window_extent().x1 for text in figure.axes[1].texts)
    assert first_ends < list(left)[1] and last_ends < right


def test_partial_runs_are_marked(run):
    run.machine["options"] = {"quick": False, "filter": "simd|lut", "images": ["horse.png"],
                              "repetitions": 15, "largest_square": 4096}
    printed = " ".join(build(run.write()).split())
    words = ("only rows that match 'simd|lut', pictures horse.png instead of the scene, "
             "15 repetitions, squares up to 4096 x 4096")
    assert f"This was a partial run ({words})." in printed
    page = (run.directory / "index.html").read_text()
    assert "<strong>partial run</strong>" in page and "pictures horse.png instead" in page
    run.machine["options"] = {"quick": False, "filter": "", "images": [], "repetitions": 15,
                              "largest_square": 4096, "peers": False}
    assert "This was a partial run (no peers, 15 rep" in " ".join(build(run.write()).split())
    run.machine["options"]["peers"] = True
    assert "partial run" not in build(run.write())
    assert "full: 15 repetitions" in (run.directory / "index.html").read_text()


def test_unknown_techniques_and_instruction_sets_are_drawn(run):
    name = f"{OPERATION}/quantum/avx1024/8/kernel/scene"
    run.timings["benchmarks"] += entries(name, SIZES["scene"], jittered(5e4, name))
    build(run.write())
    assert "quantum" in (run.directory / "index.html").read_text()


def test_pictures_too_large_for_the_page_are_linked(run, monkeypatch):
    monkeypatch.setattr("report.page.PAGE_BYTES", 0)
    build(run.write())
    page = (run.directory / "index.html").read_text()
    assert "<img" not in page and "<svg" not in page
    assert 'href="pictures/scene.png"' in page and f'href="plots/{PLOTS[0]}.svg"' in page


def test_labels_are_moved_apart_as_little_as_needed():
    assert spread_out([0.5, 0.0], 0.1) == pytest.approx([0.5, 0.0])
    assert spread_out([0.5, 0.5, 0.9], 0.1) == pytest.approx([0.45, 0.55, 0.9])


def test_ticks_are_round_and_few():
    assert log_ticks(0.8, 30) == pytest.approx([1, 2, 5, 10, 20])
    assert log_ticks(0.8, 2000) == pytest.approx([1, 3, 10, 30, 100, 300, 1000])
    assert len(log_ticks(1e-3, 1e9)) <= 13


def test_squares_alone_are_the_size_sweep():
    names = ("square_64", "square_root", "scene", "my_square_64")
    assert [is_sweep_input(name) for name in names] == [True, False, False, False]
