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
    `thorough` ones are for those that survive. Of the files that include a changed header,
    those in `first` are compiled and tested first."""

    name: str
    sources: tuple[str, ...]
    checks: tuple[Check, ...]
    thorough: tuple[Check, ...]
    first: tuple[str, ...] = ()

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
NETS = Check("nets_test")
REGIONS = Check("regions_test")
SCAN = Check("scan_test")
SOME_APPLY = Check("custom_rules_test", "*RandomRules*variant/1:*lanes/1:BuiltIn*:Apply*:SmallImages*")
INTERPRETED = Check("custom_rules_test", "*RandomRules*variant/1:BuiltIn*", (("THINBENCH_MACHINE_CODE", "off"),))
APPLY = Check("custom_rules_test", "-ThoroughSearch*")
TILE_GRID = Check("thinning_test", "TileGrid*")
ITERATE = Check("thinning_test", "*Iterate*:*Tile*:*State*-*threads*")
SIZES = Check("thinning_test", "*at_every_size*/guo_hall_border_keep:*at_every_size*/mb2_border_background")
SOME_THINNING = (crosscheck(*SOME, images="sheets"), crosscheck(*SOME, images="shapes"), GOLDEN, SIZES)
THINNING = (Check("thinning_test"), Check("batch_test"), crosscheck("thin_*"), APPLY, API)
ENGINES = "thinning/engines/"
ITERATION = "thinning/iteration/"

FAMILIES = (
    Family("rules", ("thinning/rules/*.hpp",),
           (crosscheck("thin_{stem}", "thin_{stem}_keep", images="shapes"), GOLDEN), THINNING,
           first=(ENGINES + "bitpacked.cpp", ENGINES + "autovec.cpp", ENGINES + "simd.cpp")),
    Family("planes", (ENGINES + "word_scan.hpp", ENGINES + "lut.cpp", ENGINES + "autovec.cpp",
                      ENGINES + "passes.hpp", ENGINES + "rule_table.hpp", ITERATION + "iterate.*",
                      ITERATION + "pass_state.hpp", ITERATION + "plane_state.hpp"),
           SOME_THINNING + (ITERATE,), THINNING + (crosscheck("net_*"),),
           first=(ENGINES + "bitpacked.cpp", ITERATION + "iterate.cpp", "thinning/variants.cpp")),
    Family("rows", (ENGINES + "row_kernel.*", ITERATION + "row_state.hpp"), (*SOME_THINNING, SOME_APPLY),
           THINNING + (crosscheck("net_*"),)),
    Family("tiles", (ENGINES + "tile_*", ITERATION + "iterate_tiles.*", ITERATION + "tile_state.*"),
           (*SOME_THINNING, ITERATE, SOME_APPLY), THINNING),
    Family("lanes", (ENGINES + "lane_*", ENGINES + "layouts.hpp", "api/batch.cpp"),
           (crosscheck("batch_*"), Check("batch_test"), SOME_APPLY), (API, APPLY)),
    Family("spta", (ENGINES + "spta*",), (crosscheck("thin_spta", "thin_spta_keep", images="sh*"), GOLDEN,
                                              Check("thinning_test", "*/spta_border*")), THINNING),
    Family("midpoints", ("midpoints/*",), (crosscheck("skeleton_scan*", images="sheets"), SCAN, GOLDEN),
           (crosscheck("skeleton_scan*"), API)),
    Family("nets", ("nets/*",), (NETS, GOLDEN, crosscheck("net_*_1", images="sheets")), (crosscheck("net_*"), API)),
    Family("edges", ("edges/*",), (EDGES, LOCALISE, crosscheck("edges_*"), GOLDEN, Check("api_test", "*dges*")),
           (API,)),
    Family("regions", ("regions/*",), (REGIONS, GOLDEN, LOCALISE),
           (crosscheck("components", "euler_number*", "fill_holes", "holes"), API)),
    Family("localise", ("localise/*",), (LOCALISE, crosscheck("localise_*"), GOLDEN), (API,)),
    Family("distance", ("distance/*", "api/distance.cpp"), (DISTANCE, crosscheck("squared_distances", images="sh*")),
           (crosscheck("squared_distances"), API)),
    Family("graph", ("graph/*", "api/graph.cpp", "api/pixel_classes.cpp", "api/polyline.cpp", "api/prune.cpp"),
           (GRAPH, crosscheck("skeleton_graph", images="sh*")), (crosscheck("skeleton_graph"), API),
           first=("graph/bitpacked.cpp",)),
    Family("custom", ("custom/*",), (Check("custom_tables_test"), SOME_APPLY, INTERPRETED),
           (APPLY, crosscheck("apply_*"), GOLDEN)),
    Family("image", ("image/byte_image.cpp", "image/packed_rows.cpp", "image/packing.cpp"),
           (CORE, LOCALISE, GOLDEN, Check("api_test", "*Pack*:*pack*"), SIZES), (*THINNING, EDGES, SCAN)),
    Family("simd", ("simd/*",), (CORE, EDGES, NETS, SCAN, LOCALISE, TILE_GRID, *SOME_THINNING),
           (*THINNING, REGIONS, crosscheck("net_*")),
           first=("image/packing.cpp", ENGINES + "simd.cpp", ENGINES + "tile_layout.cpp", "edges/simd.cpp")),
    Family("api", ("api/canvases.*", "api/catalogue.cpp", "api/custom_rule.cpp", "api/edges.cpp", "api/labels.cpp",
                   "api/localise.cpp", "api/many.cpp", "api/packed.cpp", "api/regions.cpp", "api/thinning.cpp"),
           (API, REGIONS), (SOME_APPLY, Check("batch_test"), LOCALISE, GOLDEN)),
)


def programs(families: Iterable[Family]) -> list[str]:
    """Their test programs."""
    return sorted({check.program for family in families for check in family.checks + family.thorough})
