"""Mutations of C++ text: small changes, each of which should make a test fail."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

# Comments, text, attributes and template heads decide no pixel.
HIDDEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![\w])'(?:\\.|[^'\\\n])+'"""
                    r"""|\[\[.*?\]\]|__attribute__\(\(\w+\)\)|\btemplate <[^\n]*""", re.DOTALL)
# Nor do preprocessing, declarations of types, prefetching, reserving memory and the words of errors.
SKIPPED = re.compile(r"^\s*(#|using |namespace |static_assert|throw |struct |class |enum |friend |operator)"
                     r"|prefetch|\breserve\(|\bthrow\b|\bstatic_assert\b|\bbool kHas")
NEIGHBOURS = {"west": "east", "east": "west", "above": "below", "below": "above", "north": "south",
              "south": "north"}
STATEMENT = re.compile(r"^\s*((?:\+\+|--)?[\w.\->\[\]:*]+(?:\([^;]*\)|(?: [|&^+\-]?=| <<=| >>=) [^;]*"
                       r"|\[[^;]*\] [|&^+\-]?= [^;]*)?;)$")
NO_STATEMENT = re.compile(r"^\s*(return|break|continue|case|default|static_cast<void>|const|auto|else)\b")

# Operator, what to find, and what to put in its place; the first group is replaced, if there is one.
PATTERNS: tuple[tuple[str, str, str], ...] = (
    ("gate", r"(?<= )&(?= )", "|"), ("gate", r"(?<= )\|(?= )", "&"), ("gate", r"(?<= )\^(?= )", "|"),
    ("gate", r"(?<!::)~(?=[\w(])(?!\w+\(\) (?:= default|override|\{))", ""),
    ("gate", r"(?<= )&=", "|="), ("gate", r"(?<= )\|=", "&="), ("gate", r"(?<= )\^=", "|="),
    ("shift", r"(?<= )<<(?= )", ">>"), ("shift", r"(?<= )>>(?= )", "<<"), ("shift", r"(?<= )<<=", ">>="),
    ("shift", r"(?<= )>>=", "<<="),
    ("comparison", r"(?<= )<(?= )", "<="), ("comparison", r"(?<= )<=(?= )", "<"),
    ("comparison", r"(?<= )>(?= )", ">="), ("comparison", r"(?<= )>=(?= )", ">"),
    ("comparison", r"(?<= )==(?= )", "!="), ("comparison", r"(?<= )!=(?= )", "=="),
    ("flag", r"(?<= )&&(?= )", "||"), ("flag", r"(?<= )\|\|(?= )", "&&"), ("flag", r"\btrue\b", "false"),
    ("flag", r"\bfalse\b", "true"),
    ("offset", r"(?<=[\w)\]])( [+-] \d+)\b(?!\.)", ""), ("offset", r"(?<=[\w)\]] )\+(?= [\w(*])", "-"),
    ("offset", r"(?<=[\w)\]] )-(?= [\w(*])", "+"),
    ("sub-iteration", r"(?<=[<\[])sub(?=[>\]])", "(sub == 0 ? 1 : 0)"),
    ("sub-iteration", r"(?<=\* )sub\b", "(sub + 1)"))


@dataclass(frozen=True)
class Mutation:
    """`before` is at (line, column), counted from 1 and 0."""

    operator: str
    line: int
    column: int
    before: str
    after: str

    def apply(self, text: str) -> str:
        """The text with this change."""
        lines = text.split("\n")
        line = lines[self.line - 1]
        end = self.column + len(self.before)
        assert line[self.column:end] == self.before
        lines[self.line - 1] = line[:self.column] + self.after + line[end:]
        return "\n".join(lines)


def mutations(text: str) -> list[Mutation]:
    """All mutations of a file, by position."""
    found: list[Mutation] = []
    originals = text.split("\n")
    before = ";"
    for number, line in enumerate(_code(text).split("\n"), 1):
        if not SKIPPED.search(line):
            changes = list(_of_line(line)) + (_dropped_statement(line) if before[-1] in ";{}:)" else [])
            found += [Mutation(operator, number, *change) for operator, change in changes
                      if originals[number - 1].startswith(change[1], change[0])]  # nothing hidden within
        before = line.rstrip() or before
    return found


def _code(text: str) -> str:
    """The text with blanks in place of what is hidden."""
    return HIDDEN.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


Change = tuple[int, str, str]  # column, before, after


def _of_line(line: str) -> Iterator[tuple[str, Change]]:
    for operator, pattern, after in PATTERNS:
        for match in re.finditer(pattern, line):
            group = 1 if match.re.groups else 0
            yield operator, (match.start(group), match[group], after)
    for match in re.finditer(r"(?<=[.:])n([0-7])\b", line):
        yield "neighbour", (match.start(), match[0], f"n{(int(match[1]) + 2) % 8}")
    for match in re.finditer(r"\b(west|east|above|below|north|south)(?=\b|_|\d)", line):
        yield "neighbour", (match.start(), match[0], NEIGHBOURS[match[0]])
    for match in re.finditer(r"(?<![\w.<'])(0x)?([0-9A-Fa-f]+)(?=U?\b)(?![\w]*\.\d|')", line):
        yield from _of_literal(match)
    yield from _negated_condition(line)


def _dropped_statement(line: str) -> list[tuple[str, Change]]:
    match = STATEMENT.match(line)
    if not match or NO_STATEMENT.match(line):
        return []
    return [("statement", (match.start(1), match[1], ";"))]


def _of_literal(match: re.Match[str]) -> Iterator[tuple[str, Change]]:
    if match[1]:
        changed = f"0x{int(match[2], 16) ^ 1:0{len(match[2])}X}"
        yield "constant", (match.start(), match[0], changed)
    elif match[2].isdecimal():
        yield "number", (match.start(), match[0], str(int(match[2]) + 1))


def _negated_condition(line: str) -> Iterator[tuple[str, Change]]:
    start = line.find("if (")
    if start < 0:
        return
    first, depth = start + 4, 1
    for end in range(first, len(line)):
        depth += {"(": 1, ")": -1}.get(line[end], 0)
        if depth == 0:
            condition = line[first:end]
            yield "flag", (first, condition, f"!({condition})")
            return
