"""An object file compiled for an ISA may export a symbol only if the name of the symbol carries the ISA: any other
symbol could be linked into code that runs on processors without the ISA. And the libraries that users link define nothing
of what the study compares them with."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

# Sanitizers and counters inhibit inlining, so xsimd's functions without the ISA in their names stay visible.
if "THINBENCH_BUILD" not in os.environ:
    pytest.skip("THINBENCH_BUILD is not set: a build with sanitizers or counters", allow_module_level=True)
KERNELS = Path(os.environ["THINBENCH_BUILD"], "kernels")
ISAS = ("baseline", "sse42", "avx2", "avx512", "avx512icl")
"""In the order of enum Isa."""


def symbols(files: list[Path], *options: str) -> set[tuple[str, str]]:
    """Kinds and names, as nm has them."""
    lines = subprocess.run(["nm", "--defined-only", *options, *files], check=True, text=True,
                           capture_output=True).stdout.splitlines()
    return {(words[1], words[2]) for line in lines if len(words := line.split()) == 3}


def objects(isa: str) -> list[Path]:
    return [path for directory in (KERNELS / "CMakeFiles" / f"thinbench_{isa}.dir",
                                   KERNELS / "techniques" / "CMakeFiles" / f"thinbench_techniques_{isa}.dir")
            for path in directory.rglob("*.o")]


@pytest.mark.parametrize("isa", ISAS)
def test_object_files_of_an_isa_define_no_symbol_that_could_leak(isa: str) -> None:
    files = objects(isa)
    assert len(files) >= 5 and {path.name for path in files} <= {path.name for path in objects(ISAS[0])}
    own = re.compile(rf"IsaE{ISAS.index(isa)}E|6detail{len(isa)}{isa}[0-9]|^DW\.ref\.")
    assert [name for _, name in symbols(files, "--extern-only") if not own.search(name)] == []


@pytest.mark.parametrize("library", ["libthinbench.a", "libthinbench.so"])
def test_a_library_that_users_link_has_no_symbol_of_techniques(library: str) -> None:
    archive = KERNELS / "techniques" / "libthinbench_techniques.a"
    techniques = {name for kind, name in symbols([archive], "--extern-only") if kind in "TDRB"}
    defined = {name for kind, name in symbols([KERNELS / library]) if kind in "TtDdRrBb" and "9thinbench" in name}
    assert len(techniques) >= 50 and defined and techniques & defined == set()
