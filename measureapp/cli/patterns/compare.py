"""`patterns compare`: pattern sets on parts of the virtual rig, compared with the ground truth."""

from __future__ import annotations

from dataclasses import asdict, replace
from typing import Annotated, Literal

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def compare(
        names: Annotated[
            list[str] | None, typer.Argument(metavar="NAME", help="Names of `patterns list`; default: all sets of vertical fringes.")
        ] = None,
        part: Annotated[list[str] | None, typer.Option("--part", help="Sample part or mesh file; may be given several times.")] = None,
        brightness: Annotated[
            list[float] | None,
            typer.Option("--brightness", help="Brightness of the projector relative to the default; may be given several times."),
        ] = None,
        resolution: Annotated[Literal["full", "half", "quarter"], typer.Option(help="Resolution of the cameras.")] = "half",
        seed: Annotated[int, typer.Option(min=0, help="Seed of the virtual rig's errors and noise.")] = 1,
        as_json: JsonOption = False,
    ) -> None:
        """Try pattern sets on parts of the virtual rig and compare with the true projector column of each pixel."""
        from measureapp.data.pattern_sets import PATTERN_SETS
        from measureapp.pattern_trial import Scene, run_trial

        scenes = tuple(
            Scene(name, resolution, seed, 1, light) for name in part or ["gear", "impeller"] for light in brightness or [1.0, 0.3]
        )
        chosen = names or [name for name, made in PATTERN_SETS.items() if made.directions == ("vertical",)]
        _check_names(chosen)
        progress, trials = TerminalProgress(), []
        for number, name in enumerate(chosen):
            for rule in ("paper", "combined"):
                progress.report(2 * number + (rule == "combined"), 2 * len(chosen), f"trying {name}")
                trials.append(replace(run_trial(scenes, PATTERN_SETS[name], rule), patterns=name))
        lines = [
            f"{t.patterns:<{max(map(len, chosen))}}  {t.rule:<8}  {t.images:3d} images  wrong fringe orders {t.wrong_share:7.1e}  "
            f"decoded {t.decoded_share:.2%}  error {t.column_error_px:.4f} px, {t.noise_ratio:.2f} × predicted"
            for t in trials
        ]
        reply({"scenes": [asdict(scene) for scene in scenes], "trials": [asdict(trial) for trial in trials]}, "\n".join(lines), as_json)


def _check_names(names: list[str]) -> None:
    """Raise InputError for a set that cannot be compared."""
    from measureapp.data.pattern_sets import PATTERN_SETS
    from measureapp.errors import InputError

    for name in names:
        if name not in PATTERN_SETS:
            raise InputError(f"There is no pattern set {name!r}.", f"Give names of `measureapp patterns list`: {', '.join(PATTERN_SETS)}.")
        if PATTERN_SETS[name].directions != ("vertical",):
            raise InputError(f"{name} has horizontal fringes, which cannot be compared here.", "Give a set of vertical fringes.")
