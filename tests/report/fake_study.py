"""`fake_study.py BUILDS COMMAND...`: the commands of ./study on programs that exist already, in a
directory for each preset, of one commit, even if the tree changes meanwhile."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

# pylint: disable=wrong-import-position
import report.pages
import report.sweeps.command
from report.__main__ import main

if __name__ == "__main__":
    for module in (report.pages, report.sweeps.command):
        module.build = lambda preset, targets, **_: Path(sys.argv[1], preset)
        module.commit_name = lambda: "0123456789"
    sys.exit(main(sys.argv[2:]))
