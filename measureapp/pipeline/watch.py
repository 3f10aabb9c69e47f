"""How long each stage took and, if asked, what it used."""

from __future__ import annotations

import threading
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field

import psutil  # type: ignore[import-untyped]

SAMPLE_S = 0.02  # between two looks at the memory


@dataclass(slots=True)
class StageUse:
    """What the whole program used while a stage ran, with everything that ran beside it."""

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
    """A stopwatch that also notes processor time, memory and traffic of every stage. A context manager of the thread that watches the memory."""

    def __init__(self) -> None:
        super().__init__()
        self.use: dict[str, StageUse] = {}
        self._process = psutil.Process()
        self._running: Counter[str] = Counter()
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._watcher = threading.Thread(target=self._watch_memory, name="profile", daemon=True)

    def __enter__(self) -> Profile:
        self._watcher.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._watcher.join()

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Add time, processor time, peak memory and traffic of the body to stage ``name``."""
        with self._lock:
            self._running[name] += 1
            use = self.use.setdefault(name, StageUse())
        self._note_memory()
        processor, (read, written), start = time.process_time(), self._traffic(), time.monotonic()
        try:
            with super().stage(name):
                yield
        finally:
            self._note_memory()
            more_read, more_written = self._traffic()
            with self._lock:
                self._running[name] -= 1
                use.wall_s += time.monotonic() - start
                use.processor_s += time.process_time() - processor
                use.read_mb += (more_read - read) / 1e6
                use.written_mb += (more_written - written) / 1e6

    def document(self) -> dict[str, dict[str, float]]:
        """Return the stages by name, for JSON."""
        return {name: {what: round(value, 3) for what, value in asdict(use).items()} for name, use in self.use.items()}

    def lines(self) -> list[str]:
        """Return a table of the stages, the longest first."""
        rows = sorted(self.use.items(), key=lambda item: -item[1].wall_s)
        head = f"{'stage':<14}{'wall s':>9}{'processor s':>13}{'peak MB':>9}{'read MB':>9}{'written MB':>12}"
        return [
            head,
            *(
                f"{name:<14}{use.wall_s:>9.2f}{use.processor_s:>13.2f}{use.peak_memory_mb:>9.0f}{use.read_mb:>9.1f}{use.written_mb:>12.1f}"
                for name, use in rows
            ),
        ]

    def _traffic(self) -> tuple[int, int]:
        """Bytes read and written by the program so far; nothing where the system does not count them."""
        if not hasattr(self._process, "io_counters"):
            return 0, 0
        counted = self._process.io_counters()
        return getattr(counted, "read_chars", counted.read_bytes), getattr(counted, "write_chars", counted.write_bytes)

    def _watch_memory(self) -> None:
        while not self._ended.wait(SAMPLE_S):
            self._note_memory()

    def _note_memory(self) -> None:
        now = self._process.memory_info().rss / 1e6
        with self._lock:
            for name in +self._running:
                self.use[name].peak_memory_mb = max(self.use[name].peak_memory_mb, now)
