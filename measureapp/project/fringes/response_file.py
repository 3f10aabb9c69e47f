"""Files of projector responses (JSON) and grey ramps (CSV)."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Literal

import numpy as np
from pydantic import ValidationError

from measureapp.arrays import FloatArray
from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError
from measureapp.fringe.patterns.response import ProjectorResponse
from measureapp.project.atomic import write_json
from measureapp.project.text_document import reason_of

RAMP_COLUMNS = ("level", "grey")


class _ResponseFile(Model):
    schema_version: Literal[1]
    response: ProjectorResponse


def write_response(path: Path, response: ProjectorResponse) -> None:
    """Write a response as JSON, atomically; raises StorageError."""
    write_json(path, {"schema_version": 1, "response": response.model_dump(mode="json")})


def read_response(path: Path) -> ProjectorResponse:
    """Read a response; raises InputError naming the file and the invalid field."""
    try:
        return _ResponseFile.model_validate(json.loads(Path(path).read_text(encoding="utf-8"))).response
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", "Give a file written by `measureapp response`.") from error
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the response')}.", "Give a file written by `measureapp response`.") from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} is not JSON: {reason_of(error)}.", "Give a file written by `measureapp response`.") from error


def read_ramp(path: Path) -> tuple[FloatArray, FloatArray]:
    """Read projected levels (N,) and measured mean grey levels (N,) from a CSV with the columns level and grey; raises InputError."""
    hint = "Write a CSV with the columns level (0…255) and grey, one line for each image of the ramp."
    try:
        with Path(path).open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", hint) from error
    except (ValueError, csv.Error) as error:
        raise InputError(f"{path} is not a CSV file.", hint) from error
    if not rows or any(column not in rows[0] for column in RAMP_COLUMNS):
        raise InputError(f"{path} has no columns level and grey.", hint)
    try:
        values = np.array([[float(row[column]) for column in RAMP_COLUMNS] for row in rows])
    except (ValueError, TypeError) as error:
        raise InputError(f"{path} has a line without two numbers.", hint) from error
    if not np.isfinite(values).all():
        raise InputError(f"{path} has a number that is not finite.", hint)
    return values[:, 0], values[:, 1]
