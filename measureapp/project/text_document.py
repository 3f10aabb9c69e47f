"""Reading of TOML and JSON documents."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar, get_args

from pydantic import BaseModel, ValidationError

from measureapp.data.model import first_problem
from measureapp.errors import InputError, StorageError

ModelT = TypeVar("ModelT", bound=BaseModel)


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
        raise InputError(f"{path} cannot be read as {what}: {reason_of(error)}.", remedy) from error


def reason_of(error: Exception) -> str:
    """Return in words why a text cannot be parsed, or its values cannot be used."""
    match error:
        case UnicodeDecodeError():
            return "it is not a text file"
        case RecursionError():
            return "its values are nested too deeply"
        case KeyError():
            return f"{error} is missing"
        case TypeError() | AttributeError():
            return "its values are of other kinds"
        case OSError():
            return str(error.strerror or error)
    return str(error).rstrip(".")


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


def read_model(path: Path, kind: type[ModelT]) -> ModelT:
    """Read a JSON document of a project, which has a schema version. Raises StorageError when it is damaged or of a newer version."""
    document = _read_json(path)
    newest = get_args(kind.model_fields["schema_version"].annotation)[0]
    version = document.get("schema_version", newest) if isinstance(document, dict) else newest
    if version not in range(1, newest + 1):
        check_version(path, document, newest)
    try:
        return kind.model_validate(document)
    except ValidationError as error:
        raise StorageError(
            f"{path}: {first_problem(error, 'the file')}.", "Restore the file from a backup, or create a new project."
        ) from error


def _read_json(path: Path) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Restore the file from a backup, or create a new project.") from error
