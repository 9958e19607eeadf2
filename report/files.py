"""Files appear whole or not at all, as those of the programs do (tools/support/whole_file.hpp)."""

from __future__ import annotations

import json
import lzma
import os
import tempfile
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

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


def check_directory(directory: Path) -> None:
    """Rejects what writing would fail at after all the work. Nothing is made."""
    existing = directory.absolute()
    while not os.path.lexists(existing):
        existing = existing.parent
    try:
        with tempfile.TemporaryFile(dir=existing):
            pass
    except OSError as error:
        raise ReportError(f"{existing}: cannot be written: {error.strerror}; "
                          "a directory that may be written to is needed") from None


def _target(path: Path) -> Path:
    """Where a path leads through symbolic links; nothing but regular files is replaced."""
    target = Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        raise ReportError(f"{path}: cannot be written: it is not a regular file")
    return target


def _replace(path: Path, finished: Path) -> None:
    """Keeps the mode, owner and group of a file. It is overwritten where it has other names (hard links) or an owner
    that cannot be given to another file."""
    if path.exists():
        old = path.stat()
        if not _can_be_replaced(old, finished):
            _overwrite(path, finished)
            return
        finished.chmod(old.st_mode & 0o7777)
    finished.replace(path)


def _can_be_replaced(old: os.stat_result, finished: Path) -> bool:
    if old.st_nlink > 1:
        return False
    new = finished.stat()
    try:
        if (old.st_uid, old.st_gid) != (new.st_uid, new.st_gid):
            os.chown(finished, old.st_uid, old.st_gid)
    except PermissionError:
        return False
    return True


def _overwrite(path: Path, finished: Path) -> None:
    """Room on the disk is taken first. Until the copy is whole, the finished file has a second name, which neither a
    signal nor a failure removes."""
    with finished.open("rb") as source, path.open("r+b", buffering=0) as target:
        size = finished.stat().st_size
        _reserve(target, size, path)
        whole = _second_name(finished, path)
        try:
            while os.sendfile(target.fileno(), source.fileno(), None, 1 << 30):
                pass
            target.truncate(size)
            os.fsync(target.fileno())
        except OSError as error:
            raise ReportError(f"{path}: cannot be written: {error.strerror}; all of it is in '{whole}'") from None
    whole.unlink()


def _reserve(target: IO[bytes], size: int, path: Path) -> None:
    """For a file that may grow; its bytes remain as they are."""
    old_size = path.stat().st_size
    try:
        os.posix_fallocate(target.fileno(), 0, max(size, 1))
    except OSError as error:
        target.truncate(old_size)
        raise ReportError(f"{path}: cannot be written: {error.strerror}") from None


def _second_name(finished: Path, path: Path) -> Path:
    """One that no other file has."""
    name = path.with_name(f"{path.name}.whole")
    number = 1
    while name.exists():
        number += 1
        name = path.with_name(f"{path.name}.whole{number}")
    name.hardlink_to(finished)
    return name


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
    except (ValueError, RecursionError) as error:
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
