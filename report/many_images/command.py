"""`./study many-images`: builds, draws inputs, verifies, measures and writes a CSV file."""

from __future__ import annotations

import argparse
import logging
import os
import signal
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from report.building import build
from report.errors import ReportError
from report.files import check_directory, write_file
from report.git import commit_name
from report.measure.command import RESULTS, default_directory
from report.measure.machine import machine_facts
from report.row_options import positive

EPILOG = """examples:
  ./study many-images
  ./study many-images --quick --out /tmp/many
  ./study many-images --files 10000 --rounds 15

Exit status: 0 done, 1 something is missing or failed, 2 wrong usage or pixels that differ, 130
interrupted."""

# What measures is imported when the command runs, as it needs the package that was built.
# pylint: disable=import-outside-toplevel


@dataclass(frozen=True)
class Sizes:
    """What is drawn and how often it is measured."""

    files: int = 240
    loop_files: int = 24  # for loops, of which some take 0.2 s per image
    rounds: int = 8
    dask_side: int = 3000
    chunk_sides: tuple[int, ...] = (250, 500, 1000, 1500)


QUICK = Sizes(files=8, loop_files=2, rounds=2, dask_side=600, chunk_sides=(200, 300))


def add_many_images_command(parser: argparse.ArgumentParser) -> None:
    """Its options."""
    parser.add_argument("--quick", action="store_true",
                        help="a few tiny inputs, two rounds: seconds, for a trial")
    parser.add_argument("--files", metavar="N", type=positive,
                        help=f"image files to draw; default {Sizes.files}, with --quick "
                             f"{QUICK.files}")
    parser.add_argument("--rounds", metavar="N", type=positive,
                        help=f"default {Sizes.rounds}, with --quick {QUICK.rounds}")
    parser.add_argument("--out", metavar="DIR", type=Path,
                        help="where results go; default "
                             "results/<machine>/<date>-<commit>/many-images")


def run_many_images(_parser: argparse.ArgumentParser, options: argparse.Namespace) -> str:
    """Returns the summary to print."""
    check_directory(options.out or RESULTS)
    programs = build("release", ("thinbench_program", "thinbench_study", "thinbench_benchmarks", "thinbench_python"))
    chosen = {name: value for name in ("files", "rounds") if (value := getattr(options, name))}
    sizes = Sizes(**vars(QUICK if options.quick else Sizes()) | chosen)
    machine = machine_facts(programs / "thinbench_benchmarks", commit_name())
    directory = options.out or default_directory(machine) / "many-images"
    sys.path.insert(0, str(programs.parent / "python"))
    try:
        return measure_many_images(programs / "thinbench", machine, sizes, directory)
    except ImportError as error:
        raise ReportError(f"{error}; leave out --no-install, or install python3-opencv, "
                          "python3-skimage, python3-dask and python3-distributed") from None


def measure_many_images(program: Path, machine: dict[str, Any], sizes: Sizes,
                        directory: Path) -> str:
    """Returns the tables. The package must be importable."""
    import cv2
    from distributed import Client, LocalCluster

    from report.many_images.results import CSV, results_of, to_csv
    from report.many_images.steps import measure
    from report.many_images.tables import TABLES
    cv2.setNumThreads(1)
    cores = machine["cores"]
    with tempfile.TemporaryDirectory() as work:
        with LocalCluster(  # type: ignore[no-untyped-call]
                n_workers=cores, threads_per_worker=1, dashboard_address=":0",
                local_directory=work) as cluster, Client(cluster) as client:  # type: ignore[no-untyped-call]
            logging.getLogger("asyncio").setLevel(logging.CRITICAL)  # of tasks at an interrupt
            client.run(_ignore_interrupts)
            os.environ.pop("MALLOC_TRIM_THRESHOLD_", None)  # meant for workers; slows what is started here
            steps = _steps(program, Path(work), sizes, client, cores)
            samples = measure(steps, sizes.rounds)
    results = results_of(steps, samples, machine)
    write_file(directory / CSV, to_csv(results).encode())
    return "\n".join([*(table(results) for table in TABLES.values()), f"{directory} holds {CSV}"])


def _ignore_interrupts() -> None:
    """In a worker, which its parent stops."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _steps(program: Path, work: Path, sizes: Sizes, client: Any, cores: int) -> list[Any]:
    """Draws inputs."""
    from report.many_images.inputs import draw_files, draw_scene, repeated
    from report.many_images.of_arrays import DaskSteps
    from report.many_images.of_calls import call_steps
    from report.many_images.of_files import image_steps, worker_steps
    files = draw_files(draw_scene(program, work), work / "files", sizes.files)
    binary = draw_scene(program, work, "--binary")
    image = repeated(binary, sizes.dask_side, sizes.dask_side)
    return [*image_steps(program, files[:sizes.loop_files], work),
            *worker_steps(program, files, work, client, cores),
            *call_steps(binary),
            *DaskSteps(image, client, cores).steps(list(sizes.chunk_sides))]
