"""Files of scan plans."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.plan import ScanPlan
from measureapp.errors import InputError
from measureapp.project.text_document import read_toml_or_json


def read_plan(path: Path) -> ScanPlan:
    """Read a plan from JSON or TOML. Raises InputError naming the file and the invalid field."""
    document = read_toml_or_json(Path(path), "a scan plan", "Give a scan plan as JSON or TOML.")
    try:
        return ScanPlan.model_validate(document)
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the plan')}.", "Correct this field.") from error
