"""`patterns export`: images of a pattern set as PNG, for a real projector."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.patterns.options import (
    HeightOption,
    SetArgument,
    WidthOption,
    parse_numbers,
)
from measureapp.cli.reply import JsonOption, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def export(
        patterns: SetArgument,
        out: Annotated[Path, typer.Option("--out", help="Folder for the images.", file_okay=False)],
        width: WidthOption = 1024,
        height: HeightOption = 768,
        response: Annotated[Path | None, typer.Option("--response", help="Projector response to correct the sinusoids for.")] = None,
        cameras: Annotated[str, typer.Option("--cameras", help="Camera names in the manifest.")] = "left,right,upper",
        exposures: Annotated[str, typer.Option("--exposures", help="Exposures in the manifest, in µs.")] = "100000,80000,60000,40000,20000",
        as_json: JsonOption = False,
    ) -> None:
        """Write the images as PNG, numbered in the order of projection.

        patterns.json describes each image: kind, direction, pitch_px, step and shift_rad, or plane. MANIFEST.toml is for
        `measureapp decode`: store the camera images of pattern 007 as CAMERA/EXPOSURE/007.png in its folder.
        """
        from measureapp.fringe.patterns.check import check_patterns
        from measureapp.fringe.patterns.draw import pattern_images
        from measureapp.project.fringes.pattern_files import export_patterns, read_pattern_set
        from measureapp.project.fringes.response_file import read_response

        made = read_pattern_set(patterns, width, height)
        known = read_response(response) if response else None
        check_patterns(made, width, height)
        images = pattern_images(made, width, height, known)
        files = export_patterns(out, made, images, known.name if known else None, _names(cameras), _times(exposures))
        corrected = f", corrected for {known.name}" if known else ""
        reply(
            {"name": made.name, "files": files, "list": out / "patterns.json", "manifest": out / "MANIFEST.toml"},
            f"{made.name}: {len(files)} images of {width} × {height} px{corrected} → {out}",
            as_json,
        )


def _times(text: str) -> tuple[int, ...]:
    from measureapp.errors import InputError

    values = parse_numbers("--exposures", text)
    if any(value != round(value) for value in values):
        raise InputError(f"--exposures {text} are not whole microseconds.", "Give whole numbers of µs, separated by commas.")
    return tuple(sorted((round(value) for value in values), reverse=True))


def _names(text: str) -> tuple[str, ...]:
    from measureapp.errors import InputError

    names = tuple(word.strip() for word in text.split(","))
    if len(set(names)) < len(names) or not all(name.replace("-", "").replace("_", "").isalnum() and name.isascii() for name in names):
        raise InputError(f"--cameras {text} is not a list of unique names.", "Separate names of letters and digits by commas.")
    return names
