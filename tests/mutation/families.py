"""The parts of the kernels that decide pixels, and the tests that should notice a change in them.

A check is a test program, then perhaps a filter of its tests and variables of the environment; {stem} stands for the
name of the mutated file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Family:
    """`sources` are patterns of files in kernels/. `checks` take seconds and notice most mutants with one ISA, the
    baseline; the `thorough` ones are for those that survive."""

    name: str
    sources: tuple[str, ...]
    checks: tuple[str, ...]
    thorough: tuple[str, ...]

    def files(self, kernels: Path) -> list[str]:
        """The sources, relative to `kernels`."""
        found = {path for pattern in self.sources for path in kernels.glob(pattern) if path.suffix in (".cpp", ".hpp")}
        return sorted(str(path.relative_to(kernels)) for path in found)


def crosscheck(*operations: str, images: str = "*") -> str:
    """Every variant against its reference."""
    return "crosscheck_test " + ":".join(f"*/{operation}_on_{images}" for operation in operations)


# Rules of one and two stages, with and without borders, stand for all where the code is not a rule.
SOME = ("thin_guo_hall", "thin_guo_hall_keep", "thin_mb2", "thin_mb2_keep")
COMPILE = "compile_test -ThoroughSearch*"
GOLDEN = "golden_test *outputs_equal*"
ITERATE = "engines_test *Iterate*:*Tile*:*State*-*threads*"
SIZES = "engines_test *at_every_size*/guo_hall_border_keep:*at_every_size*/mb2_border_background"
SOME_TABLES = "engines_test *RandomRules*variant/1:*lanes/1:BuiltIn*:Lanes*:TallImages*"
SOME_THINNING = (crosscheck(*SOME, images="sheets"), crosscheck(*SOME, images="shapes"), GOLDEN, SIZES)
API = "api_test -Sizes.thin_*"  # without those that take gigabytes
SOME_IMAGES = " THINBENCH_CROSSCHECK_EVERY=7"  # all take ten minutes
NETS = crosscheck("net_*") + SOME_IMAGES
THINNING = ("thinning_test", "engines_test", crosscheck("thin_*") + SOME_IMAGES, COMPILE, API)

FAMILIES = (
    Family("rules", ("rules/built_in/*.hpp",),
           ("rules_test", crosscheck("thin_{stem}", "thin_{stem}_keep", images="shapes"), GOLDEN), THINNING),
    Family("tables", ("rules/*",), ("rules_test", "techniques_test", GOLDEN), (*THINNING, NETS)),
    Family("scans", ("scan/*",), (*SOME_THINNING, SOME_TABLES), THINNING),
    Family("planes", ("engines/words.hpp", "engines/iterate.*", "engines/plane_state.hpp"),
           (*SOME_THINNING, ITERATE), (*THINNING, NETS)),
    Family("rows", ("engines/rows.cpp",), (), (*SOME_THINNING, SOME_TABLES, *THINNING, NETS)),
    Family("tiles", ("engines/tile_*", "engines/iterate_tiles.*"), (*SOME_THINNING, ITERATE, SOME_TABLES), THINNING),
    Family("lanes", ("engines/lane*", "thinning/stack.cpp"),
           (crosscheck("batch_*"), "thinning_test *Stack*", SOME_TABLES), (API, *THINNING)),
    Family("midpoints", ("midpoints/*",), (crosscheck("midpoint_scan*", images="sheets"), "scan_test", GOLDEN),
           (crosscheck("midpoint_scan*"), API)),
    Family("techniques", ("techniques/*",),
           ("techniques_test", *SOME_THINNING, crosscheck("net_*_1", "thin_spta", images="sheets"), "scan_test",
            "regions_test"),
           (*THINNING, "edges_test", "distance_test", "graph_test", NETS,
            crosscheck("objects", "euler_number*", "fill_holes", "holes", "label_*", images="sh*"))),
    Family("binarise", ("binarise/*",), ("images_test Binarise*:*Foreground*:Remarks*:Separation*:ReadBinary*",),
           ("images_test", API)),
    Family("edges", ("edges/*",),
           ("edges_test", "localise_test", crosscheck("edges_*"), GOLDEN), (API,)),
    Family("regions", ("regions/*",),
           ("regions_test", crosscheck("objects", "fill_holes*", "holes", "label_*", images="patterns"), GOLDEN,
            "localise_test"),
           (crosscheck("objects", "euler_number*", "fill_holes", "holes", "label_*"), API)),
    Family("localise", ("localise/*",), ("localise_test", crosscheck("localise_*"), GOLDEN), (API,)),
    Family("distance", ("distance/*",), ("distance_test", crosscheck("squared_distances", images="sh*")),
           (crosscheck("squared_distances"), API)),
    Family("graph", ("graph/*",), ("graph_test", crosscheck("skeleton_graph", images="sh*")),
           (crosscheck("skeleton_graph"), API)),
    Family("path", ("path/*",), ("path_test",), (API,)),
    Family("compile", ("compile/*",),
           (COMPILE, SOME_TABLES, "engines_test *RandomRules*variant/1:BuiltIn* THINBENCH_MACHINE_CODE=off"),
           ("engines_test", crosscheck("apply_*"), GOLDEN)),
    Family("core", ("core/byte_image.cpp", "core/packed_rows.cpp", "core/packing.cpp"),
           ("core_test", "localise_test", GOLDEN, "api_test *Pack*:*pack*", SIZES),
           (*THINNING, "edges_test", "scan_test")),
    Family("simd", ("simd/*",),
           ("core_test", "edges_test", "techniques_test", "scan_test", "localise_test", "engines_test TileGrid*",
            *SOME_THINNING), (*THINNING, "regions_test", NETS)),
    Family("lists", ("thinning/canvases.*", "thinning/labels.cpp", "thinning/many.cpp"),
           ("thinning_test *ThinMany*:*ThinLabels*:*Layouts*", crosscheck("labels_*", images="shapes")),
           ("thinning_test", API, crosscheck("list_*", "labels_*"))),
    Family("api", ("api/edges.cpp", "api/localise.cpp", "api/midpoint_scan.cpp", "api/regions.cpp", "api/rule.cpp",
                   "api/thinning.cpp", "thinning/operations.cpp"),
           (API, "regions_test"),
           (SOME_TABLES, "rules_test", "engines_test Rules.*", "thinning_test", "localise_test", "scan_test", GOLDEN)),
)
