"""`./study many-images` on tiny inputs: every step is verified, and the CSV file has its figures."""

from __future__ import annotations

import os
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

pytest.importorskip("distributed")
pytest.importorskip("skimage")
pytest.importorskip("cv2")

# pylint: disable=wrong-import-position
from report.errors import ReportError  # noqa: E402
from report.many_images.command import QUICK, measure_many_images  # noqa: E402
from report.many_images.results import COLUMNS, CSV, read_csv  # noqa: E402
from report.many_images.steps import Figures, Key, Step, measure  # noqa: E402
from tests.programs import PROGRAMS  # noqa: E402

MACHINE = {"commit": "abc1234", "fingerprint": "intel-6-143-8-1a2b3c4d", "cores": 2,
           "cpu": {"name": "Fake, with comma"}}
SIZES = replace(QUICK, files=2, loop_files=1, rounds=1)
BASE = Key("images", "one")


@pytest.fixture(scope="module", name="measured")
def _measured(tmp_path_factory):
    directory = tmp_path_factory.mktemp("many") / "out"
    run = subprocess.run

    def checked(command, **options):
        assert "MALLOC_TRIM_THRESHOLD_" not in os.environ  # dask's, for its workers
        if "--out" in command and "--shard" not in command:
            assert not list(Path(command[command.index("--out") + 1]).iterdir())
        return run(command, **options)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(subprocess, "run", checked)
        return directory, measure_many_images(PROGRAMS / "thinbench", MACHINE, SIZES, directory)


def test_csv_has_every_step_with_its_machine(measured):
    directory, _ = measured
    assert (directory / CSV).read_text().splitlines()[0].split(",") == COLUMNS
    results = read_csv(directory / CSV)
    assert set(zip(results.commit, results.processor, results.cores, results.rounds, results["flags"])) == {
        ("abc1234", "Fake, with comma", 2, 1, "open")}
    assert set(zip(results.experiment, results.x)) == {
        ("images", 0), ("workers", 1), ("workers", 2), ("calls", 0), ("dask", 600), ("dask", 200), ("dask", 300)}
    assert (results.time <= results.high).all()
    opencv = results[results.method == "cv2.ximgproc.thinning"]
    assert list(opencv.base) == ["compat.cv2.thinning"]
    assert opencv.ratio.notna().all()


def test_tables_are_printed(measured):
    directory, text = measured
    assert text.count("\n| ---") == 4 and text.endswith(f"{directory} holds {CSV}")
    assert "| `compat.skimage.thin` |" in text


def steps_of(*calls: tuple[str, list[float], str]) -> list[Step]:
    """By name: a time for each run, of which the first is that of the verification, and a digest."""
    def step(name: str, times: list[float], digest: str) -> Step:
        left = iter(times)

        def run() -> Figures:
            return {"ms_per_call": [next(left)]}
        return Step(Key("images", name), BASE, run, lambda: digest)
    return [step(*call) for call in calls]


def test_other_pixels_are_not_timed():
    with pytest.raises(ReportError, match="two: other pixels than one"):
        measure(steps_of(("one", [1.0], "same"), ("two", [1.0], "other")), 1)


def test_every_round_runs_every_step():
    samples = measure(steps_of(("one", [9.0, 1.0, 1.0, 1.0], "same"), ("two", [9.0, 2.0, 3.0, 2.0], "same")), 3)
    assert sorted(samples["ns"]) == [1.0, 1.0, 1.0, 2.0, 2.0, 3.0]
    assert set(samples["row"]) == {"images/one/0/ms_per_call", "images/two/0/ms_per_call"}


def test_a_file_that_is_no_table_is_rejected(tmp_path):
    (tmp_path / CSV).write_text("a,b\n1,2\n")
    with pytest.raises(ReportError, match="not such a table"):
        read_csv(tmp_path / CSV)
