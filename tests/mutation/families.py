"""The parts of the kernels that decide pixels, and the tests that should notice a change in them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Check:
    """A test program, or some of its tests."""

    program: str
    tests: str = "*"


@dataclass(frozen=True)
class Family:
    """`sources` are patterns of files in kernels/. `first` are sources that are compiled and tested
    before the other files that include a changed header, as they suffice for most mutants."""

    name: str
    sources: tuple[str, ...]
    checks: tuple[Check, ...]
    first: tuple[str, ...] = ()

    def files(self, kernels: Path) -> list[str]:
        """The sources, relative to `kernels`."""
        found = {path for pattern in self.sources for path in kernels.glob(pattern)}
        return sorted(str(path.relative_to(kernels)) for path in found)


GOLDEN = Check("golden_test", "*outputs_equal*")
APPLY = Check("custom_rules_test")
API = Check("api_test")


def crosscheck(*operations: str, images: str = "*") -> Check:
    """Every variant against its reference."""
    return Check("crosscheck_test", ":".join(f"*/{operation}_on_{images}" for operation in operations))


THINNING = (crosscheck("thin_*", images="sheets"), crosscheck("thin_*", images="shapes"), GOLDEN,
            Check("thinning_test"), Check("batch_test"), crosscheck("thin_*"), APPLY, API)
NETS = (crosscheck("net_*", images="sheets"), crosscheck("net_*", images="shapes"), Check("nets_test"), GOLDEN,
        crosscheck("net_*"), API)
BATCHES = (Check("batch_test"), crosscheck("batch_*"), API, APPLY)
MIDPOINTS = (crosscheck("skeleton_scan*", images="sheets"), Check("scan_test"), GOLDEN, crosscheck("skeleton_scan*"), API)
EDGES = (crosscheck("edges_*"), Check("edges_test"), GOLDEN, API)
REGIONS = (Check("regions_test"), crosscheck("components", "euler_number*", "fill_holes", "holes"), GOLDEN, API)
LOCALISE = (Check("localise_test"), crosscheck("localise_*"), GOLDEN, API)
CUSTOM = (APPLY, Check("custom_tables_test"), crosscheck("apply_*"), GOLDEN)
ENGINES = "thinning/engines/"
ITERATION = "thinning/iteration/"

FAMILIES = (
    Family("rules", ("thinning/rules/*.hpp",), THINNING, first=(ENGINES + "bitpacked.cpp",)),
    Family("planes", (ENGINES + "word_scan.hpp", ENGINES + "lut.cpp", ENGINES + "autovec.cpp",
                      ENGINES + "passes.hpp", ENGINES + "rule_table.hpp", ITERATION + "iterate.*",
                      ITERATION + "pass_state.hpp", ITERATION + "plane_state.hpp"), THINNING + NETS),
    Family("rows", (ENGINES + "row_kernel.*", ITERATION + "row_state.hpp"), THINNING + NETS),
    Family("tiles", (ENGINES + "tile_*", ITERATION + "iterate_tiles.*", ITERATION + "tile_state.*"), THINNING),
    Family("lanes", (ENGINES + "lane_*", ENGINES + "layouts.hpp", "api/batch.cpp"), BATCHES),
    Family("spta", (ENGINES + "spta*",), THINNING),
    Family("midpoints", ("midpoints/*",), MIDPOINTS),
    Family("nets", ("nets/*",), NETS),
    Family("edges", ("edges/*",), EDGES),
    Family("regions", ("regions/*",), REGIONS),
    Family("localise", ("localise/*",), LOCALISE),
    Family("custom", ("custom/*",), CUSTOM),
    Family("image", ("image/byte_image.*", "image/layout.hpp", "image/packed_rows.cpp", "image/packing.cpp",
                     "image/plane*"), (Check("core_test"),) + THINNING + EDGES + REGIONS),
    Family("simd", ("simd/*",), (Check("core_test"),) + THINNING + EDGES + REGIONS + MIDPOINTS + NETS + CUSTOM,
           first=("image/packing.cpp", ENGINES + "simd.cpp", "edges/simd.cpp")),
    Family("api", ("api/canvases.*", "api/catalogue.cpp", "api/custom_rule.cpp", "api/edges.cpp", "api/labels.cpp",
                   "api/localise.cpp", "api/many.cpp", "api/packed.cpp", "api/regions.cpp", "api/thinning.cpp"),
           (API, Check("custom_rules_test"), GOLDEN)),
)


def programs() -> list[str]:
    """All test programs."""
    return sorted({check.program for family in FAMILIES for check in family.checks})
