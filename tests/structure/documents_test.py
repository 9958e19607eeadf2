"""Files, directories and tests that documents and suppressions name exist, and a function has one name in C++, C and
Python, but for the rows of a table in docs/library.md."""

from __future__ import annotations

import ast
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


LANGUAGES = ["C++", "C", "Python"]
HEADERS = sorted((ROOT / "kernels" / "include" / "thinbench").glob("*.hpp"))
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def text_of(*paths: Path) -> str:
    return "\n".join(COMMENT.sub("", path.read_text(encoding="utf-8")) for path in paths)


SOURCES = {"C++": text_of(*HEADERS), "C": text_of(ROOT / "kernels" / "include" / "thinbench.h"),
           "Python": "\n".join(path.read_text(encoding="utf-8")
                               for path in sorted((ROOT / "python" / "thinbench").glob("*.py")))}


def public_names() -> set[str]:
    """The __all__ of the package, without types and constants."""
    tree = ast.parse((ROOT / "python" / "thinbench" / "__init__.py").read_text(encoding="utf-8"))
    (names,) = (ast.literal_eval(node.value) for node in tree.body
                if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__")
    return {name for name in names if name.islower()}


FUNCTIONS = {"C++": set(re.findall(r"(?<!class )\bTHINBENCH_API\s[^;{}()]*?(\w+)\(", SOURCES["C++"])),
             "C": set(re.findall(r"\bthinbench_(\w+)\(", SOURCES["C"])),
             "Python": public_names()}


def rows() -> list[list[str]]:
    """Of the table: words in C++, C and Python, and the reason."""
    document = (ROOT / "docs" / "library.md").read_text(encoding="utf-8")
    section = document.partition("\n## One name in three languages\n")[2].partition("\n## ")[0]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line[:1] == "|"]
    return cells[2:]


def listed(language: str) -> set[str]:
    column = LANGUAGES.index(language)
    return {word for row in rows() for word in re.findall(r"`([^`]+)`", row[column])}


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_function_is_in_all_three_languages_or_in_the_table(language):
    assert len(FUNCTIONS[language]) > 30
    missing = FUNCTIONS[language] - set.intersection(*FUNCTIONS.values()) - listed(language)
    assert not missing, f"of {language}, neither in the other languages nor in docs/library.md: {sorted(missing)}"


@pytest.mark.parametrize("language", LANGUAGES)
def test_words_of_the_table_exist(language):
    words = {word: re.split(r"::|\.", word)[-1] for word in listed(language)}
    prefix = "(?:thinbench_|THINBENCH_)" if language == "C" else ""
    assert [word for word, last in words.items() if not re.search(rf"\b{prefix}{last}\b", SOURCES[language])] == []


def test_rows_of_the_table_have_a_reason_or_are_constants():
    assert len(rows()) > 20
    assert [row for row in rows() if len(row) != 4 or not (row[3] or all(row[:3]))] == []
