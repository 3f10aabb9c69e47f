"""`measureapp filter`: cuts and cleans a cloud before or after stitching."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.arrays import BoolArray, FloatArray
    from measureapp.data.cloud import PointCloud, StitchedCloud
    from measureapp.project.geometry_files import PlainPoints


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command("filter")
    def filter_cloud(
        cloud: Annotated[Path, typer.Argument(help="A cloud of any kind that can be read.")],
        out: Annotated[Path, typer.Option(help="What stays of it (.ply or .xyz).")],
        box: Annotated[str | None, typer.Option(help="Keep what lies between: X0,X1,Y0,Y1,Z0,Z1 (mm).")] = None,
        plane: Annotated[
            list[str] | None,
            typer.Option(
                help="Keep one side of a plane: NX,NY,NZ,D with the normal showing to that side, D mm from the origin; may be repeated."
            ),
        ] = None,
        radius_mm: Annotated[float | None, typer.Option(min=1e-9, help="Drop points with too few others within this radius …")] = None,
        least: Annotated[int, typer.Option(min=1, help="… namely fewer than this many.")] = 5,
        statistical: Annotated[
            float | None,
            typer.Option(min=0, help="Drop points that stand further from their neighbours than usual, by so many deviations …"),
        ] = None,
        neighbours: Annotated[int, typer.Option(min=1, help="… of the mean distance to this many neighbours.")] = 20,
        islands_mm2: Annotated[float | None, typer.Option(min=0, help="Drop connected patches smaller than this.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Cut and clean a cloud: box, planes, radius, statistical, islands, in this order."""
        from measureapp.errors import InputError
        from measureapp.project.geometry_files import read_points, write_cloud
        from measureapp.register import filters
        from measureapp.register.cloud_quality import point_spacing_mm

        if out.suffix.lower() not in (".ply", ".xyz"):
            raise InputError(f"{out}: a cloud cannot be written as this.", "Use .ply or .xyz.")
        plain = read_points(cloud)
        sieve = _Sieve(np.asarray(plain.points_mm))
        if box is not None:
            sides = _numbers("--box", box, 6)
            low, high = sides[::2], sides[1::2]
            if not (low <= high).all():
                raise InputError("The box ends before it begins.", "Give each axis from the smaller to the larger coordinate.")
            sieve.keep("box", lambda points: filters.in_box(points, low, high))
        for side in [_numbers("--plane", words, 4) for words in plane or ()]:
            sieve.keep("plane", lambda points, side=side: filters.above_plane(points, side[:3], side[3]))
        if radius_mm is not None:
            sieve.keep("radius", lambda points: filters.crowded(points, radius_mm, least))
        if statistical is not None:
            sieve.keep("statistical", lambda points: filters.statistical(points, neighbours, statistical))
        if islands_mm2 is not None:
            sieve.keep("islands", lambda points: filters.in_large_patches(points, point_spacing_mm(points), islands_mm2))
        if not sieve.removed:
            raise InputError("No filter was asked for.", "Name at least one: --box, --plane, --radius-mm, --statistical, --islands-mm2.")
        write_cloud(out, _chosen(plain, sieve.stays))
        document = {"points": len(sieve.stays), "before": len(plain), "removed": sieve.removed, "files": {"cloud": out}}
        told = [f"{name}: {count} points removed" for name, count in sieve.removed.items()]
        reply(document, "\n".join([*told, f"{len(sieve.stays)} of {len(plain)} points in {out}"]), as_json)


def _numbers(option: str, words: str, count: int) -> FloatArray:
    from measureapp.errors import InputError

    try:
        numbers = np.array([float(word) for word in words.split(",")])
    except ValueError:
        numbers = np.empty(0)
    if len(numbers) != count or not np.isfinite(numbers).all():
        raise InputError(f"{option} {words} is not {count} numbers.", f"Give {count} numbers with commas between them.")
    return numbers


class _Sieve:
    """Points on their way through one filter after the other."""

    def __init__(self, points_mm: FloatArray) -> None:
        self._points = points_mm
        self.stays = np.arange(len(points_mm))
        self.removed: dict[str, int] = {}

    def keep(self, name: str, chosen: Any) -> None:
        """Keep what ``chosen`` says of the points that are left; raises InputError where none is."""
        from measureapp.errors import InputError

        mask: BoolArray = chosen(self._points[self.stays])
        self.removed[name] = self.removed.get(name, 0) + int(np.count_nonzero(~mask))
        self.stays = self.stays[mask]
        if len(self.stays) == 0:
            raise InputError(f"No point is left after the filter {name!r}.", "Widen it; nothing was written.")


def _chosen(plain: PlainPoints, stays: Any) -> PointCloud | StitchedCloud:
    """Return the points that stay, with what the file has of them."""
    from measureapp.data.cloud import PointCloud, StitchedCloud

    count = len(stays)

    def column(values: Any, otherwise: Any) -> Any:
        return otherwise if values is None else np.asarray(values)[stays]

    points, normals = np.asarray(plain.points_mm)[stays], column(plain.normals, np.zeros((count, 3)))
    sigma, grey = column(plain.sigma_mm, np.zeros(count)), column(plain.grey, np.full(count, 0.5))
    if plain.view is not None:
        view, frame = plain.view[stays], plain.frame or "part"
        return StitchedCloud(points, normals, sigma, grey, view, (), frame, view_names=plain.view_names)
    pixel, cameras = column(plain.pixel, np.full((count, 2), -1)), column(plain.cameras, np.ones(count, np.uint8))
    return PointCloud(points, normals, sigma, grey, pixel, cameras, plain.frame, plain.viewpoint_id)
