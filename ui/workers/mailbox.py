"""A mailbox that holds the newest thing only: for live images, which come faster than they are shown."""

from __future__ import annotations

import threading
from typing import Generic, TypeVar

T = TypeVar("T")


class Mailbox(Generic[T]):
    """Whoever has something new puts it in; the reader takes what is newest, or nothing."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._item: T | None = None

    def put(self, item: T) -> None:
        """Replace what lies in the box; from any thread."""
        with self._lock:
            self._item = item

    def take(self) -> T | None:
        """Empty the box; from any thread."""
        with self._lock:
            item, self._item = self._item, None
        return item
