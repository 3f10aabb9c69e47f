"""Settings of the window in one file with a schema number; values that make no sense are replaced by their defaults."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Protocol

from PySide6.QtCore import QObject, QSettings, Signal

from measureapp.language.languages import LANGUAGES

SCHEMA: Final = 2
THEMES = ("system", "light", "dark")
AS_SYSTEM, AS_WINDOW = "system", "window"
ROLES = ("operator", "engineer")


@dataclass(frozen=True)
class Known:
    """One setting: its default, and the values it may have (empty: any text)."""

    default: str
    values: tuple[str, ...] = ()


KNOWN: Final[dict[str, Known]] = {
    "theme": Known("system", THEMES),
    "language": Known(AS_SYSTEM, (AS_SYSTEM, *LANGUAGES)),
    "report_language": Known(AS_WINDOW, (AS_WINDOW, *LANGUAGES)),
    "page": Known("rig"),
    "role": Known("engineer", ROLES),
    "tour": Known("new", ("new", "taken")),
}


class Store(Protocol):
    """Where settings are kept; QSettings is one."""

    def value(self, key: str) -> object:
        """Return a value; None if there is none."""

    def setValue(self, key: str, value: str) -> None:
        """Keep a value."""

    def remove(self, key: str) -> None:
        """Forget a value, or all of a group."""

    def allKeys(self) -> list[str]:
        """Return the names of all values."""

    def sync(self) -> None:
        """Write what was changed."""


def settings_file() -> Path:
    """Return the file of the user's settings."""
    return Path.home() / "MeasureApp" / "settings.ini"


class Memory:
    """Keeps settings while the program runs, where no file is wanted."""

    def __init__(self) -> None:
        self._values: dict[str, str] = {}

    def value(self, key: str) -> object:
        """Return a value; None if there is none."""
        return self._values.get(key)

    def setValue(self, key: str, value: str) -> None:
        """Keep a value."""
        self._values[key] = value

    def remove(self, key: str) -> None:
        """Forget a value, or all of a group."""
        self._values = {name: value for name, value in self._values.items() if name != key and not name.startswith(f"{key}/")}

    def allKeys(self) -> list[str]:
        """Return the names of all values."""
        return list(self._values)

    def sync(self) -> None:
        """There is no file to write."""


class Settings(QObject):
    """Reads and writes the settings; nothing in the file can stop the window from opening."""

    changed = Signal(str)  # name of a setting

    def __init__(self, file: Path | None = None, parent: QObject | None = None) -> None:
        """``file``: None keeps them only while the program runs."""
        super().__init__(parent)
        self.file = file
        self._store: Store = Memory() if file is None else _open_file(file)
        self.is_newer = migrate(self._store)

    def text(self, name: str) -> str:
        """Return a setting; its default if the file holds none that makes sense."""
        known, stored = KNOWN[name], self._store.value(f"window/{name}")
        fits = isinstance(stored, str) and bool(stored) and (not known.values or stored in known.values)
        return stored if fits else known.default

    def set_text(self, name: str, value: str) -> None:
        """Keep a setting. Raises ValueError for a value that it cannot have."""
        known = KNOWN[name]
        if known.values and value not in known.values:
            raise ValueError(f"{name} cannot be {value!r}; it is one of {', '.join(known.values)}")
        if self.text(name) != value:
            self._store.setValue(f"window/{name}", value)
            self.changed.emit(name)

    def numbers(self, place: str) -> tuple[int, ...]:
        """Return whole numbers, such as sizes; none if there are none, or others."""
        stored = self._store.value(f"layout/{place}")
        if not isinstance(stored, str):
            return ()
        try:
            return tuple(int(part) for part in stored.split())
        except ValueError:
            return ()

    def set_numbers(self, place: str, numbers: tuple[int, ...]) -> None:
        """Keep whole numbers; as one text, because lists are stored in a form of Qt's own."""
        self._store.setValue(f"layout/{place}", " ".join(str(number) for number in numbers))

    def folder(self, purpose: str) -> Path:
        """Return the folder used last for a purpose, such as "nominal"; the user's own folder if it is gone."""
        stored = self._store.value(f"folders/{purpose}")
        if isinstance(stored, str) and stored:
            with contextlib.suppress(OSError, ValueError):
                if Path(stored).is_dir():
                    return Path(stored)
        return Path.home()

    def set_folder(self, purpose: str, chosen: Path) -> None:
        """Keep the folder of a file or folder that was chosen for a purpose."""
        folder = chosen if chosen.is_dir() else chosen.parent
        self._store.setValue(f"folders/{purpose}", str(folder))

    def forget_layout(self) -> None:
        """Forget sizes of the window and its parts."""
        self._store.remove("layout")
        self.changed.emit("layout")

    def lines(self) -> list[str]:
        """Return all settings as lines of text, for support; there are no secrets among them."""
        return [f"{key} = {self._store.value(key)}" for key in sorted(self._store.allKeys())]

    def save(self) -> None:
        """Write now what was changed; a file that cannot be written is no reason to stop."""
        self._store.sync()


def _open_file(file: Path) -> QSettings:
    _set_aside(file)
    return QSettings(str(file), QSettings.Format.IniFormat)


def _set_aside(file: Path) -> None:
    """Rename a file that holds anything but text, so that new settings can be kept."""
    try:
        file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        with contextlib.suppress(OSError):
            file.replace(file.with_suffix(".damaged"))
    except OSError:
        return


def _from_1(store: Store) -> None:
    """Version 1 kept the theme as a word of its own."""
    old = store.value("shade")
    if isinstance(old, str) and old in THEMES:
        store.setValue("window/theme", old)
    store.remove("shade")


MIGRATIONS: Final[dict[int, Callable[[Store], None]]] = {1: _from_1}
"""What leads from each schema to the next."""


def migrate(store: Store) -> bool:
    """Bring the settings to the present schema; return whether they are of a newer one, which is read as far as it is known."""
    stored = store.value("schema")
    if stored is None:
        store.setValue("schema", str(SCHEMA))
        return False
    try:
        schema = int(str(stored))
    except ValueError:
        schema = SCHEMA
    if schema > SCHEMA:
        return True
    for step in range(max(1, schema), SCHEMA):
        MIGRATIONS[step](store)
    if str(stored) != str(SCHEMA):
        store.setValue("schema", str(SCHEMA))
    return False
