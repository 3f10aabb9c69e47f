"""What this machine has to share among processes: processors and memory."""

from __future__ import annotations

import os
from pathlib import Path

MOST_WORKERS = 4
WAITING = 1  # process more than processors: tests of drivers mostly wait for timeouts and answers
BYTES_PER_WORKER = 3e9  # with the window, VTK, Open3D and a demo in it, a process of the tests holds 2.2 GB
MEMORY = Path("/proc/meminfo")
LIMIT, USED = Path("/sys/fs/cgroup/memory.max"), Path("/sys/fs/cgroup/memory.current")


def workers() -> int:
    """Return how many processes of the tests run side by side: one more than processors, at most four, and no more than memory holds."""
    free = free_bytes()
    room = MOST_WORKERS if free is None else int(free / BYTES_PER_WORKER)
    return max(1, min(processors() + WAITING, MOST_WORKERS, room))


def processors() -> int:
    """Return how many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def free_bytes() -> float | None:
    """Return the memory that can still be taken, within the limit of a container; None where the system does not say."""
    try:
        line = next(line for line in MEMORY.read_text().splitlines() if line.startswith("MemAvailable:"))
        free = 1024.0 * int(line.split()[1])
    except (OSError, StopIteration):
        return None
    try:
        return min(free, float(LIMIT.read_text()) - float(USED.read_text()))
    except (OSError, ValueError):  # no container, or one without a limit: "max"
        return free
