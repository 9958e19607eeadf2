"""Reads journals of thinbench_sweeps, and refuses what cannot be trusted."""

from __future__ import annotations

import json
import lzma
from dataclasses import dataclass, field
from pathlib import Path

from report.cases import case_in
from report.errors import ReportError
from report.json_fields import Fields
from report.machine import load_machine
from report.sweeps.model import SWEEPS, Journal, Place, Point

MAIN = "sweeps.jsonl"
RESUME = "thinbench_sweeps --resume completes it"


@dataclass
class _Series:
    """The samples of a place, as they are read."""

    pixels: int
    proved_against: str
    clock: str
    by_round: dict[int, float] = field(default_factory=dict)


def load_journals(directory: Path) -> tuple[Journal | None, list[Journal]]:
    """The main journal, where there is one, and those of single compilers."""
    main = _found(directory, MAIN)
    others = sorted({path.name.removesuffix(".xz") for path in directory.glob("sweeps-*.jsonl*")
                     if path.name.endswith((".jsonl", ".jsonl.xz"))})
    paths = [path for name in others if (path := _found(directory, name))]
    return (load_journal(main) if main else None), [load_journal(path) for path in paths]


def load_journal(path: Path) -> Journal:
    """One journal; it may end early, but not in the middle of a line."""
    header, *lines = _lines(path)
    if header.data.get("kind") != "header":
        raise ReportError(f"{header.where}: kind is {header.data.get('kind')!r}; it must be "
                          "'header': a journal of thinbench_sweeps is needed")
    header.check_schema()
    machine = header.child("machine")
    options = machine.child("options")
    series: dict[Place, _Series] = {}
    for line in lines:
        if line.text("kind") == "sample":
            _take(line, series)
    return Journal(
        path.name.removesuffix(".xz"), load_machine(machine), options.data.get("quick") is True,
        options.count("rounds", 1), header.count("points", 1),
        tuple(Point(place, found.pixels, found.proved_against, found.clock,
                    tuple(found.by_round.values())) for place, found in series.items()))


def _found(directory: Path, name: str) -> Path | None:
    return next((path for path in (directory / name, directory / f"{name}.xz") if path.exists()),
                None)


def _lines(path: Path) -> list[Fields]:
    try:
        data = path.read_bytes()
        text = (lzma.decompress(data) if path.suffix == ".xz" else data).decode("utf-8")
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, EOFError, lzma.LZMAError) as error:
        raise ReportError(f"{path}: damaged: {error}; measure it again") from None
    if not text.endswith("\n"):
        raise ReportError(f"{path}: its last line is truncated; {RESUME}")
    return [_line(line, f"{path}: line {number}")
            for number, line in enumerate(text.splitlines(), 1)]


def _line(text: str, where: str) -> Fields:
    try:
        return Fields(json.loads(text), where)
    except (ValueError, RecursionError) as error:
        raise ReportError(f"{where}: not JSON: {error}; measure it again") from None


def _take(line: Fields, series: dict[Place, _Series]) -> None:
    sweep = line.text("sweep")
    if sweep not in SWEEPS:
        raise ReportError(f"{line.where}: sweep is '{sweep}'; it must be one of "
                          f"{', '.join(SWEEPS)}")
    place = Place(sweep, line.number("x"), line.number("y") if line.has("y") else None,
                  case_in(line), line.text("technique"), line.text("isa"),
                  line.count("threads", 1))
    pixels = line.count("pixels", 1)
    found = series.setdefault(place, _Series(pixels, line.text("proved_against"),
                                             line.text("clock")))
    number = line.count("round")
    if number in found.by_round or pixels != found.pixels:
        raise ReportError(f"{line.where}: round {number} of {place.case.name} at x {place.x:g} is "
                          "there twice or on another size; each point has one sample a round")
    found.by_round[number] = line.positive("ns") / line.count("calls", 1) / pixels
