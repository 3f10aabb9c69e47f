"""`calibrate projector`: the projector as an inverse camera, from fringes on a board."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.camera_quality import quality_answer, quality_lines, validation_of
from measureapp.cli.calibrate.limits import RequiredLimits, limit_lines, limits_answer
from measureapp.cli.calibrate.made_from import MadeFrom, made_from
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import BoardChoice, CamerasOption, OutOption
from measureapp.cli.reply import JsonOption, TerminalProgress, reply
from measureapp.errors import InputError
from measureapp.progress import PartOf

if TYPE_CHECKING:
    from measureapp.calibrate.cameras.projector import HeadSolution
    from measureapp.data.calibration import CameraArrayCalibration
    from measureapp.data.fringe import FringeStack


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def projector(
        ctx: typer.Context,
        board: BoardChoice,
        asked: RequiredLimits,
        manifests: Annotated[list[Path], typer.Argument(help="MANIFEST.toml of the fringes on the board, one per board position.")],
        cameras: CamerasOption = None,
        projector_px: Annotated[
            str | None, typer.Option("--projector-px", help="Columns x rows of the projector, such as 1024x768; default: of the manifests.")
        ] = None,
        distortion: Annotated[int, typer.Option(help="Distortion coefficients of the projector: 4, 5 or 8.")] = 5,
        out: OutOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Calibrate the projector from vertical and horizontal fringes on a board, and save it to cameras.json.

        With --cameras these stay as they are and the projector is added; their covariance in cameras.json is propagated. Without,
        cameras and projector are calibrated together. The board is found in the mean of the sinusoidal images. Views held back test
        the stated standard deviations. Save to another file than --cameras, so that `calibrate again` finds its inputs unchanged.
        """
        from measureapp.calibrate.rig.limits import projector_limits
        from measureapp.pipeline.projector import ProjectorRequest, calibrate_projector
        from measureapp.project.calibration.camera_file import read_cameras, write_cameras
        from measureapp.project.fringes.manifest import manifest_files

        wanted = asked.values(("projector position", "projector rotation"))
        for path in manifests:  # a file that is no manifest is refused before the first of many images is read
            manifest_files(path)
        request = ProjectorRequest(
            board=board.description(),
            cameras=None if cameras is None else read_cameras(cameras),
            projector_px=None if projector_px is None else _size(projector_px),
            distortion_count=distortion,
        )
        progress = TerminalProgress()
        head = calibrate_projector(_stacks(manifests), len(manifests), request, PartOf(progress, 0.0, 0.8))
        quality = validation_of(head.problem, head.solution, PartOf(progress, 0.8, 1.0))
        calibration = head.calibration
        if out is not None:
            write_cameras(out, _with_date(calibration, made_from(ctx, out)))
        limits = projector_limits(head, wanted)
        document = projector_answer(head, manifests) | quality_answer(quality) | limits_answer(limits)
        document["files"] = {} if out is None else {"cameras": out}
        reply(document, "\n".join([*_lines(document), *quality_lines(quality), *limit_lines(limits), *_saved_lines(document)]), as_json)
        asked.exit_unless_met(limits)


def _stacks(manifests: Sequence[Path]) -> Iterator[FringeStack]:
    from measureapp.project.fringes.manifest import read_manifest

    for path in manifests:
        yield read_manifest(path)


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"\s*([1-9]\d{1,4})\s*[xX×]\s*([1-9]\d{1,4})\s*", text)
    if match is None:
        raise InputError(f"--projector-px {text!r} is no size.", "Give columns x rows, such as 1024x768.")
    return int(match[1]), int(match[2])


def _with_date(calibration: CameraArrayCalibration, made: MadeFrom) -> CameraArrayCalibration:
    """Return the calibration with the projector's date and provenance; also that of the cameras where they were calibrated with it."""
    from dataclasses import replace

    if calibration.projector is None:  # pragma: no cover - `solve_head` always gives one
        return calibration
    provenance = replace(
        calibration.projector.provenance,
        created=datetime.now(UTC).isoformat(timespec="seconds"),
        inputs=made.inputs,
        arguments=made.arguments,
        folder=made.folder,
    )
    given = calibration.provenance.arguments  # of cameras that were calibrated before
    return replace(
        calibration,
        projector=replace(calibration.projector, provenance=provenance),
        provenance=calibration.provenance if given else replace(provenance, method=calibration.provenance.method),
    )


def projector_answer(head: HeadSolution, manifests: Sequence[Path]) -> dict[str, Any]:
    """Return the JSON answer of a solution."""
    from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
    from measureapp.calibrate.projection import intrinsic_names

    found, solution = head.projector, head.solution
    matrix, place = found.pinhole.matrix, found.reference_from_projector
    values = [
        matrix[0, 0],
        matrix[1, 1],
        matrix[0, 2],
        matrix[1, 2],
        *found.pinhole.distortion,
        *place.rotation_vector,
        *place.translation_mm,
    ]
    pose = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")
    names = (*intrinsic_names(len(found.pinhole.distortion)), *pose)
    own = [view for view in solution.views if view.camera == PROJECTOR]
    return {
        "reference": head.calibration.reference,
        "projector": {
            "width": found.pinhole.width_px,
            "height": found.pinhole.height_px,
            "matrix": matrix,
            "distortion": found.pinhole.distortion,
            "reference_from_projector": place.matrix,
            "parameters": {
                name: {"value": float(value), "standard_deviation": found.standard_deviations.get(name, 0.0)}
                for name, value in zip(names, values, strict=True)
            },
            "rms_px": solution.calibration.cameras[PROJECTOR].rms_px,
            "sigma_px": solution.sigmas_px[PROJECTOR],
            "views": len(own),
        },
        "camera_uncertainty_carried_on": head.calibration.covariance is not None,
        "views": [
            {"camera": view.camera, "manifest": _manifest(manifests, view), "rms_px": view.rms_px, "corners": view.corners}
            for view in solution.views
        ],
        "rejected": [{"camera": one.camera, "manifest": _manifest(manifests, one), "reason": one.reason} for one in solution.rejected],
        "rejected_corners": len(solution.rejected_corners),
    }


def _manifest(manifests: Sequence[Path], sighting: Any) -> str:
    return str(manifests[int(sighting.view) - 1])


def _lines(document: dict[str, Any]) -> list[str]:
    found = document["projector"]
    focal, place = found["parameters"]["fx"], [found["parameters"][name] for name in ("x_mm", "y_mm", "z_mm")]
    lines = [
        f"Projector from {found['views']} positions of the board: fx {focal['value']:.2f} ± {focal['standard_deviation']:.2f} px, "
        f"rms {found['rms_px']:.3f} px",
        "  at " + ", ".join(f"{one['value']:.3f} ± {one['standard_deviation']:.3f}" for one in place) + " mm before the reference camera",
    ]
    if not document["camera_uncertainty_carried_on"]:
        lines.append("  cameras.json holds no covariance: the standard deviations assume exactly known cameras")
    return lines + [f"  rejected: {one['manifest']} ({one['camera']}): {one['reason']}" for one in document["rejected"]]


def _saved_lines(document: dict[str, Any]) -> list[str]:
    return [f"Saved to {path}" for path in document["files"].values()]
