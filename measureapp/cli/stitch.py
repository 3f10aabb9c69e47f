"""`measureapp stitch`: registration of clouds, merging and surface reconstruction."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, UnitOption, reply, say
from measureapp.data.length_unit import LengthUnit
from measureapp.progress import PartOf

if TYPE_CHECKING:
    from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement

DEFAULT_SIGMA_MM = 0.05  # for clouds without standard deviations
LEAST_EXTENT_MM = 3.0
LARGEST_EXTENT_MM = 20_000.0


class Mesher(StrEnum):
    """Method of surface reconstruction."""

    POISSON = "poisson"
    OPEN = "open"


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command("stitch")
    def stitch_clouds(
        clouds: Annotated[
            list[Path],
            typer.Argument(help="One cloud per view, in its camera's frame; the file name without extension is the name of its pose."),
        ],
        poses: Annotated[Path, typer.Option(help="poses.csv: name,x_mm,y_mm,z_mm,qw,qx,qy,qz (part_from_camera).")],
        out: Annotated[Path, typer.Option(help="The stitched cloud (.ply or .xyz).", dir_okay=False)],
        mesh: Annotated[Path | None, typer.Option(help="Also write a surface mesh (.ply or .stl).")] = None,
        mesher: Annotated[
            Mesher, typer.Option(help="poisson: closed surface; open: triangulation of one open patch, holes stay open.")
        ] = Mesher.POISSON,
        pose_sigma_mm: Annotated[float, typer.Option(min=1e-6, help="Standard deviation of the poses: position.")] = 0.5,
        pose_sigma_deg: Annotated[float, typer.Option(min=1e-6, help="Standard deviation of the poses: orientation.")] = 0.05,
        fine: Annotated[
            bool, typer.Option("--fine/--kinematic-only", help="Register the clouds, or place them by their poses only.")
        ] = True,
        accept: Annotated[list[str] | None, typer.Option(help="Use this view even if it contradicts its pose; may be repeated.")] = None,
        unit: UnitOption = LengthUnit.MM,
        as_json: JsonOption = False,
    ) -> None:
        """Register clouds, starting from their poses, and merge them."""
        from measureapp.project.geometry.files import write_cloud, write_mesh
        from measureapp.project.tables import read_poses
        from measureapp.register.clouds.units import check_unit
        from measureapp.register.settings import StitchSettings
        from measureapp.register.stitch import stitch

        _check_outputs(clouds, out, mesh)
        _check_accepted(accept or [], clouds)
        known = read_poses(poses, "part", "camera")
        kinematic = [_pose(known, path, poses) for path in clouds]
        progress = TerminalProgress()
        read = [_read(path, unit, PartOf(progress, 0.2 * i / len(clouds), 0.2 * (i + 1) / len(clouds))) for i, path in enumerate(clouds)]
        check_unit(read, kinematic)
        settings = StitchSettings(pose_sigma_mm=pose_sigma_mm, pose_sigma_deg=pose_sigma_deg, fine=fine)
        stitched = stitch(read, kinematic, settings, PartOf(progress, 0.2, 0.8), accepted=accept or ())
        _check_overlap(stitched, fine)
        triangles = _surface(stitched, mesher, PartOf(progress, 0.8, 1.0)) if mesh else None
        write_cloud(out, stitched)
        if mesh and triangles is not None:
            write_mesh(mesh, triangles)
        progress.report(1, 1, "done")
        document = _document(stitched, out, mesh)
        reply(document, _lines(stitched, out), as_json)
        if any(placement.verdict != "good" for placement in stitched.placements):
            raise typer.Exit(1)


def _check_outputs(clouds: list[Path], out: Path, mesh: Path | None) -> None:
    from measureapp.errors import InputError
    from measureapp.project.geometry.files import require_writable_geometry

    stems = [path.stem for path in clouds]
    twice = sorted({stem for stem in stems if stems.count(stem) > 1})
    if twice:
        raise InputError(f"Two clouds are named {twice[0]!r}.", "Give each view its own file name: it names the pose.")
    require_writable_geometry(out)
    if any(out.exists() and out.samefile(path) for path in clouds if path.exists()):
        raise InputError(f"{out} is one of the clouds to be stitched.", "Name another file for the stitched one.")
    if mesh:
        require_writable_geometry(mesh, mesh=True)


def _check_accepted(accepted: list[str], clouds: list[Path]) -> None:
    from measureapp.errors import InputError

    stems = [path.stem for path in clouds]
    unknown = [name for name in accepted if name not in stems]
    if unknown:
        raise InputError(f"There is no view {unknown[0]!r} to accept.", "Views: " + ", ".join(stems) + ".")


def _check_overlap(stitched: StitchedCloud, fine: bool) -> None:
    from measureapp.errors import RegistrationError

    if fine and len(stitched.placements) > 1 and not any(placement.overlap for placement in stitched.placements):
        raise RegistrationError(
            "No two clouds overlap at their poses.",
            "Check unit, direction (part_from_camera) and names of the poses; --kinematic-only places clouds without overlap.",
        )


def _pose(known: dict[str, Any], path: Path, table: Path) -> Any:
    from measureapp.errors import InputError

    if path.stem not in known:
        raise InputError(f"{table} has no pose named {path.stem!r} for {path}.", "Name the poses like the cloud files, without extension.")
    return known[path.stem]


def _read(path: Path, unit: LengthUnit, progress: PartOf) -> PointCloud:
    """Read a cloud of any format; missing normals are estimated, other missing columns get defaults."""
    from measureapp.data.cloud import PointCloud
    from measureapp.errors import InputError
    from measureapp.project.geometry.files import read_points
    from measureapp.register.clouds.normals import estimate_normals

    progress.report(0, 1, f"reading {path.name}")
    plain = read_points(path, unit)
    if plain.frame not in ("", "camera"):
        raise InputError(f"{path} is in frame {plain.frame!r}.", "Provide the clouds of the views in their camera's frame.")
    _check_units(path, np.asarray(plain.points_mm))
    if plain.dropped:
        say(f"{path}: {plain.dropped} points with non-finite coordinates excluded.")
    count = len(plain)
    normals = plain.normals
    if normals is None or np.count_nonzero(np.any(normals != 0, axis=1)) < count:
        normals = estimate_normals(np.asarray(plain.points_mm), np.zeros(3)) if count >= 3 else np.zeros((count, 3))
    sigma = plain.sigma_mm if plain.sigma_mm is not None else np.zeros(count)
    sigma = np.where(np.asarray(sigma) > 0, sigma, DEFAULT_SIGMA_MM)
    grey = plain.grey if plain.grey is not None else np.full(count, 0.5)
    pixel = plain.pixel if plain.pixel is not None else np.full((count, 2), -1, np.int32)
    cameras = plain.cameras if plain.cameras is not None else np.ones(count, np.uint8)
    return PointCloud(plain.points_mm, normals, sigma, grey, pixel, cameras, "camera", path.stem)


def _check_units(path: Path, points_mm: Any) -> None:
    from measureapp.errors import InputError

    extent = float(np.ptp(points_mm, axis=0).max())
    if len(points_mm) > 100 and extent < LEAST_EXTENT_MM:
        raise InputError(
            f"{path} is only {extent:.3g} mm in size: is it in metres or inches?",
            "If all clouds are, use `--unit m` or `--unit inch`; otherwise export it in millimetres.",
        )
    if extent > LARGEST_EXTENT_MM:
        raise InputError(
            f"{path} is {extent / 1000:.3g} m in size: is it in micrometres?",
            "If all clouds are, use `--unit um`; otherwise export it in millimetres.",
        )


def _surface(stitched: StitchedCloud, mesher: Mesher, progress: PartOf) -> Any:
    from measureapp.register.surface.closed import reconstruct_surface
    from measureapp.register.surface.open import triangulate_open_patch

    return triangulate_open_patch(stitched, progress) if mesher is Mesher.OPEN else reconstruct_surface(stitched, progress=progress)


def _document(stitched: StitchedCloud, out: Path, mesh: Path | None) -> dict[str, Any]:
    from measureapp.project.documents import loop_closure_document

    return {
        "views": [_view(placement) for placement in stitched.placements],
        "points": len(stitched),
        "ring": loop_closure_document(stitched.loop_closure),
        "notes": dict(stitched.notes),
        "files": {"stitched_cloud": out} | ({"mesh": mesh} if mesh else {}),
    }


def _view(placement: ViewPlacement) -> dict[str, Any]:
    return {
        "name": placement.viewpoint_id,
        "pose": placement.part_from_camera.matrix,
        "correction_mm": placement.correction_mm,
        "correction_deg": placement.correction_deg,
        "residual_mm": placement.residual_mm,
        "overlap": placement.overlap,
        "bound_mm": placement.bound_mm,
        "bound_deg": placement.bound_deg,
        "sigma_mm": placement.sigma_mm,
        "sigma_deg": placement.sigma_deg,
        "held_by_axes": list(placement.unconstrained_motions),
        "verdict": placement.verdict,
        "used": placement.used,
    }


def _lines(stitched: StitchedCloud, out: Path) -> str:
    rows = [f"{'view':<16} {'shift':>9} {'rotation':>9} {'residual':>9} {'overlap':>8}  verdict"]
    rows += [
        f"{p.viewpoint_id:<16} {p.correction_mm:6.3f} mm {p.correction_deg:8.3f}° {p.residual_mm:6.3f} mm {p.overlap:8.0%}  {p.verdict}"
        for p in stitched.placements
    ]
    motions = sorted({motion for p in stitched.placements for motion in p.unconstrained_motions})
    rows += [f"Not determined by the surfaces: {motion}; the given poses are kept there." for motion in motions]
    if stitched.loop_closure is not None:
        rows.append(f"{stitched.loop_closure.sentence[0].upper()}{stitched.loop_closure.sentence[1:]}.")
    return "\n".join([*rows, f"{len(stitched)} points saved to {out}"])
