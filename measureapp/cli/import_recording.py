"""`import`: recordings of other rigs become projects."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.outcome import measurement_lines, report_event
from measureapp.cli.reply import JsonOption, TerminalProgress, reply
from measureapp.data.verdicts import has_passed

if TYPE_CHECKING:
    from collections.abc import Mapping

    from measureapp.project.folder import ProjectFolder

STAGES = {
    "cameras": "Cameras",
    "hand_eye": "Hand–eye",
    "guide": "Linear guide",
    "axis": "Table axis",
    "rig": "Rig",
    "clouds": "Clouds",
    "stitch": "Stitching",
    "dimensions": "Dimensions",
}
"""Stages of processing, in their order, as they are printed."""


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command(name="import")
    def import_command(
        recording: Annotated[Path, typer.Argument(help="RECORDING.toml that describes images and read-backs of a rig.")],
        into: Annotated[Path, typer.Option("--into", help="Folder of the new project.")],
        as_json: JsonOption = False,
    ) -> None:
        """Make a project of images and read-backs that another rig recorded; `process` does the rest.

        RECORDING.toml names a rig description with driver = "recorded" (rig = "rig.toml"), the calibration board ([board] with
        kind, inner_corners, square_mm and an optional certificate), one [[board_view]] per position of the board (images = { camera
        = "file" }, on_table), one [[viewpoint]] per view of the part (id, manifest), each with base_from_flange = { position_mm,
        quaternion_wxyz }, guide_mm and table_deg as read back, and [part] with nominal and program. Paths are relative to the file.

        An axis that the rig does not have appears nowhere. With cameras = "cameras.json" the cameras are known, and neither board
        views nor a rig description is needed. What is missing for which stage is stated; the other stages are processed.
        """
        from measureapp.pipeline.recording.store import import_recording

        made = import_recording(recording, into, TerminalProgress())
        document: dict[str, Any] = {
            "project": made.project.path,
            "board_views": made.board_views,
            "viewpoints": made.viewpoints,
            "missing": made.missing,
            "already_there": made.was_there,
        }
        done = "were imported before; nothing was changed" if made.was_there else "imported"
        lines = [
            f"{into}: {_count(made.board_views, 'board view')} and {_count(made.viewpoints, 'viewpoint')} {done}.",
            *stage_lines(made.missing, "not possible"),
        ]
        reply(document, "\n".join([*lines, f"Next: measureapp process {into}"]), as_json)


def process_imported(folder: ProjectFolder, language: str, as_json: bool) -> None:
    """Process an imported project as far as its recording suffices, with the report in a language, and answer."""
    from measureapp.pipeline.recording.process import process_recording

    outcome = process_recording(folder, report_event, TerminalProgress(), language)
    lines = _partial_lines(outcome.document) if outcome.whole is None else measurement_lines(outcome.whole.measurement)
    lines += [*stage_lines(outcome.missing, "not possible"), *stage_lines(outcome.failed, "failed")]
    reply(outcome.document, "\n".join(lines), as_json)
    if outcome.failed or not (outcome.whole is None or has_passed(outcome.whole.measurement)):
        raise typer.Exit(OUT_OF_TOLERANCE)


def stage_lines(reasons: Mapping[str, str], what: str) -> list[str]:
    """Return one line per stage that is not possible or failed; stages of one reason share a line."""
    stages: dict[str, list[str]] = {}
    for stage, words in STAGES.items():
        if stage in reasons:
            stages.setdefault(reasons[stage], []).append(words)
    return [f"  {', '.join(names)} {what}: {reason}" for reason, names in stages.items()]


def _count(number: int, what: str) -> str:
    return f"{number} {what}" + ("" if number == 1 else "s")


def _partial_lines(document: Mapping[str, Any]) -> list[str]:
    """Return the summary of what was done without a measurement."""
    calibration = document["calibration"]
    rms = ", ".join(f"{name} {camera['rms_px']:.3f} px" for name, camera in calibration["cameras"].items() if camera["rms_px"])
    lines = [f"Cameras: {rms or 'as given'}."]
    if (hand_eye := calibration.get("hand_eye")) is not None:
        lines.append(f"Hand–eye: residual {hand_eye['residual_mm']:.3f} mm.")
    if (guide := calibration.get("guide")) is not None:
        lines.append(f"Linear guide: scale {guide['scale']:.6f}.")
    if (axis := calibration.get("axis")) is not None:
        lines.append(f"Table axis: residual {axis['residual_mm']:.3f} mm.")
    for view in document["views"]:
        lines.append(
            f"{view['name']}: {view['points']:,} points in the camera frame, depth {view['depth_mm']['p50']:.2f} mm → {view['file']}"
        )
    return lines
