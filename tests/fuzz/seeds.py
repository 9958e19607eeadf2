"""Seeds of fuzz targets: lines of TARGET.seeds, sorted, each a name and the bytes in base64.

`python3 -m tests.fuzz.seeds unpack TARGET.seeds DIRECTORY` writes them as files;
`python3 -m tests.fuzz.seeds add TARGET.seeds FILE...` adds files; a seed with the same name is replaced."""

from __future__ import annotations

import sys
from base64 import b64decode, b64encode
from collections.abc import Sequence
from pathlib import Path


def read(packed: Path) -> dict[str, bytes]:
    """The bytes by name."""
    lines = (line.split(" ") for line in packed.read_text(encoding="utf-8").splitlines())
    return {name: b64decode(content, validate=True) for name, content in lines}


def unpack(packed: Path, directory: Path) -> None:
    """Other files of the directory stay."""
    directory.mkdir(parents=True, exist_ok=True)
    for name, content in read(packed).items():
        (directory / name).write_bytes(content)


def add(packed: Path, files: Sequence[Path]) -> None:
    """To a new file if there is none."""
    seeds = read(packed) if packed.exists() else {}
    seeds |= {path.name: path.read_bytes() for path in files}
    packed.write_text("".join(f"{name} {b64encode(content).decode()}\n"
                              for name, content in sorted(seeds.items())), encoding="utf-8")


def main(arguments: Sequence[str]) -> None:
    """Exits with status 1 and the usage if the arguments are wrong."""
    match arguments:
        case ["unpack", packed, directory]:
            unpack(Path(packed), Path(directory))
        case ["add", packed, first, *others]:
            add(Path(packed), [Path(path) for path in (first, *others)])
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
