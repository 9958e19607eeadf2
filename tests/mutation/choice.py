"""Which mutants are tried, and what is known of them."""

from __future__ import annotations

import hashlib
import json
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path

from families import Family
from operators import Mutation, mutations

AT_A_TIME = 4

Equivalents = Mapping[tuple[str, str, str], str]  # by file and line before and after: why no test can notice it


@dataclass(frozen=True)
class Candidate:
    """A mutation of a file of a family."""

    family: Family
    file: str
    mutation: Mutation
    key: str  # changes with the file's text

    def is_in(self, equivalents: Equivalents) -> bool:
        """Whether we know why no test notices it."""
        return (self.file, self.mutation.before, self.mutation.after) in equivalents

    def __str__(self) -> str:
        return f"kernels/{self.file}:{self.mutation.line}\n  - {self.mutation.before}\n  + {self.mutation.after}"


@dataclass(frozen=True)
class Result:
    """`state` is killed, survived, not compiled or same code; `test` is what killed it."""

    state: str
    test: str = ""
    seconds: float = 0

    def counts(self) -> bool:
        """Whether a test could notice it."""
        return self.state in ("killed", "survived")


def candidates(family: Family, kernels: Path, seed: int) -> list[Candidate]:
    """In an order drawn by `seed`, one of each operator in rotation."""
    found: list[Candidate] = []
    for file in family.files(kernels):
        text = (kernels / file).read_text(encoding="utf-8")
        found += [Candidate(family, file, one, _digest(file, one.apply(text))) for one in mutations(text)]
    by_operator: dict[str, list[Candidate]] = defaultdict(list)
    for candidate in sorted(found, key=lambda one: _digest(str(seed), one.key)):
        by_operator[candidate.mutation.operator].append(candidate)
    return [one for some in zip_longest(*by_operator.values()) for one in some if one]


def _digest(*words: str) -> str:
    return hashlib.sha256("\0".join(words).encode()).hexdigest()[:16]


def to_try(queues: Sequence[Sequence[Candidate]], wanted: int, results: Mapping[str, Result],
           equivalents: Equivalents) -> Iterator[Candidate]:
    """Survivors of earlier runs, then a few of each queue in rotation, so that an interrupted run covers all
    evenly, until `wanted` of each count. The caller adds their results."""
    yield from [one for queue in queues for one in queue if one.key in results
                and results[one.key].state == "survived" and not one.is_in(equivalents)]
    while few := [one for queue in queues for one in _next_of(queue, wanted, results)]:
        yield from sorted(few, key=lambda one: one.file)  # as that of the mutant before is built again


def _next_of(queue: Sequence[Candidate], wanted: int, results: Mapping[str, Result]) -> list[Candidate]:
    few: list[Candidate] = []
    for one in queue:
        if len(few) == min(AT_A_TIME, wanted):
            break
        if one.key in results:
            wanted -= results[one.key].counts()
        else:
            few.append(one)
    return few


def read_equivalents(path: Path) -> Equivalents:
    """The list in the sources."""
    return {(one["file"], one["before"], one["after"]): one["reason"]
            for one in json.loads(path.read_text(encoding="utf-8"))}


def stale(equivalents: Equivalents, kernels: Path) -> list[tuple[str, str, str]]:
    """Entries whose line the sources no longer have, or that no operator makes of it."""
    made = {(file, one.before, one.after) for file, _, _ in equivalents if (kernels / file).is_file()
            for one in mutations((kernels / file).read_text(encoding="utf-8"))}
    return [place for place in equivalents if place not in made]
