"""How long each stage took and, if asked, what it used."""

from __future__ import annotations

import threading
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import asdict, dataclass, field

import psutil  # type: ignore[import-untyped]

SAMPLE_S = 0.02  # between two looks at the memory
CHILDREN_S = 0.5  # between two searches for programs that this one has started: each looks through all that run
WHOLE = "whole"  # from the start of a profile to its end, also what belongs to no stage


@dataclass(slots=True)
class StageUse:
    """What the program and those it started used while a stage ran, with everything that ran beside it."""

    wall_s: float = 0.0
    processor_s: float = 0.0
    peak_memory_mb: float = 0.0  # resident
    read_mb: float = 0.0  # through files, also from the cache of the system; not what is mapped into memory
    written_mb: float = 0.0


@dataclass(slots=True)
class Stopwatch:
    """Seconds spent per stage, added up."""

    seconds: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Add the time of the body to stage ``name``."""
        start = time.monotonic()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + time.monotonic() - start


class Profile(Stopwatch):
    """A stopwatch that also notes processor time, memory and traffic of every stage, and of the whole.

    Programs that were started meanwhile, such as that of the surface, are counted with this one. A context manager of the thread that
    watches the memory.
    """

    def __init__(self) -> None:
        super().__init__()
        self.use: dict[str, StageUse] = {}
        self._process = psutil.Process()
        self._children: list[psutil.Process] = []
        self._running: Counter[str] = Counter()
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._watcher = threading.Thread(target=self._watch_memory, name="profile", daemon=True)
        self._whole = ExitStack()

    def __enter__(self) -> Profile:
        self._watcher.start()
        self._whole.enter_context(self.stage(WHOLE))
        return self

    def __exit__(self, *_: object) -> None:
        self._whole.close()
        self._ended.set()
        self._watcher.join()

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Add time, processor time, peak memory and traffic of the body to stage ``name``."""
        with self._lock:
            self._running[name] += 1
            use = self.use.setdefault(name, StageUse())
        self._find_children()
        self._note_memory()
        before, start = self._used(), time.monotonic()
        try:
            with super().stage(name):
                yield
        finally:
            self._find_children()
            self._note_memory()
            processor_s, read, written = (after - earlier for after, earlier in zip(self._used(), before, strict=True))
            with self._lock:
                self._running[name] -= 1
                use.wall_s += time.monotonic() - start
                use.processor_s += processor_s
                use.read_mb += read / 1e6
                use.written_mb += written / 1e6

    def document(self) -> dict[str, dict[str, float]]:
        """Return the stages by name, for JSON."""
        return {name: {what: round(value, 3) for what, value in asdict(use).items()} for name, use in self.use.items()}

    def lines(self) -> list[str]:
        """Return a table of the stages, the longest first, with their shares of the whole; stages that run side by side overlap."""
        rows = sorted(self.use.items(), key=lambda item: -item[1].wall_s)
        whole = max((use.wall_s for use in self.use.values()), default=0.0) or 1.0
        head = f"{'stage':<14}{'wall s':>9}{'share':>7}{'processor s':>13}{'peak MB':>9}{'read MB':>9}{'written MB':>12}"
        return [
            head,
            *(
                f"{name:<14}{use.wall_s:>9.2f}{use.wall_s / whole:>7.0%}{use.processor_s:>13.2f}"
                f"{use.peak_memory_mb:>9.0f}{use.read_mb:>9.1f}{use.written_mb:>12.1f}"
                for name, use in rows
            ),
        ]

    def _used(self) -> tuple[float, int, int]:
        """Processor time, bytes read and bytes written so far; no bytes where the system does not count them.

        What an ended program used is part of the numbers of the one that waited for it.
        """
        times, (read, written) = self._process.cpu_times(), _traffic(self._process)
        processor_s = time.process_time() + times.children_user + times.children_system
        for child in self._children:
            with suppress(psutil.Error):
                used, (more_read, more_written) = child.cpu_times(), _traffic(child)
                processor_s += used.user + used.system + used.children_user + used.children_system
                read, written = read + more_read, written + more_written
        return processor_s, read, written

    def _find_children(self) -> None:
        self._children = self._process.children(recursive=True)

    def _watch_memory(self) -> None:
        sought = time.monotonic()
        while not self._ended.wait(SAMPLE_S):
            if time.monotonic() > sought + CHILDREN_S:
                self._find_children()
                sought = time.monotonic()
            self._note_memory()

    def _note_memory(self) -> None:
        now = 0
        for process in (self._process, *self._children):
            with suppress(psutil.Error):
                now += process.memory_info().rss
        with self._lock:
            for name in +self._running:
                self.use[name].peak_memory_mb = max(self.use[name].peak_memory_mb, now / 1e6)


def _traffic(process: psutil.Process) -> tuple[int, int]:
    """Bytes read and written by a program so far; nothing where the system does not count them."""
    if not hasattr(process, "io_counters"):
        return 0, 0
    counted = process.io_counters()
    return getattr(counted, "read_chars", counted.read_bytes), getattr(counted, "write_chars", counted.write_bytes)
