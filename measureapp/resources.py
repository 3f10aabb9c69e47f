"""Files shipped with the program: rigs, sample parts, templates, driver plugins."""

from __future__ import annotations

from pathlib import Path

from measureapp.errors import InputError

PACKAGE = Path(__file__).resolve().parent
ROOTS = (PACKAGE.parent, PACKAGE / "_checkout")  # the checkout; the same folders inside an installed wheel


def resource(path: str | Path) -> Path:
    """Return the location of ``path``, relative to the folder `resources`.

    Raises
    ------
    InputError
        There is no such file.
    """
    return _find_shipped(Path("resources") / path)


def plugin_folder() -> Path:
    """Return the folder of the driver plugins shipped with the program; raises InputError when it is missing."""
    return _find_shipped(Path("plugins"))


def user_plugin_folder() -> Path:
    """Return the folder in which this user's own plugins are searched; it need not exist."""
    return Path.home() / "MeasureApp" / "plugins"


def _find_shipped(path: Path) -> Path:
    for root in ROOTS:
        if (root / path).exists():
            return root / path
    raise InputError(
        f"The program has no file {path.as_posix()}.", "Check the name; if it is correct, the installation is incomplete: install again."
    )
