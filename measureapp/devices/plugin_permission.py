"""Permission for plugins that do not come with the program: code from elsewhere runs only after a person allowed exactly this code."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path

from measureapp.errors import PluginError
from measureapp.resources import plugin_folder

UNHASHED = ("__pycache__",)  # made anew by Python


def permission_file() -> Path:
    """Return the file that keeps the permissions of this user."""
    return Path.home() / "MeasureApp" / "allowed_plugins.json"


def fingerprint(folder: Path) -> str:
    """Return the SHA-256 of all files of a plugin, of their names and contents, as 64 hexadecimal digits."""
    total = sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file() and not any(part in UNHASHED for part in path.relative_to(folder).parts):
            total.update(path.relative_to(folder).as_posix().encode() + b"\0")
            total.update(sha256(path.read_bytes()).digest())
    return total.hexdigest()


def is_allowed(folder: Path) -> bool:
    """Return whether a plugin comes with the program, or was allowed as it is now."""
    return folder.resolve().parent == plugin_folder().resolve() or _read().get(str(folder.resolve())) == fingerprint(folder)


def allow(folder: Path, seen: str | None = None) -> str:
    """Allow the plugin in ``folder`` as it is now, and return its fingerprint; any later change withdraws the permission.

    Parameters
    ----------
    seen : fingerprint that a person agreed to; None: that of now

    Raises
    ------
    PluginError
        The plugin has changed since it was ``seen``, or the permissions cannot be stored.
    """
    found = fingerprint(folder)
    if seen not in (None, found):
        raise PluginError(f"The files in {folder} have changed since you were asked.", "Inspect them, then allow the driver again.")
    path = permission_file()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(_read() | {str(folder.resolve()): found}, indent=2), encoding="utf-8")
    except OSError as error:
        raise PluginError(f"{path} cannot be written: {error}.", "Check the permissions of this folder.") from error
    return found


def _read() -> dict[str, str]:
    """Return the fingerprints allowed, by folder; a damaged file allows nothing."""
    try:
        found = json.loads(permission_file().read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}
