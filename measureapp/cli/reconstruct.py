"""`reconstruct`: point cloud from recorded fringe images."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.decode import (
    BloomingOption,
    ModulationOption,
    NoiseOption,
    PerFrequencyOption,
    PhaseSigmaOption,
    ResponseOption,
    RuleOption,
    decode_settings,
    most_frequent_loss,
    with_limits,
)
from measureapp.cli.reply import JsonOption, TerminalProgress, reply, say

if TYPE_CHECKING:
    from measureapp.data.calibration import CameraArrayCalibration
    from measureapp.data.fringe import FringeStack
    from measureapp.data.phase import PhaseMap
    from measureapp.progress import Progress
    from measureapp.reconstruct.diagnosis.diagnose import Finding
    from measureapp.reconstruct.reconstruct import Reconstruction
    from measureapp.reconstruct.settings import ReconstructSettings


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def reconstruct(
        manifest: Annotated[Path, typer.Argument(help="MANIFEST.toml of the recorded images.")],
        cameras: Annotated[Path, typer.Option("--cameras", help="cameras.json of the cameras that took them.")],
        out: Annotated[Path, typer.Option("--out", help="Cloud to write: .ply or .xyz.", dir_okay=False)],
        rule: RuleOption = "combined",
        per_frequency: PerFrequencyOption = False,
        noise: NoiseOption = None,
        response: ResponseOption = None,
        blooming_px: BloomingOption = "0",
        projector: Annotated[
            bool,
            typer.Option("--projector", help="Triangulate areas visible to only one camera with the calibrated projector of cameras.json."),
        ] = False,
        min_modulation: ModulationOption = None,
        max_phase_sigma: PhaseSigmaOption = None,
        max_sigma_mm: Annotated[
            float | None,
            typer.Option(
                "--max-sigma-mm",
                help="Reject points with a larger standard deviation; without it, the limit follows the geometry and is stated.",
            ),
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Decode fringe images, match the cameras by phase and triangulate; a single camera needs a calibrated projector.

        Points triangulated with the projector have bit 128 of `cameras` set. Mistakes that do not disturb decoding (wrong shift
        sign, exchanged cameras, a camera that moved since its calibration) are diagnosed.
        """
        from measureapp.errors import ReconstructError
        from measureapp.fringe.decode import decode
        from measureapp.progress import PartOf
        from measureapp.project.calibration.camera_file import read_cameras
        from measureapp.project.fringes.manifest import read_manifest
        from measureapp.project.geometry.files import require_writable_geometry, write_cloud

        require_writable_geometry(out)
        calibration = read_cameras(cameras)
        stack = read_manifest(manifest)
        settings = with_limits(decode_settings(stack, rule, per_frequency, noise, response, blooming_px), min_modulation, max_phase_sigma)
        _check_fits(stack, calibration, cameras)
        progress = TerminalProgress()
        maps = decode(stack, settings, PartOf(progress, 0.0, 0.5))
        findings = diagnose_maps(maps, calibration)
        made, agreement = _reconstruct(
            maps, calibration, projector or len(maps) == 1, reconstruct_settings(max_sigma_mm), PartOf(progress, 0.5, 1.0)
        )
        if len(made.cloud) == 0:
            raise ReconstructError(*_no_points(maps, manifest, cameras))
        write_cloud(out, made.cloud)
        document = {**_document(made, out), "findings": [asdict(finding) for finding in findings], "projector": agreement}
        document["validity"] = _validity(maps, calibration)
        reply(document, _lines(document), as_json)


def _no_points(maps: Mapping[str, PhaseMap], manifest: Path, cameras: Path) -> tuple[str, str]:
    """Return the reason for missing points, and a remedy."""
    for name, phase_map in maps.items():
        if not phase_map.valid.any():
            reason, remedy = most_frequent_loss(phase_map)
            return f"{manifest} gives no points: camera {name!r} has no phase, {reason}.", remedy
    return (
        f"{manifest} gives no points: no pixels of two cameras have the same phase on an epipolar line.",
        f"Check that {cameras} belongs to these images, and the pitches and shift_sign in the manifest.",
    )


def diagnose_maps(maps: Mapping[str, PhaseMap], calibration: CameraArrayCalibration) -> tuple[Finding, ...]:
    """Diagnose the phase maps and print the findings; raises ReconstructError when points would be wrong."""
    from measureapp.reconstruct.diagnosis.diagnose import diagnose

    findings = diagnose(maps, calibration)
    for finding in findings:
        if finding.severity == "error":
            raise finding.error()
        say(f"Note: {finding.message} {finding.remedy}")
    return findings


def _validity(maps: Mapping[str, PhaseMap], calibration: CameraArrayCalibration) -> dict[str, Any]:
    """Evaluate the validity of the calibration and print warnings; images in files have no date."""
    from datetime import UTC, datetime

    from measureapp.calibrate.cameras.drift import camera_drift
    from measureapp.calibrate.cameras.validity import shortfalls
    from measureapp.data.validity import Validity
    from measureapp.project.documents import validity_document
    from measureapp.reconstruct.diagnosis.camera_shift import camera_shift

    shift = camera_shift(maps, calibration)
    drift = camera_drift([] if shift is None else [shift], calibration)
    validity = Validity(shortfalls(calibration.provenance, datetime.now(UTC)) if calibration.provenance.valid_days else (), drift)
    for sentence in validity.all_warnings:
        say(f"Calibration: {sentence}")
    return validity_document(validity)


def reconstruct_settings(max_sigma_mm: float | None) -> ReconstructSettings:
    """Return the settings of reconstruction; raises InputError for a limit that is not positive."""
    from measureapp.errors import InputError
    from measureapp.reconstruct.settings import ReconstructSettings

    if max_sigma_mm is not None and not max_sigma_mm > 0:
        raise InputError(f"--max-sigma-mm {max_sigma_mm:g} is not a length above 0.", "Give a length in mm, or omit the option.")
    return ReconstructSettings(max_sigma_mm=max_sigma_mm)


def _reconstruct(
    maps: Mapping[str, PhaseMap],
    calibration: CameraArrayCalibration,
    with_projector: bool,
    settings: ReconstructSettings,
    progress: Progress,
) -> tuple[Reconstruction, dict[str, Any]]:
    """Return the reconstruction and, with the projector, its agreement with the cameras."""
    from measureapp.reconstruct.projector.with_projector import reconstruct_view_with_projector
    from measureapp.reconstruct.reconstruct import reconstruct as reconstruct_maps

    if not with_projector:
        return reconstruct_maps(maps, calibration, settings, progress), {}
    view = reconstruct_view_with_projector(maps, calibration, settings, progress)
    agreement = {name: asdict(each) for name, each in view.agreement.items()}
    return view.reconstruction, {"points": view.points, "agreement": agreement}


def _check_fits(stack: FringeStack, calibration: CameraArrayCalibration, file: Path) -> None:
    """Raise InputError when the calibration is of other cameras than the images."""
    from measureapp.errors import InputError

    for name, images in stack.images.items():
        if name not in calibration.cameras:
            raise InputError(
                f"{file} has no camera {name!r}, only {', '.join(calibration.names)}.",
                "Use the calibration of the cameras that took the images.",
            )
        pinhole = calibration.cameras[name].pinhole
        height, width = images.shape[2:]
        if (width, height) != (pinhole.width_px, pinhole.height_px):
            raise InputError(
                f"{file}: camera {name!r} is calibrated for {pinhole.width_px} × {pinhole.height_px} px, its images are {width} × {height} px.",
                "Use the calibration of the camera and resolution that took the images.",
            )


def _document(made: Reconstruction, out: Path) -> dict[str, Any]:
    import numpy as np

    depth = np.percentile(made.cloud.points_mm[:, 2], [1, 50, 99])
    return {
        "points": len(made.cloud),
        "depth_mm": dict(zip(("p1", "p50", "p99"), (float(value) for value in depth), strict=True)),
        "sigma_median_mm": float(np.median(made.cloud.sigma_mm)),
        "pairs": [
            {
                "cameras": pair.names,
                "matched": pair.matched,
                "epipolar_rms_px": pair.epipolar_rms_px,
                "epipolar_px": pair.epipolar_px,
                "across_px": pair.across_px,
                "skipped": pair.skipped,
            }
            for pair in made.pairs
        ],
        "rejected": made.rejected,
        "max_sigma_mm": made.max_sigma_mm,
        "file": out,
    }


def _lines(document: dict[str, Any]) -> str:
    depth = document["depth_mm"]
    lines = [
        f"{document['points']} points, depth {depth['p1']:.2f} … {depth['p50']:.2f} … {depth['p99']:.2f} mm (1, 50, 99 %), "
        f"median σ {document['sigma_median_mm']:.3f} mm → {document['file']}"
    ]
    for pair in document["pairs"]:
        rms = pair["epipolar_rms_px"]
        is_only_pair = len(document["pairs"]) == 1  # two cameras: error from the orthogonal fringes
        where = "perpendicular to the epipolar lines" if is_only_pair else "in the third camera"
        errors = "" if rms is None else f", {rms:.3f} px {where}, {pair['epipolar_px']:.3f} px without the phase noise"
        if not is_only_pair and pair["across_px"] is not None:
            errors += f", {pair['across_px']:.3f} px perpendicular to the epipolar lines"
        result = f"not matched, {pair['skipped']}" if pair["skipped"] else f"{pair['matched']} matched{errors}"
        lines.append(f"  {'–'.join(pair['cameras'])}: {result}")
    lines.append("  rejected: " + ", ".join(f"{count} {reason}" for reason, count in document["rejected"].items() if count))
    limits = ", ".join(f"{name} {limit:.2g} mm" for name, limit in document["max_sigma_mm"].items())
    lines.append(f"  largest σ of a point: {limits}")
    return "\n".join(lines)
