"""Processes of an unfinished measurement, kept as soon as each is done, so that it can be
continued. The first line holds what is measured, each other line a process of one part."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from report.errors import ReportError
from report.files import read_bytes, write_file
from report.measure.sampler import Json, Process, Samples
from report.schemas import check_schema

NAME = "unfinished.jsonl"


@dataclass(frozen=True)
class Part:
    """One sweep in one build."""

    build: str
    sweep: str
    samples: Samples


class Journal:
    """`key` is what must be equal for a measurement to go on: options, commit, machine."""

    def __init__(self, path: Path, parts: list[Part]) -> None:
        self.path, self.parts = path, parts

    @staticmethod
    def begin(path: Path, key: Json, parts: list[Part]) -> Journal:
        """Writes the first line."""
        header = {"key": key, "parts": [{"build": part.build, "sweep": part.sweep,
                                         "plan": part.samples.plan} for part in parts]}
        write_file(path, (json.dumps(header) + "\n").encode())
        return Journal(path, parts)

    @staticmethod
    def load(path: Path, key: Json) -> Journal:
        """Drops a last line that was not written to its end."""
        whole, _, _ = read_bytes(path).rpartition(b"\n")
        try:
            header, *lines = [json.loads(line) for line in whole.decode().splitlines()]
        except (ValueError, RecursionError):
            raise ReportError(f"{path}: cannot be continued; delete it, or choose another "
                              "--out") from None
        check_schema("unfinished", header, str(path))
        _check_key(path, header["key"], key)
        write_file(path, whole + b"\n")
        parts = [Part(part["build"], part["sweep"], Samples(part["plan"]))
                 for part in header["parts"]]
        for number, line in enumerate(lines, 2):
            try:
                part = dict(enumerate(parts))[line.pop("part")]
                part.samples.processes.append(Process(**line))
            except (AttributeError, LookupError, TypeError):
                raise ReportError(f"{path}: line {number} holds no process; delete it and what follows") from None
        return Journal(path, parts)

    def append(self, samples: Samples) -> None:
        """The latest process of a part."""
        index = next(number for number, part in enumerate(self.parts) if part.samples is samples)
        with self.path.open("a", encoding="utf-8") as stream:
            stream.write(json.dumps({"part": index, **vars(samples.processes[-1])}) + "\n")

    def close(self) -> None:
        """The measurement is complete."""
        self.path.unlink()


def _check_key(path: Path, old: Json, new: Json) -> None:
    for name, value in new.items():
        if old.get(name) != value:
            raise ReportError(f"{path}: {name} was {old.get(name)!r} and is now {value!r}; "
                              "--resume needs the same")
