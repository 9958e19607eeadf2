"""Tables and contact sheets of skeletons."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from conftest import Run
from PIL import Image

from report.build import build
from report.experiments import load_experiments
from report.plot_skeletons import DETAIL, busiest
from report.quality_tables import make_quality_tables

OPERATIONS = ("thin_a", "thin_b")


def make_quality(**changed: Any) -> dict[str, Any]:
    """Two operations on one input; the second loses objects."""
    rows = [{"operation": operation, "input": "blobs", "objects_before": 5, "objects_after": after,
             "holes_before": 2, "holes_after": 2, "pixels": 1234, "blocks": 1, "ends": 7,
             "branches": 3, "mean_distance": 0.25, "largest_distance": 2.0, "least_symmetry": 0.5,
             "iterations": 9} for operation, after in zip(OPERATIONS, (5, 4))]
    rows[1] |= changed
    return {"schema": 1, "experiment": "quality", "command": "thinbench experiment quality",
            "rows": rows}


def write(run: Run, quality: dict[str, Any], with_pictures: bool = True) -> Run:
    """The run with the experiment and its pictures."""
    folder = run.write() / "experiments"
    folder.mkdir()
    (folder / "quality.json").write_text(json.dumps(quality))
    if with_pictures:
        for end in ("", *(f"_{operation}" for operation in OPERATIONS)):
            Image.fromarray(np.eye(150, dtype=np.uint8) * 255).save(
                run.directory / f"pictures/quality_blobs{end}.png")
    return run


def test_table_and_contact_sheet_stand_on_the_page(run):
    build(write(run, make_quality()).directory)
    page, text = ((run.directory / name).read_text() for name in ("index.html", "experiments.md"))
    assert ">Skeletons of blobs</h3>" in page and "skeletons_blobs.svg" in page
    assert "| thin_b | 5 → 4 | 2 | 1,234 | 1 | 7 | 3 | 0.250 | 2.00 | 0.500 | 9 |" in text
    assert "not as many as before with thin_b." in text
    assert (run.directory / "plots/skeletons_blobs.png").is_file()


def test_without_pictures_there_is_a_table_and_no_sheet(run):
    write(run, make_quality(objects_after=5), with_pictures=False)
    quality = load_experiments(run.directory).quality
    assert quality
    [table] = make_quality_tables(quality, run.directory)
    assert table.plot is None and table.sentence.startswith("Every case leaves as many")


@pytest.mark.parametrize(("key", "value"), [("least_symmetry", 1.5), ("pixels", -1), ("ends", None)])
def test_impossible_values_are_refused(run, refusal, key, value):
    assert key in refusal(write(run, make_quality(**{key: value})).directory)


def test_files_of_one_turn_are_read_and_called_so(run):
    quality = make_quality()
    for row in quality["rows"]:
        row["symmetry"] = row.pop("least_symmetry")
    build(write(run, quality).directory)
    csv = run.directory / "plots/skeletons_blobs.csv"
    assert csv.read_text().splitlines()[0].endswith(",largest_distance,symmetry,iterations,border,max_iterations")
    assert "over one rotation, by 90 degrees" in (run.directory / "experiments.md").read_text()
    build(write(Run(run.directory.parent / "new"), make_quality()).directory)
    new = (run.directory.parent / "new/experiments.md").read_text()
    assert "over rotations by 90, 180 and 270 degrees" in new


def test_file_that_is_no_picture_is_refused(run, refusal):
    write(run, make_quality())
    (run.directory / "pictures/quality_blobs_thin_a.png").write_text("no picture")
    assert "quality_blobs_thin_a.png" in refusal(run.directory)


def test_detail_is_where_the_contour_is_longest():
    shape = np.zeros((300, 400), dtype=bool)
    shape[150:190:2, 250:300] = True
    rows, columns = busiest(shape)
    assert rows.start <= 150 and rows.stop >= 190 and columns.start <= 250
    assert rows.stop - rows.start == DETAIL
    assert busiest(np.zeros((10, 10), dtype=bool))[0].start == 0
