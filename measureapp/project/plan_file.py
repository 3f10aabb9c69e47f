"""Scan plans given as files."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.plan import ScanPlan
from measureapp.errors import InputError


def read_plan(path: Path) -> ScanPlan:
    """Read a plan from JSON or TOML. Raises InputError naming the file and the field that is wrong."""
    try:
        text = Path(path).read_text(encoding="utf-8")
        document = tomllib.loads(text) if Path(path).suffix.lower() == ".toml" else json.loads(text)
        return ScanPlan.model_validate(document)
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the plan')}.", "Correct this field.") from error
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", "Give a scan plan as JSON or TOML.") from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} cannot be read as a scan plan: {error}.", "Give a plan as JSON or TOML.") from error
