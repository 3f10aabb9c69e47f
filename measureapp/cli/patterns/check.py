"""`patterns check`: predicted performance of a pattern set on a projector."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.patterns.options import (
    HeightOption,
    MeanOption,
    ModulationOption,
    SetArgument,
    WidthOption,
    parse_numbers,
    predictions,
    probability,
)
from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.fringe.patterns.check import Contrast, DirectionCheck


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def check(
        patterns: SetArgument,
        width: WidthOption = 1024,
        height: HeightOption = 768,
        mean: MeanOption = 110.0,
        modulation: ModulationOption = 80.0,
        full_well: Annotated[float, typer.Option("--full-well", help="Full well of the camera, in electrons.")] = 6000.0,
        read_noise: Annotated[float, typer.Option("--read-noise", help="Read noise of the camera, in electrons.")] = 7.0,
        saturation: Annotated[int, typer.Option("--saturation", help="Grey level of a saturated pixel.")] = 255,
        exposures: Annotated[str, typer.Option("--exposures", help="Unsaturated exposures, relative to the longest: 1,0.8,0.6.")] = "1",
        as_json: JsonOption = False,
    ) -> None:
        """Predict the performance of a set on a projector: range, guard band, phase noise, probability of wrong fringe orders.

        A set whose range is too small for the projector, or has no guard band, is refused with the reason.
        """
        from measureapp.fringe.patterns.check import check_patterns
        from measureapp.project.fringes.pattern_files import read_pattern_set

        made = read_pattern_set(patterns, width, height)
        contrast = _contrast(mean, modulation, full_well, read_noise, saturation, exposures)
        checks = check_patterns(made, width, height, contrast)
        lines = [made.name, *(line for one in checks for line in _lines(one))]
        reply({"name": made.name, "images": made.count, **predictions(checks)}, "\n".join(lines), as_json)


def _contrast(mean: float, modulation: float, full_well: float, read_noise: float, saturation: int, exposures: str) -> Contrast:
    from measureapp.errors import InputError
    from measureapp.fringe.noise.model import CameraNoise
    from measureapp.fringe.patterns.check import Contrast

    if not (full_well > 0 and read_noise >= 0):
        raise InputError(
            f"A full well of {full_well:g} with a read noise of {read_noise:g} electrons is impossible.",
            "Give a positive full well and a read noise of at least 0.",
        )
    return Contrast(
        mean, modulation, CameraNoise(full_well_e=full_well, read_noise_e=read_noise), saturation, parse_numbers("--exposures", exposures)
    )


def _lines(check: DirectionCheck) -> list[str]:
    lines = "columns" if check.direction == "vertical" else "rows"
    noise = ", ".join(f"{sigma:.4f}" for sigma in check.phase_sigma_rad)
    wanted = "; ".join(
        f"P ≤ {goal} " + (f"for B ≥ {modulation:.1f}" if modulation else "not reached") for goal, modulation in check.modulation_for.items()
    )
    return [
        f"{check.direction} fringes, {check.method}: range {check.range_px:.0f} px for {check.extent_px} {lines}, {check.guard_px:.0f} px guard band",
        f"  phase noise {noise} rad; σ of the result {check.column_sigma_px:.3f} px",
        *(f"  {d.what}: noise × {d.amplification:.1f}, P(wrong) {probability(d.error_probability)}" for d in check.decisions),
        f"  wrong fringe orders {probability(check.order_error_probability)}; {wanted}",
    ]
