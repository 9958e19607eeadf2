"""Which mutants are tried, and what is known of them."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from families import Family
from operators import Mutation, mutations

AT_A_TIME = 4


@dataclass(frozen=True)
class Candidate:
    """A mutation of a file of a family. `before` and `after` are whole lines."""

    family: Family
    file: str
    mutation: Mutation
    before: str
    after: str
    key: str  # changes with the file's text

    def __str__(self) -> str:
        return f"kernels/{self.file}:{self.mutation.line}\n  - {self.before}\n  + {self.after}"


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
        for mutation in mutations(text):
            key = _digest(file, mutation.apply(text))
            found.append(Candidate(family, file, mutation, *_lines(text, mutation), key))
    found.sort(key=lambda one: _digest(str(seed), one.key))
    earlier: Counter[str] = Counter()
    turns: dict[str, int] = {}
    for one in found:
        turns[one.key] = earlier[one.mutation.operator]
        earlier[one.mutation.operator] += 1
    return sorted(found, key=lambda one: turns[one.key])


def _lines(text: str, mutation: Mutation) -> tuple[str, str]:
    before, after = (one.split("\n")[mutation.line - 1].strip()
                     for one in (text, mutation.apply(text)))
    return before, after


def _digest(*words: str) -> str:
    return hashlib.sha256("\0".join(words).encode()).hexdigest()[:16]


def next_of(queue: Sequence[Candidate], wanted: int,
            results: Mapping[str, Result]) -> list[Candidate]:
    """A few that are to be tried next, until `wanted` of the queue count."""
    counted = 0
    for number, one in enumerate(queue):
        if counted == wanted:
            break
        if one.key not in results:
            few = queue[number:number + min(AT_A_TIME, wanted - counted)]
            return [candidate for candidate in few if candidate.key not in results]
        counted += results[one.key].counts()
    return []


def read_results(path: Path) -> dict[str, Result]:
    """By key; the last line of a key holds. An incomplete line, of an interrupted run, is ignored."""
    results: dict[str, Result] = {}
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
        try:
            key, result = json.loads(line)
        except json.JSONDecodeError:
            continue
        results[key] = Result(**result)
    return results


def append_result(path: Path, key: str, result: Result) -> None:
    """As one line of JSON."""
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    with path.open("a", encoding="utf-8") as out:
        out.write("" if text.endswith("\n") or not text else "\n")
        out.write(json.dumps([key, asdict(result)]) + "\n")


@dataclass(frozen=True)
class Equivalent:
    """A mutant that no test can notice, and why."""

    file: str
    before: str
    after: str
    reason: str

    def describes(self, one: Candidate) -> bool:
        """Whether this is the mutant."""
        return (self.file, self.before, self.after) == (one.file, one.before, one.after)


def read_equivalents(path: Path) -> list[Equivalent]:
    """The list in the sources."""
    return [Equivalent(**entry) for entry in json.loads(path.read_text(encoding="utf-8"))]


def stale(equivalents: Sequence[Equivalent], kernels: Path) -> Iterator[Equivalent]:
    """Entries whose line the sources no longer have, or that no operator makes of it."""
    for entry in equivalents:
        path = kernels / entry.file
        text = path.read_text(encoding="utf-8") if path.is_file() else ""
        if (entry.before, entry.after) not in {_lines(text, one) for one in mutations(text)}:
            yield entry
