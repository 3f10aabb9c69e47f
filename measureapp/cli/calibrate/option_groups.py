"""Options that belong together as one parameter of a command."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from dataclasses import MISSING, Field, fields, is_dataclass
from typing import Any, get_type_hints


def with_groups(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command every option of each parameter that is a dataclass; the parameter receives them as one value.

    The fields of such a dataclass are annotated as options are; a field may be such a dataclass itself.
    """
    hints = get_type_hints(command, include_extras=True)
    parameters: list[inspect.Parameter] = []
    for name, parameter in inspect.signature(command).parameters.items():
        if is_dataclass(hints[name]):
            parameters += _options(hints[name])
        else:
            parameters.append(parameter.replace(annotation=hints[name], kind=inspect.Parameter.KEYWORD_ONLY))
    groups = {name: hint for name, hint in hints.items() if is_dataclass(hint)}

    @functools.wraps(command)
    def wrapped(**given: Any) -> None:
        command(**given | {name: _take(group, given) for name, group in groups.items()})

    wrapped.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters} | {"return": None}
    wrapped.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    return wrapped


def _options(group: Any) -> list[inspect.Parameter]:
    hints = get_type_hints(group, include_extras=True)
    found: list[inspect.Parameter] = []
    for field in fields(group):
        if is_dataclass(hints[field.name]):
            found += _options(hints[field.name])
        else:
            found.append(_option(field, hints[field.name]))
    return found


def _option(field: Field[Any], annotation: Any) -> inspect.Parameter:
    default = inspect.Parameter.empty if field.default is MISSING else field.default
    return inspect.Parameter(field.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def _take(group: Any, given: dict[str, Any]) -> Any:
    """Return the group of its options, which are removed from ``given``."""
    hints = get_type_hints(group, include_extras=True)
    return group(
        **{
            field.name: _take(hints[field.name], given) if is_dataclass(hints[field.name]) else given.pop(field.name)
            for field in fields(group)
        }
    )
