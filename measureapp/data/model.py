"""Base of all values read from files: immutable, unknown fields refused by name; and messages about invalid ones."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from functools import cache
from typing import Any, get_args

from pydantic import BaseModel, ConfigDict, SecretStr, ValidationError, model_validator

NONE = "none"  # TOML has no null


class Model(BaseModel):
    """An immutable pydantic model that refuses unknown fields and non-finite numbers."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    @model_validator(mode="before")
    @classmethod
    def _understands_none(cls, values: Any) -> Any:
        """Take the word "none" for no value, where a value may be missing and cannot be a text."""
        if not isinstance(values, Mapping):
            return values
        absent = {name: None for name in may_be_none(cls) if isinstance(values.get(name), str) and values[name] == NONE}
        return {**values, **absent} if absent else values


@cache
def may_be_none(model: type[BaseModel]) -> tuple[str, ...]:
    """Return the fields for which a file can say "none"."""
    kinds = {name: get_args(field.annotation) for name, field in model.model_fields.items()}
    return tuple(name for name, options in kinds.items() if type(None) in options and str not in options)


def toml_values(model: Model) -> dict[str, Any]:
    """Return the values of a model as TOML can hold them: without what has its default value, with "none" for a missing value.

    Passwords are in clear. The model can be validated from the result again and is then the same.
    """
    short: dict[str, Any] = _plain(model.model_dump(exclude_defaults=True))
    try:
        if type(model).model_validate(short) == model:
            return short
    except ValidationError:  # a default value decides which model a value belongs to
        pass
    whole: dict[str, Any] = _plain(model.model_dump())
    return whole


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(name): _plain(inner) for name, inner in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(inner) for inner in value]
    if isinstance(value, SecretStr):
        return value.get_secret_value()
    if isinstance(value, Enum):
        return value.value
    return NONE if value is None else value


def first_problem(error: ValidationError, whole: str) -> str:
    """Return field and reason of the first validation error, as part of a sentence; ``whole`` names an error without a field."""
    problem = error.errors()[0]
    place = ".".join(str(part) for part in problem["loc"])
    reason = "is not a known field" if problem["type"] == "extra_forbidden" else problem["msg"].removeprefix("Value error, ")
    return f"{place or whole}: {reason}"
