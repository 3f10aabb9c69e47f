"""The memory that is available: of the computer, and of the container that the program runs in."""

from __future__ import annotations

from pathlib import Path, PurePosixPath

import psutil  # type: ignore[import-untyped]

GIB = 2**30
CONTROL_GROUPS, OWN_GROUPS = Path("/sys/fs/cgroup"), Path("/proc/self/cgroup")
# a limit, what is used of it, and the line of `memory.stat` with the file cache that is given up first; version 2 and version 1
FILES = {
    "": ("memory.max", "memory.current", "inactive_file"),
    "memory": ("memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"),
}


def available_bytes(control_groups: Path = CONTROL_GROUPS, own_groups: Path = OWN_GROUPS) -> int:
    """Return the memory available to this program, the file cache included: what the computer has left, or less where a container limits it."""
    return min([int(psutil.virtual_memory().available), *_left_in_groups(control_groups, own_groups)])


def _left_in_groups(root: Path, own_groups: Path) -> list[int]:
    """Return what each group of processes that this program belongs to has left of its limit; nothing where there is no limit."""
    try:
        lines = own_groups.read_text(encoding="utf-8").splitlines()
    except OSError:  # no Linux
        return []
    found = []
    for line in lines:
        _, controllers, group = line.split(":", 2)
        kind = "memory" if "memory" in controllers.split(",") else controllers
        if kind in FILES:
            place = PurePosixPath(group.lstrip("/"))
            inside = [root / kind / one for one in (place, *place.parents)]  # a container may show its own group as the root
            found += [left for folder in inside if (left := _left(folder, *FILES[kind])) is not None]
    return found


def _left(folder: Path, limit: str, used: str, cache: str) -> int | None:
    """Return what a group has left; None where it states no limit."""
    try:
        most, now = int((folder / limit).read_text()), int((folder / used).read_text())
        stat = dict(line.split() for line in (folder / "memory.stat").read_text().splitlines())
        return max(most - now + int(stat.get(cache, 0)), 0)
    except (OSError, ValueError):  # "max", or no such group
        return None
