"""With what options a run was made, and whether that makes it a part of a full one."""

from __future__ import annotations

from dataclasses import dataclass

from report.json_fields import Fields


@dataclass(frozen=True)
class RunOptions:
    """What `./study` was asked for; older runs did not record all of it."""

    is_quick: bool = False
    filter: str = ""
    images: tuple[str, ...] = ()
    repetitions: int | None = None
    largest_square: int | None = None
    has_peers: bool = True

    @property
    def is_partial(self) -> bool:
        """True if a full run would have more rows, sizes or repetitions, or another input."""
        return self.is_quick or bool(self.filter or self.images) or not self.has_peers

    @property
    def words(self) -> str:
        """All that was recorded, in a line."""
        parts = ["quick" if self.is_quick else ""]
        parts.append(f"only rows that match '{self.filter}'" if self.filter else "")
        parts.append(f"pictures {', '.join(self.images)} instead of the scene"
                     if self.images else "")
        parts.append("" if self.has_peers else "no peers")
        parts.append(f"{self.repetitions} repetitions" if self.repetitions else "")
        if self.largest_square is not None:
            side = self.largest_square
            parts.append(f"squares up to {side} x {side}" if side else "no series of sizes")
        given = ", ".join(part for part in parts if part)
        return given


def load_run_options(fields: Fields) -> RunOptions:
    """The options recorded in machine.json."""
    images = fields.data.get("images")
    return RunOptions(
        is_quick=fields.data.get("quick") is True,
        filter=str(fields.data.get("filter") or ""),
        images=tuple(map(str, images)) if isinstance(images, list) else (),
        repetitions=fields.count("repetitions", 1) if fields.has("repetitions") else None,
        largest_square=fields.count("largest_square") if fields.has("largest_square") else None,
        has_peers=fields.data.get("peers") is not False)
