"""The command line: `python3 -m report build|claims|readme|sweeps DIR`."""

from __future__ import annotations

import argparse
import io
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from report.build import build, build_sweeps, claims_text
from report.errors import ReportError
from report.readme import fill_readme

EXAMPLE = """examples:
  python3 -m report build results/intel-6-143-8-1a2b3c4d/2026-11-21-abc1234
  python3 -m report claims results/intel-6-143-8-1a2b3c4d/2026-11-21-abc1234 > report/CLAIMS.md

DIR must hold timings.json, machine.json and rows.json. Written beside them:
timings.csv, timings.md, *.tex, plots/* (SVG, PNG and CSV) and index.html, a page
that needs no network. If DIR/experiments holds JSON files of the paper's experiments,
the page shows them too and experiments.md and claims.md are written; of
DIR/limits.json, limits.md; of DIR/sweeps.jsonl, sweeps.csv and sweeps.md. Where
DIR/files.json stands, every measured file must be one that it lists, unchanged.
A summary goes to standard output. Exit status: 0 done,
1 the data was refused (one line on standard error says why), 2 wrong usage.
"""


def parse(arguments: list[str]) -> argparse.Namespace:
    """Reads the command line, and ends the program if it is wrong or asks for help."""
    parser = argparse.ArgumentParser(
        prog="python3 -m report", description="Tables, plots and a page of one benchmark run.",
        epilog=EXAMPLE, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    _add(commands, "build", "write tables, plots and page", lambda options: build(options.directory))
    _add(commands, "claims", "print the paper's claims with what this run says of them",
         lambda options: claims_text(options.directory))
    _add(commands, "sweeps", "write tables and plots of the sweeps alone",
         lambda options: build_sweeps(options.directory))
    readme = _add(commands, "readme", "fill the marked tables of a README with this run's figures",
                  lambda options: fill_readme(options.directory, options.file))
    readme.add_argument("--file", type=Path, default=Path("README.md"), help="default README.md")
    return parser.parse_args(arguments)


def _add(commands: Any, name: str, what: str,
         work: Callable[[argparse.Namespace], str]) -> argparse.ArgumentParser:
    """A command that works on the folder of a run."""
    command: argparse.ArgumentParser = commands.add_parser(
        name, help=what, description=f"{what[0].upper()}{what[1:]}.", epilog=EXAMPLE,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    command.add_argument("directory", metavar="DIR", type=Path, help="the files of one run")
    command.set_defaults(work=work)
    return command


def main(arguments: list[str]) -> int:
    """Runs the command and returns the exit status."""
    options = parse(arguments)
    try:
        print(options.work(options).rstrip("\n"))
    except ReportError as error:
        print(f"report: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")
    sys.exit(main(sys.argv[1:]))
