"""Cases: operations with the options that change what they give, as results name them."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cached_property

from report.errors import ReportError
from report.json_fields import Fields

BACKGROUND, KEEP = "background", "keep"
BORDERS = ("", BACKGROUND, KEEP)

NAME = re.compile(r"(?P<operation>[^:]+)(?P<keep>:keep)?(?::(?P<limit>[1-9][0-9]*))?")
OLD_NAME = re.compile(r"(?P<operation>thin_\w+)(?P<keep>_keep_border)|(?P<net>net_\w+)_pass")
"""Runs from before there were cases had operations of their own for them."""

THINNING = ("thin_", "net_", "skeleton_scan")
"""How operations begin that have a border; for runs that do not record it."""

OLD_PEERS_ISA, PEERS_ISA = "own", "native"


@dataclass(frozen=True)
class Case:
    """An operation with its border, "" where it has none, and its limit of iterations."""

    operation: str
    border: str = ""
    max_iterations: int | None = None

    @cached_property
    def name(self) -> str:
        """Unique, such as thin_guo_hall:keep or net_two_layer_linear:1."""
        border = ":keep" if self.border == KEEP else ""
        limit = f":{self.max_iterations}" if self.max_iterations else ""
        return f"{self.operation}{border}{limit}"

    @property
    def stem(self) -> str:
        """The name as it stands in names of files."""
        return file_stem(self.name)

    @property
    def columns(self) -> tuple[str, str]:
        """Border and limit, as tables of values have them beside the operation."""
        return self.border, str(self.max_iterations or "")


def file_stem(case: str) -> str:
    """A case's name as it stands in names of files, where not every system takes a colon."""
    return case.replace(":", "_")


def case_named(name: str, border: str = "") -> Case | None:
    """The case of a unique name, also of an older run, or None; `border` where it is recorded."""
    if old := OLD_NAME.fullmatch(name):
        return Case(old["net"], BACKGROUND, 1) if old["net"] else Case(old["operation"], KEEP)
    match = NAME.fullmatch(name)
    if match is None:
        return None
    assumed = BACKGROUND if match["operation"].startswith(THINNING) else ""
    return Case(match["operation"], KEEP if match["keep"] else border or assumed,
                int(match["limit"]) if match["limit"] else None)


def case_in(fields: Fields) -> Case:
    """The case of an object, or of a line, with operation, border and max_iterations."""
    operation = fields.text("operation")
    if "border" not in fields.data:  # older runs
        return case_named(operation) or Case(operation)
    limit = fields.data.get("max_iterations") or None
    if not re.fullmatch(r"None|[1-9][0-9]*", str(limit)):
        raise ReportError(f"{fields.where}: max_iterations is {limit!r}; it must be a whole number "
                          "above zero or empty")
    return Case(operation, checked_border(fields.data["border"], fields.where),
                int(limit) if limit else None)


def checked_border(border: object, where: str) -> str:
    """What a border may be."""
    if border not in BORDERS:
        raise ReportError(f"{where}: border is {border!r}; it must be {BACKGROUND}, {KEEP} or empty")
    return str(border)


def isa_label(text: str) -> str:
    """The instruction set as it is called now; peers choose theirs at run time."""
    return PEERS_ISA if text == OLD_PEERS_ISA else text


def place_of_peer(case: Case, technique: str) -> Case:
    """The case whose pixels a peer gives: OpenCV's thinning keeps the border, but stood beside the
    cases that do not in older runs."""
    stands_elsewhere = (technique == "opencv" and case.border == BACKGROUND
                        and case.operation in ("thin_zhang_suen", "thin_guo_hall"))
    return replace(case, border=KEEP) if stands_elsewhere else case
