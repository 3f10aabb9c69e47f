"""The base of every value that comes from a file: frozen, and unknown fields are refused by name; and how to say what is wrong with one."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, ValidationError


class Model(BaseModel):
    """A frozen pydantic model that refuses unknown fields and numbers that are not finite."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


def first_problem(error: ValidationError, whole: str) -> str:
    """Return place and reason of the first thing that is wrong, as part of a sentence; ``whole`` stands for a place without a name."""
    problem = error.errors()[0]
    place = ".".join(str(part) for part in problem["loc"])
    reason = "is not known here" if problem["type"] == "extra_forbidden" else problem["msg"].removeprefix("Value error, ")
    return f"{place or whole}: {reason}"
