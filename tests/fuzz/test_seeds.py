"""Packed seeds: what is added is unpacked again, byte for byte."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.fuzz import seeds


def test_added_files_are_sorted_lines_and_are_unpacked(tmp_path: Path) -> None:
    packed, directory = str(tmp_path / "a.seeds"), tmp_path / "unpacked"
    contents = {"one": b"text\n", "bytes": bytes(range(256)), "empty": b""}
    for name, content in contents.items():
        (tmp_path / name).write_bytes(content)
        seeds.main(["add", packed, str(tmp_path / name)])
    seeds.main(["unpack", packed, str(directory)])
    assert {path.name: path.read_bytes() for path in directory.iterdir()} == contents
    assert [line.split(" ")[0] for line in Path(packed).read_text().splitlines()] == sorted(contents)


def test_a_file_with_the_name_of_a_seed_replaces_it(tmp_path: Path) -> None:
    packed, seed = tmp_path / "a.seeds", tmp_path / "seed"
    for content in (b"old", b"new"):
        seed.write_bytes(content)
        seeds.add(packed, [seed])
    assert seeds.read(packed) == {"seed": b"new"}


def test_wrong_arguments_are_the_usage() -> None:
    with pytest.raises(SystemExit, match="unpack TARGET.seeds DIRECTORY"):
        seeds.main(["add", "a.seeds"])
