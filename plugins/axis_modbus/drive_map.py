"""Maps of drives: registers, conditions and sequences as data, read from TOML files."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Literal

from pydantic import Field, ValidationError, model_validator

from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError

SHIPPED = Path(__file__).parent / "drives"
REQUIRED = ("position",)


class Register(Model):
    """One value of the drive."""

    address: int = Field(ge=0, le=65535)
    words: Literal[1, 2] = 1
    signed: bool = False
    kind: Literal["holding", "input", "coil", "discrete"] = "holding"
    certain: bool = Field(default=True, description="false: from memory or another model; compare with the manual")


class Condition(Model):
    """A statement about a register: its value under a mask equals, or differs from, a number."""

    register_name: str = Field(alias="register")
    mask: int = 0xFFFFFFFF
    equals: int | None = None
    differs: int | None = None

    @model_validator(mode="after")
    def _states_one(self) -> Condition:
        if (self.equals is None) == (self.differs is None):
            raise ValueError("give either equals or differs")
        return self

    def holds(self, value: int) -> bool:
        """Tell whether the statement is true for a value of the register."""
        masked = value & self.mask
        return masked == self.equals if self.equals is not None else masked != self.differs


class Step(Model):
    """One write of a sequence: a number, or the goal or speed in counts. ``bits``: only these are changed, the others are kept."""

    write: str
    value: int | Literal["goal", "speed"]
    bits: int | None = None


class DriveMap(Model):
    """All that the driver has to know of a drive."""

    name: str
    source: str = Field(description="where the numbers come from")
    framing: Literal["rtu", "ascii", "socket"]
    baudrate: int = 38400
    parity: Literal["N", "E", "O"] = "N"
    unit_id: int = 1
    word_order: Literal["high-first", "low-first"] = "high-first"
    counts_per_unit: float = Field(default=100.0, gt=0)
    speed_per_unit: float | None = Field(default=None, gt=0, description="register value of 1 mm/s or 1 degree/s; none: counts_per_unit")
    registers: dict[str, Register]
    conditions: dict[Literal["moving", "in_position", "alarm", "homed", "enabled"], Condition] = Field(default_factory=dict)
    sequences: dict[Literal["enable", "move", "stop", "home", "reset"], tuple[Step, ...]]
    identity: Condition | None = Field(default=None, description="holds for this drive at any time: proves that a reply is its own")
    alarms: dict[str, str] = Field(default_factory=dict, description="code of the register `alarm_code` to words")

    @model_validator(mode="after")
    def _is_complete(self) -> DriveMap:
        named = {step.write for steps in self.sequences.values() for step in steps}
        named |= {condition.register_name for condition in (*self.conditions.values(), *([self.identity] if self.identity else []))}
        missing = sorted((named | set(REQUIRED)) - set(self.registers))
        if missing:
            raise ValueError(f"registers.{missing[0]} is not described")
        for sequence in ("move", "stop"):
            if sequence not in self.sequences:
                raise ValueError(f"sequences.{sequence} is not described")
        if not any(step.value == "goal" for step in self.sequences["move"]):
            raise ValueError("sequences.move writes no goal")
        if "moving" not in self.conditions and "in_position" not in self.conditions:
            raise ValueError("conditions.moving or conditions.in_position is needed to know when a move has ended")
        return self

    @property
    def uncertain(self) -> tuple[str, ...]:
        """Names of registers that have to be compared with the manual."""
        return tuple(name for name, register in self.registers.items() if not register.certain)


def read_map(name_or_path: str) -> DriveMap:
    """Read a shipped map by its name, or one of a user by its path.

    Raises
    ------
    InputError
        There is none, or it does not fit; names the field.
    """
    path = Path(name_or_path) if name_or_path.endswith(".toml") else SHIPPED / f"{name_or_path}.toml"
    if not path.is_file():
        known = ", ".join(sorted(shipped.stem for shipped in SHIPPED.glob("*.toml")))
        raise InputError(f"There is no drive map {name_or_path!r}.", f"Name one of {known}, or the path of a map (.toml).")
    try:
        return DriveMap.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path} cannot be read as a drive map: {error}.", "Correct the file.") from error
    except ValidationError as error:
        raise InputError(
            f"{path}: {first_problem(error, 'the drive map')}.", "Correct this field; the README describes the form."
        ) from error
