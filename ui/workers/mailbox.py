"""Mailboxes that hold the newest thing only: for live images, which come faster than they are shown."""

from __future__ import annotations

import threading
from typing import Generic, TypeVar

T = TypeVar("T")


class Mailboxes(Generic[T]):
    """One box for each name. Whoever has something new puts it in; the reader takes what is newest, or nothing."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._items: dict[str, T] = {}

    def put(self, name: str, item: T) -> None:
        """Replace what lies in the box of this name; from any thread."""
        with self._lock:
            self._items[name] = item

    def take_all(self) -> dict[str, T]:
        """Empty all boxes; from any thread."""
        with self._lock:
            items, self._items = self._items, {}
        return items
