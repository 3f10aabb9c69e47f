"""Command tables of controllers as data: line format, queries, conditions and sequences, read from TOML files."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Literal

from pydantic import Field, ValidationError, field_validator, model_validator

from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError

SHIPPED = Path(__file__).parent / "controllers"
PLACES = {"axis": 1, "before": 0, "goal": "0", "sign": "+", "magnitude": "0", "speed": "0", "acceleration": "0"}


class Query(Model):
    """A question and the form of its answer: a regular expression with named groups that matches the whole line.

    ``{axis}`` and ``{before}`` (the number of axes before this one) are replaced in both.
    """

    send: str
    reply: str

    @model_validator(mode="after")
    def _has_groups(self) -> Query:
        if not self.pattern(1).groupindex:
            raise ValueError("reply needs a named group, such as (?P<value>…)")
        return self

    def pattern(self, axis: int) -> re.Pattern[str]:
        """Return the form of the answer for one axis."""
        try:
            return re.compile(self.reply.replace("{axis}", str(axis)).replace("{before}", str(axis - 1)))
        except re.error as error:
            raise ValueError(f"reply is not a regular expression: {error}") from error


class Condition(Model):
    """A statement about a named group of an answer: it matches, or differs from, a regular expression."""

    query: str
    group: str = "value"
    matches: str | None = None
    differs: str | None = None

    @model_validator(mode="after")
    def _states_one(self) -> Condition:
        if (self.matches is None) == (self.differs is None):
            raise ValueError("give either matches or differs")
        return self

    def holds(self, groups: dict[str, str]) -> bool:
        """Return whether the statement is true for an answer."""
        found = re.fullmatch(self.matches if self.matches is not None else self.differs or "", groups[self.group]) is not None
        return found if self.matches is not None else not found


class CommandTable(Model):
    """All that the driver has to know of a controller."""

    name: str
    source: str = Field(description="where the commands come from")
    uncertain: tuple[str, ...] = Field(default=(), description="queries and sequences to be compared with the manual")
    baudrate: int = 9600
    terminator: str = Field(default="\r\n", description="end of a command")
    reply_end: str = Field(default="\r\n", min_length=1, description="end of an answer")
    echo: bool = Field(default=False, description="the controller repeats every command before it answers")
    acknowledge: str = Field(default="", description="answer to every command of a sequence, as a regular expression; empty: none")
    pause_s: float = Field(default=0.0, ge=0, le=1, description="after a command that has no answer; a stop does not wait for it")
    counts_per_unit: float = Field(default=1.0, gt=0, description="counts per degree; 1 where the controller works in degrees")
    decimals: int = Field(default=0, ge=0, le=9, description="of a goal and a speed")
    turns: Literal["unlimited", "modulo"] = Field(default="unlimited", description="modulo: the position returns to 0 after one turn")
    sense: Literal[1, -1] = Field(default=1, description="-1: counts grow clockwise seen from above")
    queries: dict[str, Query]
    conditions: dict[Literal["moving", "alarm", "homed", "enabled", "refused", "identity"], Condition]
    sequences: dict[Literal["enable", "speed", "move", "stop", "home"], tuple[str, ...]]
    errors: dict[str, str] = Field(default_factory=dict, description="codes of refusals and alarms, and what they mean")

    @field_validator("acknowledge")
    @classmethod
    def _compiles(cls, pattern: str) -> str:
        try:
            re.compile(pattern)
        except re.error as error:
            raise ValueError(f"is not a regular expression: {error}") from error
        return pattern

    @model_validator(mode="after")
    def _is_complete(self) -> CommandTable:
        if "position" not in self.queries or "value" not in self.queries["position"].pattern(1).groupindex:
            raise ValueError("queries.position with a group value is not described")
        for name, condition in self.conditions.items():
            query = self.queries.get(condition.query)
            if query is None or condition.group not in query.pattern(1).groupindex:
                raise ValueError(f"conditions.{name} names a query or group that is not described")
        if not {"moving", "refused"} <= set(self.conditions) and not (self.acknowledge and "moving" in self.conditions):
            raise ValueError(
                "conditions.moving, and conditions.refused or acknowledge, are needed: nothing is believed that was not read back"
            )
        missing = sorted({"move", "stop"} - set(self.sequences))
        if missing:
            raise ValueError(f"sequences.{missing[0]} is not described")
        if not any("{goal}" in text or "{magnitude}" in text for text in self.sequences["move"]):
            raise ValueError("sequences.move sends no goal")
        self._check_places()
        return self

    def _check_places(self) -> None:
        for text in (*(query.send for query in self.queries.values()), *(text for texts in self.sequences.values() for text in texts)):
            try:
                text.format(**PLACES)
            except (KeyError, IndexError, ValueError) as error:
                raise ValueError(f"command {text!r} has an unknown place {error} (known: {', '.join(PLACES)})") from error


def read_table(name_or_path: str) -> CommandTable:
    """Read a shipped command table by its name, or one of a user by its path.

    Raises
    ------
    InputError
        There is none, or it does not fit; names the field.
    """
    path = Path(name_or_path) if name_or_path.endswith(".toml") else SHIPPED / f"{name_or_path}.toml"
    if not path.is_file():
        known = ", ".join(sorted(shipped.stem for shipped in SHIPPED.glob("*.toml")))
        raise InputError(f"There is no command table {name_or_path!r}.", f"Name one of {known}, or the path of a table (.toml).")
    try:
        return CommandTable.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path} cannot be read as a command table: {error}.", "Correct the file.") from error
    except ValidationError as error:
        raise InputError(
            f"{path}: {first_problem(error, 'the command table')}.", "Correct this field; the README describes the form."
        ) from error
