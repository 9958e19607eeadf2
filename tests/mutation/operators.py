"""Mutations of C++ text: small changes, each of which should make a test fail."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

# Comments, text, attributes and template heads decide no pixel.
HIDDEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![\w])'(?:\\.|[^'\\\n])+'"""
                    r"""|\[\[.*?\]\]|__attribute__\(\(\w+\)\)|\btemplate <[^\n]*""", re.DOTALL)
# Nor do preprocessing, declarations of types, prefetching, reserving memory and the words of errors.
SKIPPED = re.compile(r"^\s*(#|using |namespace |static_assert|throw |struct |class |enum |friend |operator)"
                     r"|prefetch|\breserve\(|\bthrow\b|\bstatic_assert\b|\bbool kHas")
STATEMENT = (r"^\s*(?!(?:return|break|continue|case|default|static_cast<void>|const|auto|else)\b)"
             r"((?:\+\+|--)?[\w.\->\[\]:*]+(?:\([^;]*\)|(?: [|&^+\-]?=| <<=| >>=) [^;]*"
             r"|\[[^;]*\] [|&^+\-]?= [^;]*)?;)$")
CONDITION = r"[^()]*"
for _ in range(4):  # parentheses within parentheses
    CONDITION = rf"(?:[^()]|\({CONDITION}\))*"

EXCHANGED = {
    "gate": {"&": "|", "|": "&", "^": "|", "&=": "|=", "|=": "&=", "^=": "|="},
    "shift": {"<<": ">>", ">>": "<<", "<<=": ">>=", ">>=": "<<="},
    "comparison": {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="},
    "flag": {"&&": "||", "||": "&&"}}
NEIGHBOURS = {"west": "east", "east": "west", "above": "below", "below": "above", "north": "south",
              "south": "north"}

# Operator, what to find, and what to put in its place; the group is replaced, if there is one.
PATTERNS: tuple[tuple[str, str, str | Callable[[str], str]], ...] = (
    *((operator, rf"(?<= ){re.escape(before)}(?= |$)", after)
      for operator, pairs in EXCHANGED.items() for before, after in pairs.items()),
    ("gate", r"(?<!::)~(?=[\w(])(?!\w+\(\) (?:= default|override|\{))", ""),
    ("flag", r"\btrue\b", "false"), ("flag", r"\bfalse\b", "true"),
    ("flag", rf"\bif \(({CONDITION})\)", "!({})".format),
    ("offset", r"(?<=[\w)\]])( [+-] \d+)\b(?!\.)", ""), ("offset", r"(?<=[\w)\]] )\+(?= [\w(*])", "-"),
    ("offset", r"(?<=[\w)\]] )-(?= [\w(*])", "+"),
    ("sub-iteration", r"(?<=[<\[])sub(?=[>\]])", "(sub == 0 ? 1 : 0)"),
    ("sub-iteration", r"(?<=\* )sub\b", "(sub + 1)"),
    ("neighbour", r"(?<=[.:]n)[0-7]\b", lambda number: str((int(number) + 2) % 8)),
    ("neighbour", rf"\b(?:{'|'.join(NEIGHBOURS)})(?=\b|_|\d)", NEIGHBOURS.__getitem__),
    ("constant", r"(?<![\w.<'])0x([0-9A-Fa-f]+)(?=U?\b)(?!\w*\.\d|')",
     lambda digits: f"{int(digits, 16) ^ 1:0{len(digits)}X}"),
    ("number", r"(?<![\w.<'])\d+(?=U?\b)(?!\w*\.\d|')", lambda number: str(int(number) + 1)),
    ("statement", STATEMENT, ";"))


@dataclass(frozen=True)
class Mutation:
    """Another text in place of that of a line, counted from 1; without indentation."""

    operator: str
    line: int
    before: str
    after: str

    def apply(self, text: str) -> str:
        """The text with this change."""
        lines = text.split("\n")
        assert self.before in lines[self.line - 1]
        lines[self.line - 1] = lines[self.line - 1].replace(self.before, self.after)
        return "\n".join(lines)


def mutations(text: str) -> list[Mutation]:
    """All mutations of a file, by line."""
    found: list[Mutation] = []
    code = HIDDEN.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    previous = ";"  # line with code
    for number, (line, shown) in enumerate(zip(text.split("\n"), code.split("\n"), strict=True), 1):
        for operator, pattern, after in PATTERNS if not SKIPPED.search(shown) else ():
            if operator == "statement" and previous[-1] not in ";{}:)":
                continue
            for match in re.finditer(pattern, shown):
                first, end = match.span(match.re.groups)
                before = line[first:end]
                if before == shown[first:end]:  # nothing hidden within
                    new = after(before) if callable(after) else after
                    found.append(Mutation(operator, number, line.strip(), (line[:first] + new + line[end:]).strip()))
        previous = shown.rstrip() or previous
    return found
