"""Options common to the commands of `patterns`."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from measureapp.fringe.patterns.check import DirectionCheck

RARE = 1e-12

SetArgument = Annotated[str, typer.Argument(metavar="NAME-OR-FILE", help="Name from `patterns list`, or pattern set as TOML or JSON.")]
WidthOption = Annotated[int, typer.Option("--width", help="Width of the projector image in pixels.")]
HeightOption = Annotated[int, typer.Option("--height", help="Height of the projector image in pixels.")]
MeanOption = Annotated[float, typer.Option("--mean", help="Mean grey level A of a pixel at the longest exposure.")]
ModulationOption = Annotated[float, typer.Option("--modulation", help="Modulation B of that pixel, in grey levels.")]


def predictions(checks: tuple[DirectionCheck, ...]) -> dict[str, Any]:
    """Return the predicted performance of a set, by direction of its fringes."""
    return {"directions": {check.direction: asdict(check) for check in checks}}


def probability(value: float) -> str:
    """Format a probability; below `RARE` other effects than noise dominate."""
    return f"{value:.1e}" if value >= RARE else f"< {RARE:.0e}"


def parse_numbers(option: str, text: str) -> tuple[float, ...]:
    """Parse the positive numbers of an option; raises InputError."""
    from measureapp.errors import InputError

    try:
        values = tuple(float(word) for word in text.split(","))
    except ValueError as error:
        raise InputError(f"{option} {text} is not a list of numbers.", "Separate numbers by commas.") from error
    if any(not 0 < value < 1e9 for value in values) or len(set(values)) < len(values):
        raise InputError(f"{option} {text} is invalid.", "Give different positive numbers.")
    return values
