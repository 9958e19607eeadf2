"""The command line: `python3 -m report build DIR`."""

from __future__ import annotations

import argparse
import io
import sys
from pathlib import Path

from report.build import build
from report.errors import ReportError

EXAMPLE = """example:
  python3 -m report build results/intel-6-143-8-1a2b3c4d/2026-11-21-abc1234

DIR must hold timings.json, machine.json and rows.json. Written beside them:
timings.csv, timings.md, plots/*.svg, plots/*.png and index.html, a page that
needs no network. If DIR/experiments holds JSON files of the paper's experiments,
the page shows them too and experiments.md is written; of DIR/limits.json,
limits.md. A summary goes to standard output. Exit status: 0 done, 1 the data was
refused (one line on standard error says why), 2 wrong usage.
"""


def parse(arguments: list[str]) -> argparse.Namespace:
    """Reads the command line, and ends the program if it is wrong or asks for help."""
    parser = argparse.ArgumentParser(
        prog="python3 -m report", description="Tables, plots and a page of one benchmark run.",
        epilog=EXAMPLE, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    command = commands.add_parser(
        "build", help="write tables, plots and page", description="Writes tables, plots and page.",
        epilog=EXAMPLE, formatter_class=argparse.RawDescriptionHelpFormatter)
    command.add_argument("directory", metavar="DIR", type=Path, help="the files of one run")
    return parser.parse_args(arguments)


def main(arguments: list[str]) -> int:
    """Runs the command and returns the exit status."""
    options = parse(arguments)
    try:
        print(build(options.directory))
    except ReportError as error:
        print(f"report: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")
    sys.exit(main(sys.argv[1:]))
