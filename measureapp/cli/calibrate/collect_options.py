"""The options of `calibrate collect`, in groups."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer


@dataclass(frozen=True, kw_only=True, slots=True)
class Recorded:
    """Recorded data with the images, or in their place."""

    fringes: Annotated[
        list[str] | None,
        typer.Option(help="For the projector, in place of --images: manifests of fringes on the board, such as 'fringes/*/MANIFEST.toml'."),
    ] = None
    views: Annotated[
        Path | None, typer.Option(help="Project whose stored views of the board are added; board and axis errors are then its rig's.")
    ] = None
    robot_poses: Annotated[Path | None, typer.Option(help="base_from_flange: one line per board position.")] = None
    guide_positions: Annotated[Path | None, typer.Option(help="Slide positions: one line per board position.")] = None
    angles: Annotated[Path | None, typer.Option(help="Table angles: one line per board position.")] = None


@dataclass(frozen=True, kw_only=True, slots=True)
class SessionStart:
    """Settings of a new session."""

    hand_eye: Annotated[Path | None, typer.Option(help="Calibrated hand-eye transform, for the guide.")] = None
    reference: Annotated[str | None, typer.Option(help="Reference camera; default: the first given.")] = None
    distortion: Annotated[int, typer.Option(help="Distortion coefficients: 4, 5 or 8.")] = 5
    standoff_mm: Annotated[float | None, typer.Option(min=1e-3, help="Distance at which parts are measured.")] = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Steps:
    """Actions on the session."""

    remove: Annotated[list[str] | None, typer.Option(help="Observation to remove; once per observation.")] = None
    undo: Annotated[bool, typer.Option("--undo", help="Undo the last change of the session.")] = False
    redo: Annotated[bool, typer.Option("--redo", help="Redo the last change that was undone.")] = False
    advise: Annotated[bool, typer.Option("--coach", help="Show guidance: what to show next.")] = False
    solve: Annotated[bool, typer.Option("--solve", help="Solve, and evaluate the result in mm.")] = False
    validate: Annotated[bool, typer.Option("--validate", help="Solve, and check cameras or projector with views held back.")] = False
    compare: Annotated[Path | None, typer.Option(help="Solve, and compare with a session or an earlier result.")] = None
    accept: Annotated[Path | None, typer.Option(help="Solve from scratch and save the result; for the rig a project or folder.")] = None
    valid_days: Annotated[float | None, typer.Option(min=0, help="Days after which an accepted calibration expires.")] = None
    temperature_c: Annotated[float | None, typer.Option(help="Temperature when the images were taken; default: as recorded.")] = None
    good_mm: Annotated[float | None, typer.Option(help="Expanded uncertainty (k = 2) up to which the verdict is good, mm.")] = None
    usable_mm: Annotated[float | None, typer.Option(help="The same up to which it is usable, mm; default: four times --good-mm.")] = None
