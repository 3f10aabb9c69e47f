"""The pages of the window, each made when it is first asked for, so that the window is there sooner."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from ui.pages.page import Page


class Pages(Mapping[str, Page]):
    """Pages by their names, in the order of the rail; to look one up makes it."""

    def __init__(self, kinds: Sequence[type[Page]], make: Callable[[type[Page]], Page]) -> None:
        """``make(kind)`` returns a new page that belongs to the window."""
        self._kinds = {kind.name: kind for kind in kinds}
        self._make = make
        self._made: dict[str, Page] = {}

    def __getitem__(self, name: str) -> Page:
        """Return a page; a name that is none raises KeyError."""
        if name not in self._made:
            self._made[name] = self._make(self._kinds[name])
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names."""
        return iter(self._kinds)

    def __len__(self) -> int:
        """Return the number of pages."""
        return len(self._kinds)

    @property
    def words(self) -> dict[str, str]:
        """What the pages are called, by their names."""
        return {name: kind.word for name, kind in self._kinds.items()}

    @property
    def made(self) -> tuple[Page, ...]:
        """Those that are made."""
        return tuple(self._made.values())

    def make_next(self) -> bool:
        """Make one that is missing; whether there was one."""
        missing = next((name for name in self._kinds if name not in self._made), None)
        return missing is not None and bool(self[missing])
