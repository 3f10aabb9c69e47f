"""`response`: intensity response of the projector, from recorded fringes or a grey ramp."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.fringe.patterns.harmonics import Waveform
    from measureapp.fringe.patterns.response import ProjectorResponse
    from measureapp.fringe.patterns.response_estimate import KeptError, PitchReport


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def response(
        recorded: Annotated[Path, typer.Argument(metavar="MANIFEST", help="MANIFEST.toml of recorded fringes, or .csv of a grey ramp.")],
        out: Annotated[Path, typer.Option("--out", help="Response file (JSON) to write.", dir_okay=False)],
        camera: Annotated[str | None, typer.Option("--camera", help="Camera whose images are used; default: the first.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Estimate the intensity response of the projector: gamma, harmonics, and the phase error they cause.

        Fringes of six or more steps (twelve are recommended) determine the harmonics and the response curve; fringes of three to
        five steps only the errors of their own phases, and need a scene with many fringes. A ramp is a CSV with the columns level
        (0…255, projected) and grey (mean of an unsaturated camera); it determines the curve.

        `patterns export --response` corrects the images to be projected, `decode --response` the recorded phases.
        """
        made, reports, used_camera = _estimate(recorded, camera)
        from measureapp.project.fringes.response_file import write_response

        write_response(out, made)
        reply(_document(made, reports, used_camera, out), "\n".join([*_lines(made, reports), f"→ {out}"]), as_json)


def _estimate(recorded: Path, camera: str | None) -> tuple[ProjectorResponse, tuple[PitchReport, ...], str | None]:
    from measureapp.errors import InputError
    from measureapp.fringe.patterns.response import response_of_ramp
    from measureapp.fringe.patterns.response_estimate import estimate_response
    from measureapp.project.fringes.manifest import read_manifest
    from measureapp.project.fringes.response_file import read_ramp

    if recorded.suffix.lower() == ".csv":
        return response_of_ramp(*read_ramp(recorded), name=recorded.stem), (), None
    stack = read_manifest(recorded)
    chosen = camera or next(iter(stack.images))
    if chosen not in stack.images:
        raise InputError(f"{recorded} has no camera {chosen!r}.", f"Give one of: {', '.join(stack.images)}.")
    return *estimate_response(stack, chosen, name=stack.viewpoint_id), chosen


def _document(made: ProjectorResponse, reports: tuple[PitchReport, ...], camera: str | None, out: Path) -> dict[str, Any]:
    return {
        "file": out,
        "camera": camera,
        "gamma": made.gamma,
        "curve": made.curve,
        "pitches": [
            {
                **{name: getattr(report, name) for name in ("direction", "pitch_px", "steps", "pixels")},
                "harmonics": [harmonic.model_dump() for harmonic in report.waveform],
                "phase_error": [asdict(kept) for kept in report.kept],
            }
            for report in reports
        ],
    }


def _lines(made: ProjectorResponse, reports: tuple[PitchReport, ...]) -> list[str]:
    gamma = made.gamma
    lines = [f"{made.name}: " + (f"gamma {gamma:.2f}" if gamma is not None else "no curve (fewer than six steps)")]
    for report in reports:
        lines.append(f"{report.pitch_px:g} px {report.direction}, {report.steps} steps, {report.pixels} px: {_harmonics(report.waveform)}")
        lines += [f"  {_describe_kept_error(kept)}" for kept in report.kept]
    return lines


def _harmonics(waveform: Waveform) -> str:
    words = ", ".join(f"harmonic {h.order}: {h.share:.2%} ± {h.spread:.2%}" for h in waveform)
    return words or "no significant harmonics"


def _describe_kept_error(kept: KeptError) -> str:
    corrected = "" if kept.with_rad is None else f", corrected {kept.with_rad:.4f}"
    measured = ""
    if kept.measured_without_rad is not None and kept.measured_with_rad is not None:
        measured = f" (measured with noise: {kept.measured_without_rad:.4f}, corrected {kept.measured_with_rad:.4f})"
    return f"{kept.steps} steps: phase error {kept.without_rad:.4f} rad rms{corrected}{measured}"
