"""Mailboxes that keep only the newest item, for live images that arrive faster than they are shown."""

from __future__ import annotations

import threading
from typing import Generic, TypeVar

T = TypeVar("T")


class Mailboxes(Generic[T]):
    """One mailbox per name: writers replace its item, the reader takes the newest one."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._items: dict[str, T] = {}

    def put(self, name: str, item: T) -> None:
        """Replace the item of this name; from any thread."""
        with self._lock:
            self._items[name] = item

    def take_all(self) -> dict[str, T]:
        """Return and remove all items; from any thread."""
        with self._lock:
            items, self._items = self._items, {}
        return items
