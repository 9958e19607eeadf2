"""`python3 -m report build` and `readme`."""

from __future__ import annotations

import argparse
from pathlib import Path

from report.building import ROOT

EPILOG = "example: python3 -m report {} results/<machine>/<date>-<commit>"

# What draws and judges is imported when a command runs: that takes a second.
# pylint: disable=import-outside-toplevel


def add_directory(parser: argparse.ArgumentParser) -> None:
    """The argument of `build`."""
    parser.add_argument("directory", metavar="DIR", type=Path, help="directory of a run")


def add_readme_command(parser: argparse.ArgumentParser) -> None:
    """The same and the files."""
    add_directory(parser)
    parser.add_argument("documents", metavar="FILE", type=Path, nargs="*",
                        help="files with marks; default README.md, report/CLAIMS.md and what has marks in docs/")


def run_build(_parser: argparse.ArgumentParser, options: argparse.Namespace) -> str:
    """Returns the summary."""
    from report.page.build import build_page
    return build_page(options.directory)


def run_readme(_parser: argparse.ArgumentParser, options: argparse.Namespace) -> str:
    """Returns what was done."""
    from report.page.readme import fill_documents, marked
    return fill_documents(options.directory, options.documents or marked(ROOT))
