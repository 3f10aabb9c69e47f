"""Names of the worlds that the virtual rig can be in: how well rig and part are made (`resources/worlds`, decision 31)."""

from __future__ import annotations

from pathlib import Path

from measureapp.errors import InputError
from measureapp.resources import resource

IDEAL = "ideal"  # what the program's model describes exactly
DEFAULT_WORLD = "usual"  # of the demo: its figures are those of a rig as it is found in a workshop
WORLDS = (IDEAL, "good", "usual", "bad")


def world_file(name_or_path: str) -> Path:
    """Return the file of a world in `resources/worlds`, or the path of another TOML file as it is.

    Raises
    ------
    InputError
        There is no such world.
    """
    if Path(name_or_path).suffix:
        return Path(name_or_path)
    names = {path.stem: path for path in resource("worlds").glob("*.toml")}
    if name_or_path not in names:
        raise InputError(f"There is no world {name_or_path!r}.", f"Name one of {', '.join(sorted(names))}, or a TOML file.")
    return names[name_or_path]
