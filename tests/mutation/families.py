"""The parts of the kernels that decide pixels, and the tests that should notice a change in them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path


@dataclass(frozen=True)
class Check:
    """A test program, or some of its tests; {stem} stands for the name of the mutated file."""

    program: str
    tests: str = "*"
    variables: tuple[tuple[str, str], ...] = ()  # of the environment

    def of(self, file: str) -> Check:
        """The same for one file."""
        return replace(self, tests=self.tests.replace("{stem}", Path(file).stem))


@dataclass(frozen=True)
class Family:
    """`sources` are patterns of files in kernels/. `checks` take seconds and notice most mutants; the
    `thorough` ones are for those that survive."""

    name: str
    sources: tuple[str, ...]
    checks: tuple[Check, ...]
    thorough: tuple[Check, ...]

    def files(self, kernels: Path) -> list[str]:
        """The sources, relative to `kernels`."""
        found = {path for pattern in self.sources for path in kernels.glob(pattern)}
        return sorted(str(path.relative_to(kernels)) for path in found)


def crosscheck(*operations: str, images: str = "*") -> Check:
    """Every variant against its reference."""
    return Check("crosscheck_test", ":".join(f"*/{operation}_on_{images}" for operation in operations))


# Rules of one and two stages, with and without borders, stand for all where the code is not a rule.
SOME = ("thin_guo_hall", "thin_guo_hall_keep", "thin_mb2", "thin_mb2_keep")
GOLDEN = Check("golden_test", "*outputs_equal*")
API = Check("api_test")
CORE = Check("core_test", "-Isa*")  # those tests need every ISA
DISTANCE = Check("distance_test")
EDGES = Check("edges_test")
GRAPH = Check("graph_test")
LOCALISE = Check("localise_test")
TECHNIQUES = Check("techniques_test")
REGIONS = Check("regions_test")
SCAN = Check("scan_test")
SOME_TABLES = Check("engines_test", "*RandomRules*variant/1:*lanes/1:BuiltIn*:Lanes*:SmallImages*")
INTERPRETED = Check("engines_test", "*RandomRules*variant/1:BuiltIn*", (("THINBENCH_MACHINE_CODE", "off"),))
COMPILE = Check("compile_test", "-ThoroughSearch*")
TILE_GRID = Check("engines_test", "TileGrid*")
ITERATE = Check("engines_test", "*Iterate*:*Tile*:*State*-*threads*")
SIZES = Check("thinning_test", "*at_every_size*/guo_hall_border_keep:*at_every_size*/mb2_border_background")
SOME_THINNING = (crosscheck(*SOME, images="sheets"), crosscheck(*SOME, images="shapes"), GOLDEN, SIZES)
THINNING = (Check("thinning_test"), Check("engines_test"), crosscheck("thin_*"), COMPILE, API)

FAMILIES = (
    Family("rules", ("rules/built_in/*.hpp",),
           (Check("rules_test"), crosscheck("thin_{stem}", "thin_{stem}_keep", images="shapes"), GOLDEN), THINNING),
    Family("tables", ("rules/*",), (Check("rules_test"), TECHNIQUES, GOLDEN), (*THINNING, crosscheck("net_*"))),
    Family("scans", ("scan/*",), (*SOME_THINNING, SOME_TABLES), THINNING),
    Family("planes", ("engines/words.hpp", "engines/iterate.*", "engines/plane_state.hpp"),
           (*SOME_THINNING, ITERATE), (*THINNING, crosscheck("net_*"))),
    Family("rows", ("engines/rows.cpp",), (*SOME_THINNING, SOME_TABLES), (*THINNING, crosscheck("net_*"))),
    Family("tiles", ("engines/tile_*", "engines/iterate_tiles.*"), (*SOME_THINNING, ITERATE, SOME_TABLES), THINNING),
    Family("lanes", ("engines/lane*", "thinning/batch.cpp"),
           (crosscheck("batch_*"), Check("thinning_test", "*Batch*"), SOME_TABLES), (API, *THINNING)),
    Family("spta", ("engines/spta*",), (crosscheck("thin_spta", "thin_spta_keep", images="sh*"), GOLDEN,
                                       Check("thinning_test", "*/spta_border*")), THINNING),
    Family("midpoints", ("midpoints/*",), (crosscheck("skeleton_scan*", images="sheets"), SCAN, GOLDEN),
           (crosscheck("skeleton_scan*"), API)),
    Family("techniques", ("techniques/*",),
           (TECHNIQUES, *SOME_THINNING, crosscheck("net_*_1", images="sheets"), SCAN, REGIONS),
           (*THINNING, EDGES, DISTANCE, GRAPH, crosscheck("net_*"))),
    Family("edges", ("edges/*",), (EDGES, LOCALISE, crosscheck("edges_*"), GOLDEN, Check("api_test", "*dges*")),
           (API,)),
    Family("regions", ("regions/*",), (REGIONS, GOLDEN, LOCALISE),
           (crosscheck("components", "euler_number*", "fill_holes", "holes", "label_*"), API)),
    Family("localise", ("localise/*",), (LOCALISE, crosscheck("localise_*"), GOLDEN), (API,)),
    Family("distance", ("distance/*",), (DISTANCE, crosscheck("squared_distances", images="sh*")),
           (crosscheck("squared_distances"), API)),
    Family("graph", ("graph/*",), (GRAPH, crosscheck("skeleton_graph", images="sh*")),
           (crosscheck("skeleton_graph"), API)),
    Family("compile", ("compile/*",), (COMPILE, SOME_TABLES, INTERPRETED),
           (Check("engines_test"), crosscheck("apply_*"), GOLDEN)),
    Family("core", ("core/byte_image.cpp", "core/packed_rows.cpp", "core/packing.cpp"),
           (CORE, LOCALISE, GOLDEN, Check("api_test", "*Pack*:*pack*"), SIZES), (*THINNING, EDGES, SCAN)),
    Family("simd", ("simd/*",), (CORE, EDGES, TECHNIQUES, SCAN, LOCALISE, TILE_GRID, *SOME_THINNING),
           (*THINNING, REGIONS, crosscheck("net_*"))),
    Family("lists", ("thinning/canvases.*", "thinning/labels.cpp", "thinning/many.cpp"),
           (Check("thinning_test", "*ThinMany*:*ThinLabels*:*Layouts*"),), (Check("thinning_test"), API)),
    Family("api", ("api/edges.cpp", "api/localise.cpp", "api/regions.cpp", "api/rule.cpp", "api/thinning.cpp",
                   "thinning/operations.cpp"),
           (API, REGIONS), (SOME_TABLES, Check("thinning_test"), LOCALISE, GOLDEN)),
)


def programs(families: Iterable[Family]) -> list[str]:
    """Their test programs."""
    return sorted({check.program for family in families for check in family.checks + family.thorough})
