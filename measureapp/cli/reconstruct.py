"""`reconstruct`: recorded fringe images to a point cloud."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.decode import PerFrequencyOption, RuleOption, decode_settings
from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.calibration import CameraArrayCalibration
    from measureapp.data.fringe import FringeStack
    from measureapp.reconstruct.reconstruct import Reconstruction


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def reconstruct(
        manifest: Annotated[Path, typer.Argument(help="MANIFEST.toml of the recorded images.")],
        cameras: Annotated[Path, typer.Option("--cameras", help="cameras.json of the cameras that took them.")],
        out: Annotated[Path, typer.Option("--out", help="Cloud to write: .ply or .xyz.")],
        rule: RuleOption = "combined",
        per_frequency: PerFrequencyOption = False,
        as_json: JsonOption = False,
    ) -> None:
        """Decode fringe images, match the cameras by phase and triangulate."""
        from measureapp.errors import ReconstructError
        from measureapp.fringe.decode import decode
        from measureapp.progress import PartOf
        from measureapp.project.camera_file import read_cameras
        from measureapp.project.fringe_manifest import read_manifest
        from measureapp.project.geometry_files import write_cloud
        from measureapp.reconstruct.reconstruct import reconstruct as reconstruct_maps

        calibration = read_cameras(cameras)
        settings = decode_settings(rule, per_frequency)
        stack = read_manifest(manifest)
        _check_fits(stack, calibration, cameras)
        progress = TerminalProgress()
        maps = decode(stack, settings, PartOf(progress, 0.0, 0.5))
        made = reconstruct_maps(maps, calibration, None, PartOf(progress, 0.5, 1.0))
        if len(made.cloud) == 0:
            raise ReconstructError(
                f"{manifest} gives no points: no phase occurs in two cameras on one epipolar line.",
                f"Check that {cameras} belongs to these images, and the pitches and shift_sign in the manifest.",
            )
        write_cloud(out, made.cloud)
        document = _document(made, out)
        reply(document, _lines(document), as_json)


def _check_fits(stack: FringeStack, calibration: CameraArrayCalibration, file: Path) -> None:
    """Raise InputError where the calibration is of other cameras than the images, before the long work starts."""
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
                f"{file}: camera {name!r} is calibrated for {pinhole.width_px} × {pinhole.height_px} px, its images have {width} × {height} px.",
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
                "skipped": pair.skipped,
            }
            for pair in made.pairs
        ],
        "rejected": made.rejected,
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
        seen = "" if rms is None else f", {rms:.3f} px in the third camera, {pair['epipolar_px']:.3f} px without the phase noise"
        said = f"not matched, {pair['skipped']}" if pair["skipped"] else f"{pair['matched']} matched{seen}"
        lines.append(f"  {'–'.join(pair['cameras'])}: {said}")
    lines.append("  rejected: " + ", ".join(f"{count} {reason}" for reason, count in document["rejected"].items() if count))
    return "\n".join(lines)
