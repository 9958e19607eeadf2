"""Directories of kernels/, tools/, bench/ and reference/ include each other only in the allowed directions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
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
KERNELS = {
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
PRODUCT = set(KERNELS)
KERNELS |= {"api": PRODUCT, "techniques": PRODUCT}

# The directories of tools/ and bench/ that each of theirs may include besides itself.
FILES = {"tools/support", "tools/rules", "tools/images"}
ROWS = {"tools/support", "bench/harness"}
MEASURE = FILES | ROWS | {"tools/cli", "bench/peers", "bench/scene"}
PROGRAMS = {
    "tools/support": set(),
    "tools/rules": {"tools/support"},
    "tools/images": {"tools/support"},
    "tools/batch": {"tools/support", "tools/images"},
    "tools/cli": FILES | {"tools/batch"},
    "bench/harness": {"tools/support"},
    "bench/peers": ROWS,
    "bench/scene": ROWS,
    "bench/training": ROWS | {"tools/rules"},
    "bench/measure": MEASURE,
    "bench/counts": ROWS | {"bench/measure"},
    "bench/experiments": FILES | ROWS | {"bench/scene", "bench/training"},
    "bench/study": MEASURE | {"bench/counts", "bench/experiments", "bench/measure", "bench/training"},
}
PUBLIC = {"kernels/include"}
ALLOWED = {f"kernels/{name}": {f"kernels/{other}" for other in others} for name, others in KERNELS.items()}
OF_PROGRAMS = {"tools": PUBLIC, "bench": {*ALLOWED, "reference"}}
ALLOWED |= {name: others | OF_PROGRAMS[name.split("/")[0]] for name, others in PROGRAMS.items()} | {"reference": PUBLIC}

# Files of kernels/ that tools use besides.
SHARED = {"kernels/binarise/bright_pixels.hpp", "kernels/core/byte_image.hpp", "kernels/core/startable_threads.hpp"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|(<[^>]+>))')


@dataclass(frozen=True)
class Include:
    file: str  # relative to the project, as is the target of a quoted include that is found
    line: int
    text: str
    target: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line} includes {self.text}"


def found(root: Path, file: Path, text: str) -> str:
    """The file that is meant, which may be one that the build makes in the same tree."""
    for place in (file.parent, *(root / name for name in ("kernels/include", "kernels", "tools", "bench", "reference"))):
        if (place / text).is_file():
            return (place / text).relative_to(root).as_posix()
    return f"{file.relative_to(root).parts[0]}/{text}"


def includes(root: Path) -> Iterator[Include]:
    for tree in ("kernels", "tools", "bench", "reference"):
        for path in sorted(path for path in (root / tree).rglob("*") if path.suffix in {".hpp", ".cpp", ".h"}):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
                if match := INCLUDE.match(line):
                    text = match[1] or match[2]
                    yield Include(path.relative_to(root).as_posix(), number, text, found(root, path, text))


def directory_of(file: str) -> str:
    return "/".join(file.split("/")[:-1][:2])


def violations(root: Path) -> Iterator[str]:
    for one in includes(root):
        directory, target = directory_of(one.file), directory_of(one.target)
        tree = directory.split("/")[0]
        if one.text.startswith("<"):
            is_standard = "/" not in one.text and "." not in one.text
            if one.text.startswith("<thinbench") or directory == "reference" and not is_standard:
                yield f"{one}, which is neither of the standard library nor quoted"
        elif target not in {directory, *ALLOWED[directory]} and (tree != "tools" or one.target not in SHARED):
            yield f"{one}, but {directory} may not include {target}"


def cycle_in(graph: Mapping[str, Iterable[str]]) -> list[str]:
    """The first is repeated at the end; empty if there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1][::-1])
    return []


def cycle_of_includes(root: Path) -> list[str]:
    graph: dict[str, set[str]] = {}
    for one in includes(root):
        graph.setdefault(one.file, set()).add(one.target)
    return cycle_in(graph)


def test_table_has_exactly_the_existing_directories_and_no_cycle():
    assert {directory_of(one.file) for one in includes(ROOT)} == set(ALLOWED)
    assert cycle_in({directory: allowed - {directory} for directory, allowed in ALLOWED.items()}) == []


def test_files_include_in_the_allowed_directions_and_without_cycles():
    assert "\n".join(violations(ROOT)) == ""
    assert " -> ".join(cycle_of_includes(ROOT)) == ""


def test_what_tools_share_with_the_kernels_is_used():
    assert SHARED <= {one.target for one in includes(ROOT) if one.file.startswith("tools/")}


@pytest.mark.parametrize(("check", "files", "expected"), [
    (violations, {
        "kernels/thinning/many.hpp": "#include <thinbench/rule.hpp>\n#include <vector>\n", "reference/reference.hpp": "",
        "kernels/core/planes.hpp": '// Planes.\n#include "core/layout.hpp"\n  #  include "thinning/many.hpp"\n',
        "kernels/core/layout.hpp": "", "bench/harness/job.hpp": '#include "reference.hpp"\n',
        "kernels/edges/state.cpp": '#include "reference.hpp"\n#include "absent.hpp"\n',
        "tools/cli/words.hpp": "", "tools/images/read.cpp": '#include "cli/words.hpp"\n#include "harness/job.hpp"\n',
        "reference/thin.cpp": '#include "core/planes.hpp"\n#include <xsimd/xsimd.hpp>\n#include <vector>\n'}, [
        "kernels/core/planes.hpp:3 includes thinning/many.hpp, but kernels/core may not include kernels/thinning",
        "kernels/edges/state.cpp:1 includes reference.hpp, but kernels/edges may not include reference",
        "kernels/edges/state.cpp:2 includes absent.hpp, but kernels/edges may not include kernels",
        "kernels/thinning/many.hpp:1 includes <thinbench/rule.hpp>, which is neither of the standard library nor quoted",
        "reference/thin.cpp:1 includes core/planes.hpp, but reference may not include kernels/core",
        "reference/thin.cpp:2 includes <xsimd/xsimd.hpp>, which is neither of the standard library nor quoted",
        "tools/images/read.cpp:1 includes cli/words.hpp, but tools/images may not include tools/cli",
        "tools/images/read.cpp:2 includes harness/job.hpp, but tools/images may not include bench/harness"]),
    (cycle_of_includes, {
        "kernels/core/a.hpp": '#include "core/b.hpp"\n',
        "kernels/core/b.hpp": '#include "core/c.hpp"\n#include "core/d.hpp"\n',
        "kernels/core/c.hpp": "", "kernels/core/d.hpp": '#include "core/a.hpp"\n'},
     [f"kernels/core/{name}.hpp" for name in "abd"])], ids=["wrong direction", "cycle"])
def test_what_is_not_allowed_is_reported_with_file_line_and_include(tmp_path, check, files, expected):
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    assert sorted(set(check(tmp_path))) == expected
