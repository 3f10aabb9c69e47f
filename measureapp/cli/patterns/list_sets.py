"""`patterns list`: predefined pattern sets and their predicted performance."""

from __future__ import annotations

import typer

from measureapp.cli.patterns.options import (
    HeightOption,
    MeanOption,
    ModulationOption,
    WidthOption,
    predictions,
    probability,
)
from measureapp.cli.reply import JsonOption, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command(name="list")
    def list_sets(
        width: WidthOption = 1024,
        height: HeightOption = 768,
        mean: MeanOption = 110.0,
        modulation: ModulationOption = 80.0,
        as_json: JsonOption = False,
    ) -> None:
        """List the predefined pattern sets for a projector, with their predicted performance at a contrast."""
        from measureapp.data.pattern_sets import make_pattern_sets
        from measureapp.fringe.patterns.check import Contrast, check_patterns
        from measureapp.project.fringes.pattern_files import check_size

        check_size(width, height)
        contrast = Contrast(mean, modulation)
        sets = {name: (made, check_patterns(made, width, height, contrast)) for name, made in make_pattern_sets(width, height).items()}
        document = {name: {"name": made.name, "images": made.count, **predictions(checks)} for name, (made, checks) in sets.items()}
        longest = max(len(name) for name in sets)
        lines = [
            f"{name:<{longest}}  {made.count:3d} images, σ {checks[0].column_sigma_px:.3f} px, "
            f"P(wrong order) {probability(checks[0].order_error_probability):>7}  {made.name}"
            for name, (made, checks) in sets.items()
        ]
        reply({"contrast": {"mean": mean, "modulation": modulation}, "sets": document}, "\n".join(lines), as_json)
