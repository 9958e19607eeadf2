"""Files and directories that documents and suppressions name exist."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TOP = "kernels|tools|bench|reference|tests|report|python|cmake|docs|results"
NAMED = re.compile(rf"(?<![\w/.<-])(?:{TOP})/(?:[\w.-]+/)*[\w.-]*\w|\]\(([\w./-]+)(?:#[\w-]*)?\)")
WRITTEN = {"results/baselines"}  # by the user's own runs
DOCUMENTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("report/*.md")])


def missing(document: Path, text: str) -> list[str]:
    """Paths from the root, and links from the document, that lead nowhere."""
    found = []
    for match in NAMED.finditer(text):
        path = document.parent / match[1] if match[1] else ROOT / match[0]
        if not path.exists() and match[0] not in WRITTEN:
            found.append(match[1] or match[0])
    return found


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_paths_and_links_of_documents_exist(document: Path) -> None:
    assert missing(document, document.read_text(encoding="utf-8")) == []


def test_sources_of_suppressions_exist() -> None:
    """One that names a file that was moved hides nothing, which shows in another build only."""
    lines = (ROOT / "tests" / "tsan.supp").read_text(encoding="utf-8").splitlines()
    named = [line.partition(":")[2] for line in lines if line.endswith(".cpp")]
    assert named and [name for name in named if not (ROOT / "kernels" / name).exists()] == []


def absent_tests(table: str) -> list[str]:
    """Names in backticks that no test, fuzz target or add_test has."""
    sources = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("*")
                      if path.suffix in {".cpp", ".py", ".txt"})
    known = {f"{suite}.{name}" for suite, name in
             re.findall(r"\bTEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", sources)}
    for pattern in (r"\bdef (test_\w+)\(", r"\bNAME (\w+)", r"thinbench_fuzz\((\w+)"):
        known |= set(re.findall(pattern, sources))
    return [name for name in re.findall(r"`([\w.]+)`", table) if name not in known]


def test_tests_that_security_names_exist() -> None:
    text = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
    table = text.partition("## Which test shows it")[2].partition("\n## ")[0]
    assert table.count("\n|") > 8 and absent_tests(table) == []
