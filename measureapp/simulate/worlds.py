"""Worlds from TOML files: those of `resources/worlds` by name, others by path.

A file states magnitudes of `WorldOptions`; what it does not state has its default, which is the world that the program's model describes
exactly. A world with a single effect is a trial of that effect. The key `known` is not of the world: it says what the owner of the rig
knows (`pipeline.sample`).
"""

from __future__ import annotations

import tomllib

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.sample_worlds import world_file
from measureapp.errors import InputError
from measureapp.simulate.options import WorldOptions

KNOWN = "known"


def read_world(name_or_path: str) -> WorldOptions:
    """Read a world by its name in `resources/worlds`, or from a TOML file.

    Raises
    ------
    InputError
        There is no such world, or its file cannot be read or states something unknown.
    """
    path = world_file(name_or_path)
    try:
        stated = tomllib.loads(path.read_text(encoding="utf-8"))
        return WorldOptions.model_validate({name: value for name, value in stated.items() if name != KNOWN})
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"The world {path} cannot be read: {error}.", "Give a TOML file such as those in resources/worlds.") from error
    except ValidationError as error:
        raise InputError(
            f"The world {path}: {first_problem(error, 'its values')}.", "Correct it; resources/worlds has examples."
        ) from error
