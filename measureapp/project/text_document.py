"""Documents that people write: TOML, or JSON."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

from measureapp.errors import InputError


def read_toml(path: Path, remedy: str) -> dict[str, Any]:
    """Return what a TOML file holds.

    Parameters
    ----------
    remedy : what to give instead of a file that cannot be read

    Raises
    ------
    InputError
        The file cannot be read, is no text, or is not TOML; then the line is named.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", remedy) from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path} is not a text file.", remedy) from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path} is not valid TOML: {error}.", "Correct the line named.") from error


def read_toml_or_json(path: Path, what: str, remedy: str) -> Any:
    """Return what a file holds that is TOML by its ending, and JSON else.

    Parameters
    ----------
    what : what it should be, with its article
    remedy : what to give instead

    Raises
    ------
    InputError
        The file cannot be read, or is not what its ending says.
    """
    try:
        text = path.read_text(encoding="utf-8")
        return tomllib.loads(text) if path.suffix.lower() == ".toml" else json.loads(text)
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", remedy) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} cannot be read as {what}: {error}.", remedy) from error
