"""Required limits of a calibration: the option, and their part of an answer."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.calibrate.rig.limits import Limit

LimitOption = Annotated[
    list[str] | None,
    typer.Option(
        "--limit",
        help="Standard deviation required of a figure, such as 'axis position=0.01'; once per figure. Exit code 1 where images and cameras "
        "exceed it; `limits` in the answer has the names and the usual values.",
    ),
]


@dataclass(frozen=True, slots=True)
class RequiredLimits:
    """Limits given by the user in place of the usual ones."""

    limit: LimitOption = None

    def values(self, figures: Sequence[str]) -> dict[str, float]:
        """Return figure -> required standard deviation. Raises InputError for a figure that is not among ``figures`` or a value that is no length."""
        asked = {}
        for option in self.limit or ():
            name, (_, given, text) = _name(option), option.partition("=")
            try:
                value = float(text)
            except ValueError:
                value = math.nan
            if not given or name not in figures or not 0 < value < math.inf:
                raise InputError(
                    f"--limit {option!r} names no figure of this calibration with a value above 0.",
                    f"Give it as '{figures[0]}=0.01'; there are: {', '.join(figures)}.",
                )
            asked[name] = value
        return asked

    def exit_unless_met(self, limits: Sequence[Limit]) -> None:
        """End with exit code 1 where a figure that the option names is not met beyond what the rig's axes allow, or could not be determined."""
        if {_name(option) for option in self.limit or ()} - {one.name for one in limits if one.met_beyond}:
            raise typer.Exit(OUT_OF_TOLERANCE)


def _name(option: str) -> str:
    return option.partition("=")[0].strip()


def limits_answer(limits: Sequence[Limit]) -> dict[str, Any]:
    """Return their part of the JSON answer."""
    return {
        "limits": [
            {
                "name": one.name,
                "unit": one.unit,
                "asked": one.asked,
                "sigma": one.sigma,
                "axes_allow": one.axes_allow,
                "images_and_cameras_add": one.beyond,
                "images_alone_add": one.by_images,
                "met": one.met,
                "met_beyond_axes": one.met_beyond,
                "sentence": one.sentence,
            }
            for one in limits
        ]
    }


def limit_lines(limits: Sequence[Limit]) -> list[str]:
    """Return them for people."""
    return [f"  {one.sentence}" for one in limits]
