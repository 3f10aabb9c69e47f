"""Options and words that the commands share."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from measureapp.fringe.patterns.check import DirectionCheck

RARE = 1e-12

SetArgument = Annotated[str, typer.Argument(metavar="NAME-OR-FILE", help="A name of `patterns list`, or a pattern set as TOML or JSON.")]
WidthOption = Annotated[int, typer.Option("--width", help="Columns of the projector.")]
HeightOption = Annotated[int, typer.Option("--height", help="Rows of the projector.")]
MeanOption = Annotated[float, typer.Option("--mean", help="Mean grey level A of a pixel at the longest exposure.")]
ModulationOption = Annotated[float, typer.Option("--modulation", help="Modulation B of that pixel, in grey levels.")]


def promises(checks: tuple[DirectionCheck, ...]) -> dict[str, Any]:
    """Return what a set promises, by direction of its fringes."""
    return {"directions": {check.direction: asdict(check) for check in checks}}


def probability(value: float) -> str:
    """Return a probability in words; what noise does so rarely is decided by other things."""
    return f"{value:.1e}" if value >= RARE else f"< {RARE:.0e}"


def numbers(option: str, text: str) -> tuple[float, ...]:
    """Return the positive numbers of an option; raises InputError."""
    from measureapp.errors import InputError

    try:
        values = tuple(float(word) for word in text.split(","))
    except ValueError as error:
        raise InputError(f"{option} {text} is not a list of numbers.", "Separate numbers by commas.") from error
    if any(not 0 < value < 1e9 for value in values) or len(set(values)) < len(values):
        raise InputError(f"{option} {text} cannot be.", "Give different positive numbers.")
    return values
