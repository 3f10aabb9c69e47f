"""Command tables of controllers: what is sent and how replies are read, as data from TOML files."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

from pydantic import Field, ValidationError, field_validator

from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError

SHIPPED = Path(__file__).parent / "tables"


class Commands(Model):
    """What is sent; ``{goal}`` stands for the goal."""

    position: str
    move: tuple[str, ...] = Field(min_length=1, description="one or several, in this order")
    stop: str
    state: str
    home: tuple[str, ...] = ()
    error: str = Field(default="", description="asked after every command that changes something; empty: never")


class Replies(Model):
    """Regular expressions for replies. ``position`` has a group ``value``."""

    position: str
    at_rest: str = Field(description="of the state: the table is at rest")
    referenced: str = Field(default="", description="of the state: the reference is known; empty: always")
    no_error: str = Field(default="", description="of the error")

    @field_validator("position", "at_rest", "referenced", "no_error")
    @classmethod
    def _compiles(cls, value: str) -> str:
        try:
            re.compile(value)
        except re.error as error:
            raise ValueError(f"is no regular expression ({error})") from error
        return value

    @field_validator("position")
    @classmethod
    def _has_value(cls, value: str) -> str:
        if "value" not in re.compile(value).groupindex:
            raise ValueError("needs a group (?P<value>…)")
        return value


class CommandTable(Model):
    """All that the driver has to know of a controller."""

    name: str
    source: str = Field(description="where the commands come from")
    certain: bool = Field(default=True, description="false: from memory; compare with the manual")
    baudrate: int
    sent_end: str = Field(default="\r", description="ends what is sent")
    reply_end: str = Field(default="\r\n", description="ends replies")
    answers_commands: bool = Field(default=False, description="commands that change something are answered, too")
    counts_per_degree: float = Field(default=1.0, gt=0)
    digits: int = Field(default=4, ge=0, le=9, description="after the point of a goal")
    commands: Commands
    replies: Replies


def read_table(name_or_path: str) -> CommandTable:
    """Read a shipped table by its name, or one of a user by its path.

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
        raise InputError(f"{path}: {first_problem(error, 'the command table')}.", "Correct this field.") from error
