"""The runner of scikit-image, with and without it."""

from __future__ import annotations

import json
import sys
from types import SimpleNamespace

import pytest
from conftest import ROOT, Run, entries, jittered

sys.path.insert(0, str(ROOT / "bench" / "peers"))
import skimage_peer  # noqa: E402

NAME = "thin_guo_hall/skimage_thin/native/1/end_to_end/scene"


@pytest.fixture
def with_reference(run: Run) -> Run:
    """A run in which the operation beside the peer was timed."""
    reference = "thin_guo_hall/reference/baseline/1/end_to_end/scene"
    run.timings["benchmarks"] += entries(reference, (510, 412), jittered(1e7, reference))
    run.rows["peers"] = []
    run.write()
    return run


def rows_of(run: Run, pattern: str = "") -> tuple[dict, list[dict]]:
    path = run.directory / "timings.json"
    skimage_peer.main(run.directory, path, 3, pattern)
    timed = [entry for entry in json.loads(path.read_text())["benchmarks"]
             if "skimage" in entry["name"]]
    return json.loads((run.directory / "rows.json").read_text()), timed


def fake(monkeypatch: pytest.MonkeyPatch, function) -> None:
    module = SimpleNamespace(__version__="9.9", morphology=SimpleNamespace(thin=function))
    monkeypatch.setitem(sys.modules, "skimage", module)


def test_absent_library_is_a_skipped_row(with_reference, monkeypatch):
    monkeypatch.setitem(sys.modules, "skimage", None)
    rows, timed = rows_of(with_reference)
    assert not timed and {"row": NAME, "reason": skimage_peer.REASON} in rows["skipped"]


def test_rows_carry_times_and_the_version(with_reference, monkeypatch):
    fake(monkeypatch, lambda objects: objects)
    rows, timed = rows_of(with_reference)
    assert [entry["name"] for entry in timed] == [NAME] * 3
    assert all(entry["peer"] == entry["verified"] == 1 for entry in timed)
    assert rows["peers"][0]["about"].startswith("scikit-image 9.9, thin, 1 thread")


def test_filter_leaves_rows_out(with_reference, monkeypatch):
    fake(monkeypatch, lambda objects: objects)
    assert not rows_of(with_reference, "zhang")[1]


def test_what_is_no_subset_is_not_timed(with_reference, monkeypatch):
    fake(monkeypatch, lambda objects: ~objects)
    before = (with_reference.directory / "timings.json").read_bytes()
    with pytest.raises(SystemExit, match="no repeatable subset"):
        rows_of(with_reference)
    assert (with_reference.directory / "timings.json").read_bytes() == before
