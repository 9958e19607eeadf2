"""What the repository says of the working tree."""

from __future__ import annotations

import subprocess
from pathlib import Path

from report.building import ROOT


def git(*arguments: str, root: Path = ROOT) -> str | None:
    """The output of a git command, or None where it fails or there is no git."""
    try:
        done = subprocess.run(["git", "-C", root, *arguments], check=False, text=True,
                              capture_output=True)
    except FileNotFoundError:
        return None
    return done.stdout.strip() if done.returncode == 0 else None


def is_clean(root: Path = ROOT) -> bool:
    """Whether tracked files are as they were committed."""
    return git("status", "--porcelain", "--untracked-files=no", root=root) == ""


def commit_name(root: Path = ROOT) -> str:
    """The commit, with "-modified" where tracked files differ from it."""
    commit = git("rev-parse", "--short=10", "HEAD", root=root)
    if commit is None:
        return "unknown"
    return commit if is_clean(root) else f"{commit}-modified"
