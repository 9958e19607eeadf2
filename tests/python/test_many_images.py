"""`./study many-images` on tiny inputs: the CSV file, the plots and the tables in docs/."""

from __future__ import annotations

import sys
from dataclasses import fields, replace
from pathlib import Path
from xml.etree import ElementTree

import pytest

import thinbench

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(thinbench.__file__).resolve().parents[2] / "bin" / "thinbench"
sys.path.insert(0, str(ROOT))

pytest.importorskip("distributed")
pytest.importorskip("skimage")
pytest.importorskip("cv2")

# pylint: disable=wrong-import-position
from report.errors import ReportError  # noqa: E402
from report.many_images.command import CSV, QUICK, draw, measure_many_images  # noqa: E402
from report.many_images.plots import plots  # noqa: E402
from report.many_images.results import Result, read_csv  # noqa: E402
from report.many_images.steps import Key, Step, measure  # noqa: E402
from report.many_images.tables import tables  # noqa: E402

MACHINE = {"commit": "abc1234", "fingerprint": "intel-6-143-8-1a2b3c4d", "cores": 2,
           "cpu": {"name": "Fake, with comma"}}
PLOTS = ("images.svg", "workers.svg", "dask.svg", "out_of_core.svg")
SIZES = replace(QUICK, rounds=1, files_per_round=1, large_sides=(2000,))
PAGES = {"images": "batches.md", "workers": "batches.md", "dask": "python.md",
         "out_of_core": "large-images.md"}


@pytest.fixture(scope="module", name="directory")
def _directory(tmp_path_factory):
    directory = tmp_path_factory.mktemp("many") / "out"
    measure_many_images(PROGRAM, MACHINE, SIZES, directory)
    return directory


def text_of(svg: bytes) -> str:
    return "\n".join(filter(None, (one.text for one in ElementTree.fromstring(svg).iter())))


def test_csv_has_every_step_with_its_machine(directory):
    header = (directory / CSV).read_text().splitlines()[0]
    assert header.split(",") == [field.name for field in fields(Result)]
    results = read_csv(directory / CSV)
    assert {(one.commit, one.processor, one.cores, one.rounds) for one in results} == {
        ("abc1234", "Fake, with comma", 2, 1)}
    found = {(one.experiment, one.x) for one in results}
    assert found == {("images", 0), ("workers", 1), ("workers", 2), ("dask", 600), ("dask", 200),
                     ("dask", 300), ("out_of_core", 2000)}
    assert all(one.low <= one.median <= one.high for one in results)
    (opencv,) = [one for one in results if one.method == "Python loop over cv2.ximgproc.thinning"
                 and one.quantity == "compute_ms"]
    assert opencv.base == "thinbench batch thin_guo_hall --border keep"
    assert opencv.ratio is not None and opencv.ratio > 10


def test_plots_parse_and_have_units_and_dark_colours(directory):
    texts = {name: text_of((directory / name).read_bytes()) for name in PLOTS}
    assert all("prefers-color-scheme: dark" in text for text in texts.values())
    assert "per second" in texts["workers.svg"] and "images/s" in texts["images.svg"]
    assert "logarithmic" in texts["dask.svg"] and ", ns" in texts["out_of_core.svg"]


def test_drawing_again_changes_nothing(directory):
    before = {name: (directory / name).read_bytes() for name in PLOTS}
    draw(directory)
    assert before == {name: (directory / name).read_bytes() for name in PLOTS}


def test_pages_have_the_tables_of_the_committed_file_and_its_plots():
    committed = ROOT / "results" / "many-images"
    results = read_csv(committed / CSV)
    for name, svg in plots(results).items():
        assert text_of((committed / name).read_bytes()) == text_of(svg)
    for experiment, table in tables(results).items():
        page = (ROOT / "docs" / PAGES[experiment]).read_text(encoding="utf-8")
        assert table in page
        assert f"(../results/many-images/{experiment}.svg)" in page


def test_other_pixels_are_not_timed():
    base = Key("images", "one")
    steps = [Step(base, base, lambda _: {}, lambda: "same"),
             Step(Key("images", "two"), base, lambda _: {}, lambda: "other")]
    with pytest.raises(ReportError, match="two: other pixels than one"):
        measure(steps, 1)


def test_a_file_that_is_no_table_is_rejected(tmp_path):
    (tmp_path / CSV).write_text("a,b\n1,2\n")
    with pytest.raises(ReportError, match="not such a table"):
        draw(tmp_path)
