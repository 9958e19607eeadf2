"""Directories of kernels/, tools/ and bench/ include each other only in the allowed directions; references and tools
include little of the kernels."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

# The directories of kernels/ that each directory may include besides itself; "include" is the
# public headers.
BASE = {"include", "core", "simd"}
RULES = BASE | {"rules"}
SCAN = RULES | {"scan"}
COMPILE = SCAN | {"compile"}
ENGINES = COMPILE | {"engines"}
ALLOWED = {
    "include": set(),
    "simd": {"include"},
    "core": {"include", "simd"},
    "rules": BASE,
    "scan": RULES,
    "compile": SCAN,
    "engines": COMPILE,
    "midpoints": ENGINES,
    "thinning": ENGINES,
    "binarise": BASE,
    "edges": BASE,
    "regions": BASE,
    "localise": BASE | {"edges", "regions"},
    "distance": BASE,
    "graph": BASE,
    "path": BASE,
}
PRODUCT = set(ALLOWED)
ALLOWED["api"] = PRODUCT
ALLOWED["techniques"] = PRODUCT

# The directories of tools/ and bench/ that each of theirs may include besides itself.
FILES = {"tools/support", "tools/rules", "tools/images"}
ROWS = {"tools/support", "bench/harness"}
MEASURE = FILES | ROWS | {"tools/cli", "bench/machine", "bench/peers", "bench/scene"}
PROGRAMS = {
    "tools/support": set(),
    "tools/rules": {"tools/support"},
    "tools/images": {"tools/support"},
    "tools/batch": {"tools/support", "tools/images"},
    "tools/cli": FILES | {"tools/batch"},
    "bench/machine": set(),
    "bench/harness": {"tools/support"},
    "bench/peers": ROWS,
    "bench/scene": ROWS,
    "bench/training": ROWS | {"tools/rules"},
    "bench/measure": MEASURE,
    "bench/counts": ROWS | {"bench/machine", "bench/measure"},
    "bench/experiments": FILES | ROWS | {"bench/scene", "bench/training"},
    "bench/study": MEASURE | {"bench/counts", "bench/experiments", "bench/measure", "bench/training"},
}

# Files that references share with the kernels besides the public headers: data only.
SHARED_WITH_REFERENCES = {"rules/trained_cluster.hpp"}

# Files of kernels/ that tools/ uses besides the public headers.
SHARED_WITH_TOOLS = {
    "binarise/bright_pixels.hpp",
    "core/byte_image.hpp",
    "core/startable_threads.hpp",
}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


@dataclass(frozen=True)
class Include:
    file: str  # relative to the project
    line: int
    target: str  # as written in the file

    def __str__(self) -> str:
        return f"{self.file}:{self.line} includes {self.target}"


def sources(directory: Path) -> list[Path]:
    return sorted(path for path in directory.rglob("*") if path.suffix in {".hpp", ".cpp", ".h"})


def includes_of(root: Path, directory: str) -> list[Include]:
    """All #include lines in a directory. Targets in angle brackets keep the brackets."""
    found = []
    for path in sources(root / directory):
        for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(text)
            if match:
                target = match.group(1) or f"<{match.group(2)}>"
                found.append(Include(path.relative_to(root).as_posix(), number, target))
    return found


def directory_of_target(target: str) -> str:
    """The directory of kernels/ that a quoted include refers to."""
    directory = target.split("/")[0] if "/" in target else target
    return "include" if directory in {"thinbench", "thinbench.h"} else directory


def violations_in_kernels(root: Path) -> list[str]:
    found = []
    for one in includes_of(root, "kernels"):
        directory = one.file.removeprefix("kernels/").split("/")[0]
        if one.target.startswith("<thinbench"):
            found.append(f"{one}, which must be quoted")
        if one.target.startswith("<"):
            continue
        target = directory_of_target(one.target)
        if directory not in ALLOWED:
            found.append(f"{one}, but kernels/{directory} is not in the table of this test")
        elif target != directory and target not in ALLOWED[directory]:
            found.append(f"{one}, but kernels/{directory} may not include {target}")
    return found


def violations_in_programs(root: Path) -> list[str]:
    found = []
    for one in [*includes_of(root, "tools"), *includes_of(root, "bench")]:
        directory = one.file.rpartition("/")[0]
        targets = {f"{tree}/{one.target}".rpartition("/")[0] for tree in ("tools", "bench")
                   if (root / tree / one.target).is_file()}
        allowed = PROGRAMS.get(directory, set()) | {directory}
        found.extend(f"{one}, but {directory} may not include {target}" for target in sorted(targets - allowed))
    return found


def violations_in_references(root: Path) -> list[str]:
    own = {path.relative_to(root / "reference").as_posix() for path in sources(root / "reference")}
    found = []
    for one in includes_of(root, "reference"):
        is_standard = one.target.startswith("<") and "/" not in one.target and "." not in one.target
        is_public = one.target.startswith("thinbench/")
        if not (is_standard or is_public or one.target in own | SHARED_WITH_REFERENCES):
            found.append(f"{one}, which is neither a public header nor a reference's own")
    return found


def foreign_includes_of_tools(root: Path) -> list[Include]:
    """Quoted includes of files that are neither in tools/ nor public headers."""
    own = {path.relative_to(root / "tools").as_posix() for path in sources(root / "tools")}
    return [one for one in includes_of(root, "tools")
            if not one.target.startswith(("<", "thinbench/")) and one.target not in own]


def includes_by_file(root: Path) -> dict[str, list[str]]:
    """For each file of kernels/, the files of kernels/ that it includes."""
    graph: dict[str, list[str]] = {}
    for one in includes_of(root, "kernels"):
        targets = [f"kernels/{one.target}", f"kernels/include/{one.target}"]
        existing = [target for target in targets if (root / target).is_file()]
        graph.setdefault(one.file, []).extend(existing)
    return graph


def cycle_in(graph: Mapping[str, Iterable[str]]) -> list[str]:
    """A cycle of includes, with its first file repeated at the end; empty if there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1][::-1])
    return []


@pytest.mark.parametrize("table", [ALLOWED, PROGRAMS], ids=["kernels", "programs"])
def test_table_has_no_cycle(table):
    assert cycle_in({directory: allowed - {directory} for directory, allowed in table.items()}) == []


def test_table_has_exactly_the_existing_directories():
    assert {path.name for path in (ROOT / "kernels").iterdir() if path.is_dir()} == set(ALLOWED)
    programs = {path.parent.relative_to(ROOT).as_posix() for tree in ("tools", "bench") for path in sources(ROOT / tree)}
    assert programs == set(PROGRAMS)


@pytest.mark.parametrize("violations", [
    violations_in_kernels, violations_in_programs, violations_in_references,
    lambda root: cycle_in(includes_by_file(root))], ids=["kernels", "programs", "references", "cycle"])
def test_files_include_in_the_allowed_directions(violations):
    assert "\n".join(violations(ROOT)) == ""


def test_what_references_share_with_the_kernels_includes_public_headers_alone():
    for shared in SHARED_WITH_REFERENCES:
        for one in includes_of(ROOT, "kernels/" + shared.split("/")[0]):
            if one.file == "kernels/" + shared:
                assert one.target.startswith("thinbench/"), str(one)


def test_tools_share_only_public_headers_and_a_few_others_with_the_kernels():
    assert {one.target for one in foreign_includes_of_tools(ROOT)} == SHARED_WITH_TOOLS


@pytest.mark.parametrize(("violations", "files", "expected"), [
    (violations_in_kernels, {
        "kernels/core/planes.hpp": '// Planes.\n#include "core/layout.hpp"\n  #  include "thinning/many.hpp"\n',
        "kernels/api/rule.cpp": '#include "techniques/variants.hpp"\n',
        "kernels/edges/state.cpp": '#include "reference.hpp"\n#include "bench/job.hpp"\n'}, [
        "kernels/api/rule.cpp:1 includes techniques/variants.hpp, but kernels/api may not include techniques",
        "kernels/core/planes.hpp:3 includes thinning/many.hpp, but kernels/core may not include thinning",
        "kernels/edges/state.cpp:1 includes reference.hpp, but kernels/edges may not include reference.hpp",
        "kernels/edges/state.cpp:2 includes bench/job.hpp, but kernels/edges may not include bench"]),
    (violations_in_programs, {
        "tools/cli/words.hpp": "", "bench/harness/job.hpp": "",
        "tools/images/read.cpp": '#include "cli/words.hpp"\n#include "core/words.hpp"\n#include "harness/job.hpp"\n'}, [
        "tools/images/read.cpp:1 includes cli/words.hpp, but tools/images may not include tools/cli",
        "tools/images/read.cpp:3 includes harness/job.hpp, but tools/images may not include bench/harness"]),
    (lambda root: cycle_in(includes_by_file(root)), {
        "kernels/core/a.hpp": '#include "core/b.hpp"\n',
        "kernels/core/b.hpp": '#include "core/c.hpp"\n#include "core/d.hpp"\n',
        "kernels/core/c.hpp": "", "kernels/core/d.hpp": '#include "core/a.hpp"\n'},
     [f"kernels/core/{name}.hpp" for name in "abd"])],
    ids=["wrong direction", "wrong direction of programs", "cycle"])
def test_what_is_not_allowed_is_reported_with_file_line_and_include(tmp_path, violations, files, expected):
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    assert sorted(set(violations(tmp_path))) == expected
