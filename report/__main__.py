"""The command line: `python3 -m report COMMAND`, which ./study starts."""

from __future__ import annotations

import argparse
import io
import os
import signal
import subprocess
import sys
from collections.abc import Callable

from report.errors import ReportError

Run = Callable[[argparse.ArgumentParser, argparse.Namespace], str | tuple[str, int]]
"""Returns what to print, and the exit status where it is not always 0."""


def _commands(parser: argparse.ArgumentParser) -> None:
    """Declares every command; what they need is imported when one runs."""
    from report import compare, pages, study
    from report.many_images import command as many_images
    from report.page import command as page
    from report.regress import command as regress
    from report.sweeps import command as sweeps
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def add(name: str, what: str, declare: Callable[[argparse.ArgumentParser], None], run: Run,
            epilog: str) -> None:
        prog = "./study" if name == "study" else f"./study {name}"
        command = commands.add_parser(name, prog=prog, help=what, epilog=epilog,
                                      description=f"{what[0].upper()}{what[1:]}.",
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
        declare(command)
        command.set_defaults(run=run, parser=command)

    add("study", "build, verify, measure and write a page", study.add_study_command,
        study.run_study, study.EPILOG)
    add("sweeps", "measure how times depend on one parameter", sweeps.add_sweeps_command,
        sweeps.run_sweeps, sweeps.EPILOG)
    add("pages", "measure real pictures and drawn pages beside other projects' code", pages.add_pages_command,
        pages.run_pages, pages.EPILOG)
    add("many-images", "measure batches of files, workers, calls and dask",
        many_images.add_many_images_command, many_images.run_many_images, many_images.EPILOG)
    add("regress", "say whether rows became slower", regress.add_regress_command,
        regress.run_regress, regress.EPILOG)
    add("compare", "compare runs of different machines or commits", compare.add_compare_command,
        compare.run_compare, compare.EPILOG)
    for name, what, declare, run in (
            ("build", "make the page, the tables and the overview of a run", page.add_directory,
             page.run_build),
            ("readme", "fill the tables of README.md, docs/ and the paper's claims from a run", page.add_readme_command,
             page.run_readme)):
        add(name, what, declare, run, page.EPILOG.format(name))


def _show(text: str) -> None:
    """On standard output, whole."""
    try:
        print(text.rstrip("\n"), flush=True)
    except OSError as error:
        with open(os.devnull, "w", encoding="utf-8") as nothing:  # for what Python flushes at its end
            os.dup2(nothing.fileno(), sys.stdout.fileno())
        raise ReportError(f"standard output cannot be written: {error.strerror}") from None


def _run(arguments: list[str]) -> int:
    """Without a word on failures."""
    parser = argparse.ArgumentParser(prog="./study", description="Measurements and their report.")
    _commands(parser)
    options = parser.parse_args(arguments)
    found = options.run(options.parser, options)
    text, status = found if isinstance(found, tuple) else (found, 0)
    _show(text)
    return int(status)


def main(arguments: list[str]) -> int:
    """Runs the command and returns the exit status."""
    try:
        return _run(arguments)
    except ReportError as error:
        why, status = str(error), error.status
    except KeyboardInterrupt:
        why, status = "interrupted", 130
    except MemoryError:
        why, status = "there is not enough memory", 1
    except (OSError, subprocess.SubprocessError) as error:
        why, status = " ".join(str(error).split()), 1
    except ImportError as error:
        reason = " ".join(str(error).split())[-200:]
        why, status = f"a Python package cannot be loaded: {reason}", 1
    print(f"study: {why}", file=sys.stderr)
    return status


if __name__ == "__main__":
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, signal.default_int_handler)  # finally removes scratch files
    sys.exit(main(sys.argv[1:]))
