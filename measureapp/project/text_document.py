"""Reading of TOML and JSON documents."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from measureapp.errors import InputError, StorageError


def read_toml(path: Path, remedy: str) -> dict[str, Any]:
    """Read a TOML file.

    Parameters
    ----------
    remedy : hint for a file that cannot be read

    Raises
    ------
    InputError
        The file cannot be read, is not text, or is not TOML (names the line).
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", remedy) from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path} is not a text file.", remedy) from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path} is not valid TOML: {error}.", "Correct the line named.") from error
    except RecursionError as error:
        raise InputError(f"{path} is not valid TOML: its values are nested too deeply.", remedy) from error


def read_toml_or_json(path: Path, what: str, remedy: str) -> Any:
    """Read a TOML file, by its extension, or a JSON file.

    Parameters
    ----------
    what : expected content, with its article
    remedy : hint for a file that cannot be read

    Raises
    ------
    InputError
        The file cannot be read, or is not in the format of its extension.
    """
    try:
        text = path.read_text(encoding="utf-8")
        return tomllib.loads(text) if path.suffix.lower() == ".toml" else json.loads(text)
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", remedy) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} cannot be read as {what}: {error}.", remedy) from error


def check_version(path: Path, document: Mapping[str, Any], version: int) -> None:
    """Raise StorageError where a document of a project was written by a newer version of the program."""
    found = document.get("schema_version", version)
    if isinstance(found, int) and not isinstance(found, bool) and found > version:
        raise StorageError(
            f"{path} was written by a newer version of MeasureApp (format {found}; this version reads format {version}).",
            "Use the version of MeasureApp that wrote it.",
        )
    if found != version:
        raise StorageError(f"{path} has the unknown format {found!r}.", "Restore the file from a backup.")
