"""Files appear whole or not at all, as those of the programs do (tools/support/whole_file.hpp)."""

from __future__ import annotations

import json
import lzma
import os
from contextlib import suppress
from pathlib import Path
from typing import Any

from report.errors import ReportError


MAX_BYTES = 1_000_000_000
"""Of a file that is read."""


def write_files(directory: Path, outputs: dict[str, bytes]) -> None:
    """Writes everything under temporary names first, then renames, which is atomic."""
    staged: list[tuple[Path, Path]] = []
    try:
        for name, data in outputs.items():
            path = _target(directory / name)
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
            staged.append((temporary, path))
            temporary.write_bytes(data)
        for temporary, path in staged:
            _replace(path, temporary)
    except OSError as error:
        raise ReportError(f"{error.filename or directory}: cannot be written: {error.strerror}; "
                          "a directory that may be written to is needed") from None
    finally:
        for temporary, _ in staged:
            with suppress(OSError):
                temporary.unlink()


def _target(path: Path) -> Path:
    """Where a path leads through symbolic links; nothing but regular files is replaced."""
    target = Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        raise ReportError(f"{path}: cannot be written: it is not a regular file")
    return target


def _replace(path: Path, finished: Path) -> None:
    """Keeps the mode of a file. It is overwritten where other names (hard links), another owner or
    another group would be lost."""
    if path.exists():
        old, new = path.stat(), finished.stat()
        if old.st_nlink > 1 or (old.st_uid, old.st_gid) != (new.st_uid, new.st_gid):
            path.write_bytes(finished.read_bytes())
            return
        finished.chmod(old.st_mode & 0o7777)
    finished.replace(path)


def write_file(path: Path, data: bytes) -> None:
    """One file."""
    write_files(path.parent, {path.name: data})


def to_json(data: Any) -> bytes:
    """As files hold it."""
    return (json.dumps(data, indent=1) + "\n").encode()


def read_json(path: Path) -> Any:
    """Raises ReportError where the file is missing or no JSON."""
    try:
        return json.loads(read_bytes(path))
    except ValueError as error:
        raise ReportError(f"{path}: not JSON: {error}") from None


def read_bytes(path: Path) -> bytes:
    """What is in a file; a name that ends in .xz is decompressed."""
    try:
        if path.exists() and not path.is_file():
            raise ReportError(f"{path}: cannot be read: it is not a regular file")
        if path.stat().st_size > MAX_BYTES:
            raise ReportError(f"{path}: cannot be read: it has more than {MAX_BYTES:,} bytes")
        data = path.read_bytes()
        return lzma.decompress(data) if path.suffix == ".xz" else data
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error.strerror}") from None
    except lzma.LZMAError as error:
        raise ReportError(f"{path}: cannot be decompressed: {error}") from None
