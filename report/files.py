"""Files appear whole or not at all."""

from __future__ import annotations

import json
import lzma
import os
from contextlib import suppress
from pathlib import Path
from typing import Any

from report.errors import ReportError


def write_files(directory: Path, outputs: dict[str, bytes]) -> None:
    """Writes everything under temporary names first, then renames, which is atomic."""
    staged: list[tuple[Path, Path]] = []
    try:
        for name, data in outputs.items():
            path = directory / name
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
            staged.append((temporary, path))
            temporary.write_bytes(data)
        for temporary, path in staged:
            temporary.replace(path)
    except OSError as error:
        raise ReportError(f"{error.filename or directory}: cannot be written: {error.strerror}; "
                          "a directory that may be written to is needed") from None
    finally:
        for temporary, _ in staged:
            with suppress(OSError):
                temporary.unlink()


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
        data = path.read_bytes()
        return lzma.decompress(data) if path.suffix == ".xz" else data
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error.strerror}") from None
    except lzma.LZMAError as error:
        raise ReportError(f"{path}: cannot be decompressed: {error}") from None
