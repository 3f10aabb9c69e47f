"""What several drivers of a rig share: a serial line, a login, a simulated world."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from typing import Any, TypeVar

from measureapp.errors import DeviceError

T = TypeVar("T")


class Links:
    """Shared resources by name, each built by the first driver that opens it and closed with the rig.

    Parameters
    ----------
    settings : by name, the tables ``[links.NAME]`` of the rig description; the driver that builds a link validates its table
    """

    def __init__(self, settings: Mapping[str, Mapping[str, object]]) -> None:
        self._settings = settings
        self._built: dict[str, Any] = {}
        self._closing = ExitStack()

    def open(self, name: str, kind: type[T], build: Callable[[Mapping[str, object]], T], close: Callable[[T], None] | None = None) -> T:
        """Return the link ``name``, built from its settings at the first call; ``close`` is called once, when the rig is closed.

        Raises
        ------
        DeviceError
            The rig description has no such link, or another driver opened it as something else.
        """
        if name not in self._settings:
            known = ", ".join(sorted(self._settings)) or "none"
            raise DeviceError(f"The rig has no link {name!r} (described: {known}).", f"Add a table [links.{name}] to the rig description.")
        if name not in self._built:
            self._built[name] = link = build(self._settings[name])
            if close is not None:
                self._closing.callback(close, link)
        if not isinstance(self._built[name], kind):
            raise DeviceError(
                f"Link {name!r} is a {type(self._built[name]).__name__}, and a driver needs a {kind.__name__}.",
                "Give drivers of different kinds links of their own.",
            )
        return self._built[name]

    def close(self) -> None:
        """Close every link, the last opened first."""
        self._closing.close()
