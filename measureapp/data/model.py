"""Base of all values read from files: immutable, unknown fields refused by name; and messages about invalid ones."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, ValidationError


class Model(BaseModel):
    """An immutable pydantic model that refuses unknown fields and non-finite numbers."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


def first_problem(error: ValidationError, whole: str) -> str:
    """Return field and reason of the first validation error, as part of a sentence; ``whole`` names an error without a field."""
    problem = error.errors()[0]
    place = ".".join(str(part) for part in problem["loc"])
    reason = "is not a known field" if problem["type"] == "extra_forbidden" else problem["msg"].removeprefix("Value error, ")
    return f"{place or whole}: {reason}"
