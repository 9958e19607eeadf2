"""./study pages: which pictures, and what is said of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from conftest import make_row, study
from fake_programs import install

from report.errors import ReportError
from report.measure.run import Run
from report.pages import comparisons, images_of, load_pages, pages_markdown, pages_table, ratios_table


def rows_of(picture: str, ours: float, theirs: float) -> list:
    own = make_row("label_image", "simd_contacts", "avx512", ours, input=picture)
    peer = replace(own, technique="opencv", time_ns=theirs, peer=True, default=False)
    return [own, peer, replace(own, default=False, threads=2), replace(peer, technique="copy")]


def test_ratios_are_worst_mean_and_best_over_the_pictures() -> None:
    rows = [*rows_of("coins", 100, 200), *rows_of("horse", 100, 800)]
    (one,) = comparisons(rows)
    assert (one.peer, one.ratios) == ("opencv", (2.0, 8.0))
    assert "| label image | 2 | " in pages_table(rows) and "| opencv | 2.00× | 4.00× | 8.00× |" in pages_table(rows)


def test_an_operation_without_a_peer_is_left_out_where_ratios_are_asked_for() -> None:
    rows = [make_row("fill_holes", "simd_flood", "avx512", 100)]
    assert "filled holes" in pages_table(rows)
    assert "filled holes" not in ratios_table(rows)


def test_large_pages_have_a_table_of_their_own() -> None:
    rows = [*rows_of("coins", 100, 200), *(replace(row, width=2000, height=2000) for row in rows_of("scan", 100, 300))]
    run = Run(Path(), {"machine": {"commit": "1234", "cpu": {"name": "a processor"}}, "controls": {"failed": 0}}, rows)
    small, large, cells = pages_markdown(run).split("\n## ")[1:]
    assert "| label image | 1 |" in small and "| coins | opencv | 2.00× | 2.00× | 2.00× |" in small
    assert "| label image | 1 |" in large and "| scan | opencv | 3.00× | 3.00× | 3.00× |" in large
    assert "| coins |" in cells and "| scan |" in cells


def test_the_fastest_peer_of_each_picture_counts() -> None:
    rows = [*rows_of("coins", 100, 900), *rows_of("horse", 100, 800)]
    rows.append(replace(rows[1], technique="opencv_bbdt", time_ns=200))
    assert "| label image | equal | 2 | 2.00× | coins | 4.00× | 8.00× |" in ratios_table(rows)
    rows[-1] = replace(rows[-1], verified=False)
    assert "| label image | other | 2 | 2.00× |" in ratios_table(rows)


def test_a_peer_is_compared_on_the_pictures_that_it_was_timed_on() -> None:
    rows = [*rows_of("coins", 100, 300), make_row("label_image", "simd_contacts", "avx512", 10**6, input="horse")]
    (one,) = comparisons(rows)
    assert [row.input for row in one.chosen] == ["coins"]
    assert "horse" not in pages_table(rows)


def test_a_peer_that_was_timed_on_other_pictures_only_is_none() -> None:
    own, _, *_ = rows_of("coins", 100, 300)
    _, peer, *_ = rows_of("horse", 100, 300)
    (one,) = comparisons([own, peer])
    assert (one.peer, one.chosen) == ("", (own,))
    assert "| label image | 1 | " in pages_table([own, peer])


def test_a_list_of_names_or_the_endings_say_what_is_an_image(tmp_path: Path) -> None:
    for name in ("b.tif", "a.png", "notes.md"):
        (tmp_path / name).touch()
    assert images_of(tmp_path) == [tmp_path / "a.png", tmp_path / "b.tif"]
    (tmp_path / "files.txt").write_text("b.tif\r\n\n", encoding="utf-8")
    assert images_of(tmp_path) == [tmp_path / "b.tif"]


def test_images_of_one_name_are_rejected(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "one.png").touch()
    done = study(tmp_path, "pages", "--images", tmp_path / "a", "--images", tmp_path / "b")
    assert done.returncode == 2
    assert "have one name, 'one', in tables; rename one" in done.stderr


@pytest.mark.parametrize("what", ["absent", "empty"])
def test_a_directory_without_images_is_named(what: str, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(ReportError, match=f"--images: '.*{what}'"):
        images_of(tmp_path / what)


def test_pages_are_a_run_of_their_own_beside_the_study(tmp_path: Path) -> None:
    install(tmp_path / "builds" / "release")
    (tmp_path / "scans").mkdir()
    for name in ("one.png", "two.png"):
        (tmp_path / "scans" / name).touch()
    done = study(tmp_path / "builds", "pages", "--quick", "--seconds", "1", "--images", tmp_path / "scans", "--out", tmp_path / "run")
    assert done.returncode == 0, done.stderr
    run = load_pages(tmp_path / "run")
    assert run and {row.input for row in run.rows} == {"one", "two"}
    assert "| one |" in (tmp_path / "run" / "pages" / "pages.md").read_text(encoding="utf-8")
    assert load_pages(tmp_path) is None
