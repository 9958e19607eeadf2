"""Which mutants are tried, and what is known of them."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

from families import Family
from operators import Mutation, mutations


@dataclass(frozen=True)
class Candidate:
    """A mutation of a file of a family. `before` and `after` are whole lines."""

    family: str
    file: str
    mutation: Mutation
    before: str
    after: str
    key: str  # changes with the file's text


def candidates(family: Family, kernels: Path, seed: int) -> list[Candidate]:
    """In an order drawn by `seed`, one of each operator in rotation."""
    by_operator: dict[str, list[Candidate]] = {}
    for file in family.files(kernels):
        text = (kernels / file).read_text(encoding="utf-8")
        for mutation in mutations(text):
            candidate = _candidate(family, file, text, mutation)
            by_operator.setdefault(mutation.operator, []).append(candidate)
    for found in by_operator.values():
        found.sort(key=lambda one: _digest(str(seed), one.key))
    order = sorted(by_operator, key=lambda operator: _digest(str(seed), operator))
    longest = max((len(found) for found in by_operator.values()), default=0)
    return [by_operator[operator][turn] for turn in range(longest) for operator in order
            if turn < len(by_operator[operator])]


def _candidate(family: Family, file: str, text: str, mutation: Mutation) -> Candidate:
    changed = mutation.apply(text)
    before, after = (one.split("\n")[mutation.line - 1].strip() for one in (text, changed))
    return Candidate(family.name, file, mutation, before, after, _digest(file, changed))


def _digest(*words: str) -> str:
    return hashlib.sha256("\0".join(words).encode()).hexdigest()[:16]


@dataclass(frozen=True)
class Result:
    """A line of the file of results."""

    key: str
    family: str
    file: str
    line: int
    operator: str
    before: str
    after: str
    state: str
    test: str
    seconds: float

    def counts(self) -> bool:
        """Whether a test could notice it."""
        return self.state in ("killed", "survived")


def result_of(candidate: Candidate, state: str, test: str, seconds: float) -> Result:
    """What is kept of a mutant."""
    return Result(candidate.key, candidate.family, candidate.file, candidate.mutation.line,
                  candidate.mutation.operator, candidate.before, candidate.after, state, test, round(seconds, 1))


def read_results(path: Path) -> dict[str, Result]:
    """By key; the last line of a key holds. An incomplete line, of an interrupted run, is ignored."""
    results: dict[str, Result] = {}
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
        try:
            result = Result(**json.loads(line))
        except (json.JSONDecodeError, TypeError):
            continue
        results[result.key] = result
    return results


def append_result(path: Path, result: Result) -> None:
    """As one line of JSON."""
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    with path.open("a", encoding="utf-8") as out:
        out.write(("" if text.endswith("\n") or not text else "\n") + json.dumps(asdict(result)) + "\n")


@dataclass(frozen=True)
class Equivalent:
    """A mutant that no test can notice, and why."""

    file: str
    before: str
    after: str
    reason: str


def read_equivalents(path: Path) -> list[Equivalent]:
    """The list in the sources."""
    return [Equivalent(**entry) for entry in json.loads(path.read_text(encoding="utf-8"))]


def stale(equivalents: list[Equivalent], kernels: Path) -> Iterator[Equivalent]:
    """Entries whose line the sources no longer have, or that no operator makes of it."""
    for entry in equivalents:
        path = kernels / entry.file
        text = path.read_text(encoding="utf-8") if path.is_file() else ""
        lines = text.split("\n")
        made = {(lines[one.line - 1].strip(), one.apply(text).split("\n")[one.line - 1].strip())
                for one in mutations(text) if lines[one.line - 1].strip() == entry.before}
        if (entry.before, entry.after) not in made:
            yield entry
