"""Results of a session by key; those that no recent measurement used are dropped."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from typing import Generic, TypeVar

Result = TypeVar("Result")


class Store(Generic[Result]):
    """Results by key, in order of their last use."""

    def __init__(self, most: int) -> None:
        self._kept: OrderedDict[str, Result] = OrderedDict()
        self._most = most

    def __contains__(self, key: str) -> bool:
        return key in self._kept

    def peek(self, key: str) -> Result | None:
        """Return a result without counting as a use; None where there is none."""
        return self._kept.get(key)

    def get(self, key: str, make: Callable[[], Result]) -> tuple[Result, bool]:
        """Return the result of ``key``, and whether it had to be made."""
        made = key not in self._kept
        if made:
            self._kept[key] = make()
        self._kept.move_to_end(key)
        while len(self._kept) > self._most:
            self._kept.popitem(last=False)
        return self._kept[key], made
