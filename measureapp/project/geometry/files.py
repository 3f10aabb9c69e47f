"""Clouds and meshes on disk: PLY, STL, OBJ, PCD, XYZ and, as nominals, STEP in; PLY, STL and XYZ out.

Every reader checks what a header declares against what the file holds before it allocates anything, so that a
damaged file is refused in words. Files carry no units: lengths are taken as millimetres unless another unit is stated.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray, read_only
from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.data.length_unit import LengthUnit
from measureapp.data.mesh import Mesh
from measureapp.data.view_errors import ViewErrors
from measureapp.errors import InputError, UnitQuestion
from measureapp.project.atomic import replacing, require_writable
from measureapp.project.geometry.mesh_files import read_obj, read_stl, write_stl
from measureapp.project.geometry.ply import Ply, Ragged, read_ply, write_ply
from measureapp.project.geometry.point_files import read_pcd, read_text_points
from measureapp.project.geometry.step_files import STEP_KINDS, read_step
from measureapp.project.geometry.view_errors import error_elements, errors_from

LARGEST_FILE_BYTES = 8 * 2**30
UNIT_ROUNDING = 4 * float(np.finfo(np.float32).eps)  # of the length of a unit vector in single precision
LARGEST_MM = 1e7  # beyond ten kilometres a coordinate is garbage
KINDS = (".ply", ".stl", ".obj", ".pcd", ".xyz", ".txt", ".csv", ".asc", ".pts")
EXPORT_AGAIN = "Export or copy the file again."
LABEL = "measureapp "  # begins our own PLY comments: `measureapp frame part`


@dataclass(frozen=True, slots=True, eq=False)
class PlainPoints:
    """Points of any file; what the file does not have is None."""

    points_mm: FloatArray  # (N, 3) float64, all finite
    normals: FloatArray | None = None  # (N, 3) float32, unit; zero where the file had none for a point
    sigma_mm: FloatArray | None = None  # (N,) float32
    grey: FloatArray | None = None  # (N,) float32, 0…1
    pixel: IntArray | None = None  # (N, 2) int32
    cameras: IntArray | None = None  # (N,) uint8
    view: IntArray | None = None  # (N,) int16
    dropped: int = 0  # points left out because they were not numbers
    frame: str = ""  # as our own files say
    viewpoint_id: str = ""
    view_names: tuple[str, ...] = ()  # what `view` counts, as our own files say
    sampled_view: IntArray | None = None  # (N,) int16, a view of each point as often as it weighs in it
    errors: ViewErrors | None = None  # of those views, as our own files say

    def __post_init__(self) -> None:
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float64, (None, 3)))

    def __len__(self) -> int:
        return len(self.points_mm)


def read_points(path: Path, unit: LengthUnit = LengthUnit.MM) -> PlainPoints:
    """Read the points (or the vertices) of a PLY, STL, OBJ, PCD or text file whose lengths are in ``unit``.

    Raises
    ------
    InputError
        The file is missing, empty, damaged, of an unknown kind or without points.
    """
    path, kind = _check_file(path)
    if kind == ".ply":
        points = _ply_points(path, read_ply(path))
    elif kind == ".stl":
        points = _sound(path, read_stl(path)[0], {})
    elif kind == ".obj":
        vertices, _, normals = read_obj(path)
        points = _sound(path, vertices, {"normals": normals})
    elif kind == ".pcd":
        points = _pcd_points(path, read_pcd(path))
    else:
        table = read_text_points(path)
        check_stated_unit(path, table.unit, unit)
        points = _sound(path, table.points, {"normals": table.normals})
    return _points_in_mm(path, points, unit)


def check_stated_unit(path: Path, stated: LengthUnit | None, unit: LengthUnit) -> None:
    """Raise UnitQuestion where the columns of a file state another unit than millimetres, InputError where another than the one given."""
    if stated in (None, unit):
        return
    words, given = stated.words, unit.words
    if unit is LengthUnit.MM:
        raise UnitQuestion(
            f"The columns of {path} are in {words}, and would be read as millimetres.",
            f"Give --unit {stated}.",
            "points",
            str(stated),
            f"The columns of {path} are in {words}",
        )
    raise InputError(
        f"The columns of {path} are in {words}, not in {given}.", f"Give --unit {stated}, or correct the names of the columns."
    )


def read_mesh(path: Path, frame: str = "nominal", unit: LengthUnit = LengthUnit.MM) -> Mesh:
    """Read the triangles of a PLY, STL or OBJ file whose lengths are in ``unit``, or those that follow the surfaces of a STEP file.

    Raises
    ------
    InputError
        As `read_points`; also a file without triangles, or with corners that do not exist.
    """
    path, kind = _check_file(path, (*KINDS, *STEP_KINDS))
    if kind in STEP_KINDS:
        if unit is not LengthUnit.MM:
            raise InputError(f"{path} is a STEP file, which states its unit itself.", "Leave the unit of the nominal out.")
        return Mesh(*read_step(path), frame)
    if kind not in (".ply", ".stl", ".obj"):
        raise InputError(f"{path} cannot hold a mesh.", "Give a PLY, STL, OBJ or STEP file.")
    mesh = _read_mesh(path, kind, frame)
    if mesh is None:
        raise InputError(f"{path} has points but no triangles.", "Give a mesh, or make one of the cloud first.")
    return _mesh_in_mm(mesh, unit)


def read_cloud_or_mesh(path: Path, frame: str = "part", unit: LengthUnit = LengthUnit.MM) -> PlainPoints | Mesh:
    """Read a mesh if the file has triangles, otherwise its points; raises InputError as `read_points`."""
    checked, kind = _check_file(path)
    mesh = _read_mesh(checked, kind, frame) if kind in (".ply", ".stl", ".obj") else None
    return read_points(checked, unit) if mesh is None else _mesh_in_mm(mesh, unit)


def _points_in_mm(path: Path, points: PlainPoints, unit: LengthUnit) -> PlainPoints:
    if unit is LengthUnit.MM:
        return points
    if points.frame:
        raise InputError(f"{path} was written by MeasureApp, in millimetres, not in {unit.words}.", "Leave the unit out.")
    sigma = None if points.sigma_mm is None else points.sigma_mm * unit.in_mm
    return replace(points, points_mm=points.points_mm * unit.in_mm, sigma_mm=sigma)


def _mesh_in_mm(mesh: Mesh, unit: LengthUnit) -> Mesh:
    return mesh if unit is LengthUnit.MM else replace(mesh, vertices_mm=mesh.vertices_mm * unit.in_mm)


def read_point_cloud(path: Path) -> PointCloud:
    """Read a view's cloud that `write_cloud` wrote.

    Raises
    ------
    InputError
        As `read_points`, or the file lacks what a cloud of one view has.
    """
    plain = read_points(path)
    columns = (plain.normals, plain.sigma_mm, plain.grey, plain.pixel, plain.cameras)
    normals, sigma, grey, pixel, cameras = columns
    if normals is None or sigma is None or grey is None or pixel is None or cameras is None or not plain.frame:
        raise InputError(f"{path} is not a view's cloud written by MeasureApp.", "Read it as plain points, or process the project again.")
    return PointCloud(plain.points_mm, normals, sigma, grey, pixel, cameras, plain.frame, plain.viewpoint_id)


def read_stitched(path: Path) -> StitchedCloud:
    """Read the merged points that `write_cloud` wrote; the placements of the views are not in the file.

    Raises
    ------
    InputError
        As `read_points`, or the file lacks what a stitched cloud has.
    """
    plain = read_points(path)
    if plain.normals is None or plain.sigma_mm is None or plain.grey is None or plain.view is None:
        raise InputError(f"{path} is not a stitched cloud written by MeasureApp.", "Read it as plain points, or stitch again.")
    frame = plain.frame or "part"
    return StitchedCloud(
        plain.points_mm,
        plain.normals,
        plain.sigma_mm,
        plain.grey,
        plain.view,
        (),
        frame,
        view_names=plain.view_names,
        sampled_view=plain.sampled_view,
        errors=plain.errors,
    )


def require_writable_geometry(path: Path, *, mesh: bool = False) -> None:
    """Try before a long job whether a cloud, or a mesh, can be written there; raises StorageError or InputError."""
    _check_ending(path, mesh=mesh)
    require_writable(path)


def _check_ending(path: Path, *, mesh: bool) -> None:
    ending = Path(path).suffix.lower()
    if mesh and ending not in (".ply", ".stl"):
        raise InputError(f"{path}: this is not a format for meshes.", "Use .ply or .stl.")
    if not mesh and ending not in (".ply", ".xyz"):
        raise InputError(f"{path}: this is not a format for clouds.", "Use .ply or .xyz.")


def write_cloud(path: Path, cloud: PointCloud | StitchedCloud) -> None:
    """Write a cloud as PLY (binary) or, by the ending of ``path``, as XYZ (x y z nx ny nz); raises StorageError or InputError."""
    _check_ending(path, mesh=False)
    with replacing(Path(path)) as temporary:
        if temporary.suffix.lower() == ".xyz":
            np.savetxt(temporary, np.column_stack([cloud.points_mm, cloud.normals]), "%.6g")
        else:
            errors = cloud.errors if isinstance(cloud, StitchedCloud) else None
            write_ply(temporary, _comments(cloud), {"vertex": _cloud_columns(cloud), **error_elements(errors)})


def write_mesh(path: Path, mesh: Mesh) -> None:
    """Write triangles as PLY or STL (binary), by the ending of ``path``; raises StorageError or InputError."""
    _check_ending(path, mesh=True)
    with replacing(Path(path)) as temporary:
        if temporary.suffix.lower() == ".stl":
            write_stl(temporary, mesh.vertices_mm, mesh.triangles)
        else:
            vertex = _xyz_columns(mesh.vertices_mm)
            if mesh.measured is not None:
                vertex["measured"] = mesh.measured.astype(np.uint8)
            write_ply(temporary, [f"{LABEL}frame {mesh.frame}"], {"vertex": vertex, "face": {"vertex_indices": mesh.triangles}})


def _check_file(path: Path, kinds: tuple[str, ...] = KINDS) -> tuple[Path, str]:
    """Return the path and its lower-case ending after the checks that every reader needs."""
    path = Path(path)
    if not path.is_file():
        raise InputError(f"{path} does not exist or is not a file.", "Check the path.")
    try:
        size = path.stat().st_size
        with path.open("rb"):
            pass
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror}.", "Check the permissions.") from error
    if size == 0:
        raise InputError(f"{path} is empty.", EXPORT_AGAIN)
    if size > LARGEST_FILE_BYTES:
        raise InputError(f"{path} has {size / 2**30:.1f} GiB, more than can be read at once.", "Reduce the cloud or mesh first.")
    kind = path.suffix.lower()
    if kind not in kinds:
        raise InputError(f"{path} is of an unknown kind.", "Give one of: " + ", ".join(kinds) + ".")
    return path, kind


def _sound(path: Path, points_mm: FloatArray, columns: dict[str, Any], **labels: Any) -> PlainPoints:
    """Leave out what is not a number, scale normals to unit length, and refuse a file without points."""
    points = np.asarray(points_mm, np.float64)
    x, y, z = (np.abs(coordinate) < LARGEST_MM for coordinate in points.T)  # False for NaN as well
    good = x & y & z
    if not good.any():
        raise InputError(f"{path} holds no points.", EXPORT_AGAIN)
    kept = {name: column if good.all() else column[good] for name, column in columns.items() if column is not None}
    if "normals" in kept:
        kept["normals"] = unit(kept["normals"])
    if "sigma_mm" in kept:
        kept["sigma_mm"] = np.where(np.isfinite(kept["sigma_mm"]) & (kept["sigma_mm"] > 0), kept["sigma_mm"], 0).astype(np.float32)
    return PlainPoints(points if good.all() else points[good], dropped=int(np.count_nonzero(~good)), **kept, **labels)


def unit(normals: FloatArray) -> FloatArray:
    """Return normals of unit length, zero where there is no direction; those that are of unit length but for rounding stay as they are."""
    vectors = np.asarray(normals, np.float64)
    if not np.isfinite(vectors).all():
        vectors = np.nan_to_num(vectors, nan=0.0, posinf=0.0, neginf=0.0)
    x, y, z = vectors.T
    length = np.sqrt(x * x + y * y + z * z)
    length[np.abs(length - 1.0) < UNIT_ROUNDING] = 1.0
    length[length <= 1e-12] = np.inf
    return (vectors / length[:, None]).astype(np.float32)


def _ply_points(path: Path, ply: Ply) -> PlainPoints:
    points = _ply_xyz(path, ply)
    grey = ply.column("vertex", "grey")
    columns = {
        "normals": _stack_columns(ply, ("nx", "ny", "nz"), np.float32),
        "sigma_mm": _single(ply, "sigma", np.float32),
        "grey": np.clip(np.nan_to_num(grey), 0, 1).astype(np.float32) if grey is not None else None,
        "pixel": _stack_columns(ply, ("row", "col"), np.int32),
        "cameras": _single(ply, "cameras", np.uint8),
        "view": _single(ply, "view", np.int16),
        "sampled_view": _single(ply, "drawn_view", np.int16),
    }
    frame = _label(ply, "frame")
    errors = None if columns["view"] is None else errors_from(path, ply, frame or "part")
    plain = _sound(path, points, columns, frame=frame, viewpoint_id=_label(ply, "viewpoint"), view_names=_view_names(ply), errors=errors)
    _check_views(path, plain)
    return plain


def _check_views(path: Path, plain: PlainPoints) -> None:
    if plain.errors is None:
        return
    counted = [views for views in (plain.view, plain.sampled_view) if views is not None]
    if min(int(views.min()) for views in counted) < 0 or max(int(views.max()) for views in counted) >= len(plain.errors.poses):
        raise InputError(f"{path} has points of views that it does not describe.", EXPORT_AGAIN)


def _ply_xyz(path: Path, ply: Ply) -> FloatArray:
    points = _stack_columns(ply, ("x", "y", "z"), np.float64)
    if points is None:
        raise InputError(f"{path} has no vertices with x, y and z.", EXPORT_AGAIN)
    return points


def _stack_columns(ply: Ply, names: tuple[str, ...], dtype: Any) -> Any:
    columns = [_single(ply, name, dtype) for name in names]
    return None if any(column is None for column in columns) else np.column_stack(columns)


def _single(ply: Ply, name: str, dtype: Any) -> Any:
    column = ply.column("vertex", name)
    if column is None or np.issubdtype(dtype, np.floating):
        return None if column is None else column.astype(dtype)
    limits = np.iinfo(dtype)
    return np.clip(np.nan_to_num(column), limits.min, limits.max).astype(dtype)


def _label(ply: Ply, name: str) -> str:
    start = f"{LABEL}{name} "
    return next((comment[len(start) :].strip() for comment in ply.comments if comment.startswith(start)), "")


def _view_names(ply: Ply) -> tuple[str, ...]:
    names: list[str] = []
    while name := _label(ply, f"view {len(names)}"):
        names.append(name)
    return tuple(names)


def _pcd_points(path: Path, fields: dict[str, FloatArray]) -> PlainPoints:
    if not {"x", "y", "z"} <= fields.keys():
        raise InputError(f"{path} has no fields x, y and z.", EXPORT_AGAIN)
    names = ("normal_x", "normal_y", "normal_z")
    normals = np.column_stack([fields[name] for name in names]) if all(name in fields for name in names) else None
    return _sound(path, np.column_stack([fields["x"], fields["y"], fields["z"]]), {"normals": normals})


def _read_mesh(path: Path, kind: str, frame: str) -> Mesh | None:
    measured = None
    if kind == ".stl":
        vertices, triangles = read_stl(path)
    elif kind == ".obj":
        vertices, triangles, _ = read_obj(path)
    else:
        ply = read_ply(path)
        vertices, triangles = _ply_xyz(path, ply), _ply_triangles(path, ply)
        flags = ply.column("vertex", "measured")
        measured = None if flags is None else flags != 0
        frame = _label(ply, "frame") or frame
    if len(triangles) == 0:
        return None
    bad = int(np.count_nonzero(~np.all(np.abs(vertices) < LARGEST_MM, axis=1)))
    if bad:
        raise InputError(f"{path} has {bad} vertices that are not usable numbers.", EXPORT_AGAIN)
    if triangles.min() < 0 or triangles.max() >= len(vertices):
        raise InputError(f"{path} has triangles whose corners do not exist.", EXPORT_AGAIN)
    return Mesh(vertices, triangles, frame, measured)


def _ply_triangles(path: Path, ply: Ply) -> IntArray:
    """Return the faces as triangles, polygons fanned."""
    faces = ply.elements.get("face", {})
    lists = next((faces[name] for name in ("vertex_indices", "vertex_index") if isinstance(faces.get(name), Ragged)), None)
    if lists is None or len(lists.counts) == 0:
        return np.empty((0, 3), np.int64)
    corners = np.nan_to_num(np.asarray(lists.values, np.float64), nan=-1)
    if np.any(np.abs(corners) > 2**31 - 2):
        raise InputError(f"{path} has triangles whose corners do not exist.", EXPORT_AGAIN)
    index = corners.astype(np.int64)
    starts = np.concatenate([[0], np.cumsum(lists.counts)[:-1]])
    fans = np.maximum(lists.counts - 2, 0)
    first = np.repeat(starts, fans)
    step = np.arange(int(fans.sum())) - np.repeat(np.concatenate([[0], np.cumsum(fans)[:-1]]), fans)
    return np.column_stack([index[first], index[first + step + 1], index[first + step + 2]])


def _xyz_columns(points_mm: FloatArray) -> dict[str, Any]:
    """Return coordinates as they were computed, to the last bit: what is computed from them again is then the same."""
    return {name: np.asarray(points_mm[:, i], np.float64) for i, name in enumerate("xyz")}


def _comments(cloud: PointCloud | StitchedCloud) -> list[str]:
    comments = [f"{LABEL}millimetres", f"{LABEL}frame {cloud.frame}"]
    if isinstance(cloud, PointCloud):
        return [*comments, f"{LABEL}viewpoint {cloud.viewpoint_id}"]
    return comments + [f"{LABEL}view {i} {name}" for i, name in enumerate(cloud.view_names)]


def _cloud_columns(cloud: PointCloud | StitchedCloud) -> dict[str, Any]:
    columns: dict[str, Any] = _xyz_columns(cloud.points_mm)
    columns |= {f"n{name}": cloud.normals[:, i] for i, name in enumerate("xyz")}
    columns |= {"sigma": cloud.sigma_mm, "grey": cloud.grey}
    byte = np.clip(np.rint(np.asarray(cloud.grey) * 255), 0, 255).astype(np.uint8)
    columns |= {"red": byte, "green": byte, "blue": byte}
    if isinstance(cloud, PointCloud):
        return columns | {"row": cloud.pixel[:, 0], "col": cloud.pixel[:, 1], "cameras": cloud.cameras}
    columns |= {"view": cloud.view}
    return columns if cloud.sampled_view is None else columns | {"drawn_view": cloud.sampled_view}
