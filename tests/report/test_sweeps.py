"""Sweeps: journals that are read or refused, and what is drawn of them."""

from __future__ import annotations

import json
import lzma
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from conftest import MACHINE, command

from report.build import build, build_sweeps
from report.errors import ReportError
from report.sweeps.journal import load_journal
from report.sweeps.model import Journal
from report.sweeps.plot_density import STEPS, cell_text, step_of
from report.sweeps.section import load_section

ROUNDS = 9
Line = dict[str, Any]


def sample(sweep: str, x: float, y: float | None, nanoseconds: float, **changed: Any) -> Line:
    """One sample of 10 calls on 100 pixels, so that a pixel takes `nanoseconds`."""
    line = {"kind": "sample", "sweep": sweep, "x": x, "y": y, "operation": "thin_guo_hall",
            "technique": "simd_bitpacked", "isa": "avx512", "threads": 1, "pixels": 100,
            "proved_against": "reference", "clock": "thread_cpu", "round": 0, "calls": 10,
            "ns": 1000 * nanoseconds}
    return line | changed


def rounds(sweep: str, x: float, y: float | None, nanoseconds: float, **changed: Any) -> list[Line]:
    """Nine samples round a time: the 2nd and the 8th are 3 % away."""
    return [sample(sweep, x, y, nanoseconds * (1 + (number - 4) / 100), round=number, **changed)
            for number in range(ROUNDS)]


def all_sweeps() -> list[Line]:
    """A few points of every sweep."""
    lines: list[Line] = []
    for x in (0, 50, 100):
        for y in (1, 16):
            lines += rounds("density", x, y, 0.1 + x * y / 100)
    for side in (32, 33, 512, 8192):
        lines += rounds("size", side, None, 2.0)
        lines += rounds("size", side, None, 8.0, technique="bitpacked", isa="baseline",
                        proved_against="simd_bitpacked/avx512")
    for threads in (1, 2, 4):
        lines += rounds("threads", threads, 210120, 2.0 / threads, threads=threads, clock="wall")
    for depth in (8, 16):
        lines += rounds("depth", depth, None, depth / 8)
    for level, isa in enumerate(("baseline", "sse4.2", "avx2", "avx512")):
        lines += rounds("isa", level, None, 4.0 - level, isa=isa)
    return lines


def header(lines: list[Line], **changed: Any) -> Line:
    """The first line of a journal of these samples."""
    places = {json.dumps([line[key] for key in ("sweep", "x", "y", "technique", "isa", "threads")])
              for line in lines}
    machine = MACHINE | {"options": {"only": [], "filter": "", "rounds": ROUNDS, "quick": False,
                                     "seed": 1}}
    return {"kind": "header", "schema": 1, "machine": machine, "points": len(places),
            "definition": "0"} | changed


def text_of(lines: list[Line], first: Line | None = None) -> str:
    """A journal as it stands in a file."""
    return "".join(json.dumps(line) + "\n" for line in [first or header(lines), *lines])


@pytest.fixture
def written(tmp_path: Path) -> Callable[..., Path]:
    """Writes a journal and returns its folder."""

    def write(text: str | None = None, name: str = "sweeps.jsonl") -> Path:
        (tmp_path / name).write_text(text_of(all_sweeps()) if text is None else text)
        return tmp_path

    return write


def journal_of(folder: Path) -> Journal:
    """The main journal."""
    return load_journal(folder / "sweeps.jsonl")


def refusal(folder: Path) -> str:
    """Why a folder is refused, in one line; nothing is written then."""
    before = set(folder.rglob("*"))
    with pytest.raises(ReportError) as error:
        build_sweeps(folder)
    assert set(folder.rglob("*")) == before
    assert "\n" not in str(error.value)
    return str(error.value)


def test_values_are_medians_a_pixel_between_the_second_and_the_eighth_sample(written):
    point, = [p for p in journal_of(written()).of("depth") if p.place.x == 16]
    assert point.median == pytest.approx(2.0)
    assert point.bounds == pytest.approx((2.0 * 0.97, 2.0 * 1.03))


def test_csv_has_a_line_a_point_and_says_what_proved_it(written):
    folder = written()
    build_sweeps(folder)
    head, *lines = (folder / "sweeps.csv").read_text().splitlines()
    assert head.startswith("sweep,x,y,operation,technique,isa,threads,pixels,ns_per_pixel,")
    assert len(lines) == journal_of(folder).planned
    assert ("depth,16,,thin_guo_hall,simd_bitpacked,avx512,1,100,2,1.94,2.06,9,"
            "thread_cpu,reference,GNU 12.2.0,background,") in lines
    assert sum(",simd_bitpacked/avx512,GNU 12.2.0," in line for line in lines) == 4


def texts_of(svg: bytes) -> list[str]:
    """All words of a drawing."""
    return [element.text or "" for element in ElementTree.fromstring(svg).iter()
            if element.tag.endswith("}text")]


def plot_named(folder: Path, stem: str):
    """One of the figures of a folder."""
    section = load_section(folder)
    return next(plot for plot in section.plots if plot.stem == stem)


def test_heat_map_shows_the_value_of_every_cell(written):
    plot = plot_named(written(), "sweep_density")
    assert "<title>thin_guo_hall, simd_bitpacked, avx512: 16.1 ns per pixel (15.6" in plot.svg.decode()
    assert "density,100,16,thin_guo_hall,simd_bitpacked,avx512,1,100,16.1," in plot.csv
    words = texts_of(plot.svg)
    for value in ("0.10", "0.60", "1.10", "8.10", "16.1"):
        assert value in words
    assert words.count("0.10") == 2, "density 0 with both granularities"


def test_colours_of_a_heat_map_are_steps_of_equal_ratios():
    assert [step_of(value, 1, 256) for value in (1, 1.9, 2.1, 255, 256)] == [
        0, 0, 1, len(STEPS) - 1, len(STEPS) - 1]
    assert {step_of(value, 1, 1.05) for value in (1, 1.02, 1.05)} == {0}, "noise is one colour"
    assert [cell_text(value) for value in (0.0437, 0.111, 9.99, 10.31)] == [
        "0.044", "0.11", "9.99", "10.3"]


def test_caches_are_marked_where_sizes_reach_them(written):
    words = texts_of(plot_named(written(), "sweep_size").svg)
    assert "L1 48 KiB" in words and "L2 2 MiB" in words


def test_threads_are_shown_as_speed_ups_over_one(written):
    plot = plot_named(written(), "sweep_threads")
    assert "0.21 million pixels" in texts_of(plot.svg)
    only_one = [line for line in all_sweeps() if line["sweep"] != "threads" or line["x"] == 1]
    stems = [plot.stem for plot in load_section(written(text_of(only_one))).plots]
    assert "sweep_threads" not in stems and "sweep_density" in stems


def test_plots_of_the_same_samples_are_the_same_bytes(written):
    folder = written()
    one, other = load_section(folder), load_section(folder)
    assert [plot.svg for plot in one.plots] == [plot.svg for plot in other.plots]
    assert [plot.png for plot in one.plots] == [plot.png for plot in other.plots]
    assert len(one.plots) == 5 and one.csv == other.csv


def test_packed_journal_is_read_like_a_plain_one(written):
    folder = written()
    plain = load_section(folder)
    (folder / "sweeps.jsonl").unlink()
    (folder / "sweeps.jsonl.xz").write_bytes(lzma.compress(text_of(all_sweeps()).encode()))
    assert load_section(folder).csv == plain.csv


def test_partial_journal_draws_what_is_there_and_says_so(written):
    lines = all_sweeps()
    folder = written(text_of(lines[:40], header(lines)))
    build_sweeps(folder)
    text = (folder / "sweeps.md").read_text()
    assert "The run is not complete: 5 of 23 points were reached" in text
    assert (folder / "plots" / "sweep_density.svg").exists()
    assert not (folder / "plots" / "sweep_depth.svg").exists()


def test_whole_journal_is_not_called_partial_and_counts_its_proofs(written):
    text = load_section(written()).sentence
    assert "not complete" not in text
    assert "19 points were proved against their references, 4 against another row" in text


def test_journal_without_samples_is_no_section(written):
    folder = written(text_of([], header(all_sweeps())))
    assert load_section(folder) is None
    assert "holds no samples of sweeps" in refusal(folder)


def test_journals_that_cannot_be_trusted_are_refused(written):
    lines = all_sweeps()
    whole = text_of(lines)
    assert "schema is 2; it must be 1" in refusal(written(text_of(lines, header(lines, schema=2))))
    assert "its last line is truncated; thinbench_sweeps --resume completes it" in refusal(
        written(whole[:-20]))
    assert "line 2: not JSON" in refusal(written(text_of([]) .replace("}\n", "}\nnonsense\n")))
    assert "must be 'header'" in refusal(written(whole.split("\n", 1)[1]))
    assert "round 0 of thin_guo_hall at x 0 is there twice" in refusal(
        written(text_of([*lines, lines[0]])))
    assert "sweep is 'colour'; it must be one of density, size" in refusal(
        written(text_of([lines[0] | {"sweep": "colour"}])))
    assert "ns is 0; it must be a number above zero" in refusal(
        written(text_of([lines[0] | {"ns": 0}])))
    assert "field 'proved_against' is missing" in refusal(
        written(text_of([lines[0] | {"proved_against": None}])))


def of_clang(lines: list[Line], **changed: Any) -> str:
    """The journal of a build by Clang, which takes 5 % longer."""
    slower = [line | {"ns": 1.05 * line["ns"]} for line in lines]
    first = header(lines)
    clang = MACHINE["compiler"] | {"id": "Clang", "version": "14.0.6"}
    first["machine"] = first["machine"] | {"compiler": clang, "fingerprint": "another"} | changed
    return text_of(slower, first)


def test_builds_are_compared_row_by_row(written):
    lines = [line for line in all_sweeps() if line["sweep"] == "isa"]
    written(text_of(lines), "sweeps-gnu.jsonl")
    folder = written(of_clang(lines), "sweeps-clang.jsonl")
    build_sweeps(folder)
    text = (folder / "sweeps.md").read_text()
    assert "GNU 12.2.0, µs | Clang 14.0.6, µs" in text
    assert ("| thin_guo_hall | simd_bitpacked | avx512 | 0.10 | 0.10 | 1.05 (0.99 to 1.11) |"
            in text)
    assert "built by Clang 14.0.6 and by GNU 12.2.0" in text


def test_builds_of_other_machines_or_commits_are_not_compared(written):
    lines = [line for line in all_sweeps() if line["sweep"] == "isa"]
    written(text_of(lines), "sweeps-gnu.jsonl")
    folder = written(of_clang(lines, commit="def"), "sweeps-clang.jsonl")
    assert "its commit is not that of sweeps-clang.jsonl" in refusal(folder)
    written(of_clang(lines, cpu=MACHINE["cpu"] | {"name": "Other"}), "sweeps-clang.jsonl")
    assert "its processor is not that of" in refusal(folder)


def test_page_has_a_section_of_sweeps_where_there_is_a_journal(run):
    folder = run.write()
    build(folder)
    assert 'id="sweeps"' not in (folder / "index.html").read_text()
    assert not (folder / "sweeps.csv").exists()
    (folder / "sweeps.jsonl").write_text(text_of(all_sweeps()))
    build(folder)
    page = (folder / "index.html").read_text()
    assert 'id="sweeps"' in page and 'href="#sweeps"' in page and 'href="sweeps.csv"' in page
    assert (folder / "plots" / "sweep_isa.png").exists()


def test_sweeps_of_another_machine_do_not_stand_on_the_page(run, refusal):
    first = header(all_sweeps())
    first["machine"] = first["machine"] | {"fingerprint": "another"}
    folder = run.write()
    (folder / "sweeps.jsonl").write_text(text_of(all_sweeps(), first))
    assert ("fingerprint is another; it must be intel-6-143-8-1a2b3c4d, as of the other files"
            in refusal(folder))


def test_command_writes_the_sweeps_of_a_folder_without_a_study(written):
    folder = written()
    done = command("sweeps", folder)
    assert done.returncode == 0, done.stderr
    assert (folder / "sweeps.md").read_text().startswith("# Sweeps\n")
    (folder / "sweeps.jsonl").unlink()
    done = command("sweeps", folder)
    assert done.returncode == 1 and done.stderr.count("\n") == 1
