"""`./study` on the programs of the build: what it says, and the user's image on the page."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from conftest import main, without_progress
from PIL import Image

import report.study
from report.measure.run import load_run
from tests.programs import PROGRAMS

Study = Callable[..., tuple[int, str]]


@pytest.fixture(name="study")
def _study(tmp_path, monkeypatch, capfd) -> Study:
    monkeypatch.setattr(report.study, "build", lambda preset, targets, **_: PROGRAMS)

    def run(*words: str) -> tuple[int, str]:
        """Status and what is on standard error, but for the progress on a slow machine."""
        status = main(["study", "--quick", "--seconds", "1", "--out", str(tmp_path / "run"), *words])
        return status, without_progress(capfd.readouterr().err)
    return run


@pytest.fixture(name="image")
def _image(tmp_path) -> Path:
    """A dark object on light ground."""
    pixels = np.full((60, 90), 230, np.uint8)
    pixels[20:40, 10:70] = 40
    Image.fromarray(pixels).save(tmp_path / "bolt.png")
    return tmp_path / "bolt.png"


def test_a_note_appears_once_and_the_image_is_on_the_page(study, image, tmp_path):
    status, errors = study("--image", str(image), "--filter", "^thin_guo_hall/", "--threads", "2,3")
    assert status == 0
    assert errors.count(f"note: {image}: foreground is dark") == 1
    assert "thinbench_benchmarks: " not in errors and "wrote" not in errors
    page = (tmp_path / "run" / "index.html").read_text(encoding="utf-8")
    assert 'alt="the picture, bolt"' in page
    assert load_run(tmp_path / "run").facts["options"]["threads"] == [2, 3]


@pytest.mark.parametrize("words, why", [
    (("--filter", "nothing"), "no row matches the filter 'nothing'"),
    (("--filter", "^edges_sobel/autovec/baseline/"), "no usual row matches the filter"),
    (("--filter", "/avx2/"), "is skipped: ")])
def test_where_nothing_can_be_measured_the_reason_is_given(study, monkeypatch, words, why):
    monkeypatch.setenv("THINBENCH_MAX_ISA", "sse4.2")
    status, errors = study(*words)
    assert status == 2
    program, own = errors.splitlines()
    assert program.startswith("thinbench_benchmarks: ") and why in program
    assert own == "study: nothing was measured; see above"


def test_reasons_of_skipped_rows_are_mentioned_once(study, monkeypatch):
    monkeypatch.setattr(report.measure.benchmarks, "_reported", set())
    monkeypatch.setenv("THINBENCH_MAX_ISA", "sse4.2")
    status, errors = study("--filter", "^euler_number/simd", "--size", "64")
    notes = errors.splitlines()
    assert status == 0 and len(notes) == len(set(notes)) > 0
    assert all(re.fullmatch("note: some rows are skipped: (above the ISA cap|this machine lacks .*)", note) for note in notes)


def test_a_file_that_is_no_image_is_named(study, image):
    image.write_text("text")
    status, errors = study("--image", str(image))
    assert status == 1 and f"cannot read '{image}': it is not an image" in errors
    assert "differs" not in errors


def test_a_size_is_measured_once(study, tmp_path):
    status, _ = study("--size", "64", "--size", "64", "--filter", "^objects/", "--no-peers")
    assert status == 0
    names = [(row.operation, row.technique, row.isa, row.threads, row.scope, row.input, row.border)
             for row in load_run(tmp_path / "run").rows]
    assert len(names) == len(set(names))


def test_sizes_that_were_asked_for_leave_no_series_without_an_input():
    parser = argparse.ArgumentParser()
    report.study.add_study_command(parser)
    options = parser.parse_args(["--quick", "--size", "64", "--size", "128", "--size", "256", "--size", "512"])
    plans = report.study.plans_of(options)
    assert len(plans) == 3 and all("--input" in plan for plan in plans[1:])
