"""`measureapp filter`: crop and clean a cloud before or after stitching."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.cloud import PointCloud, StitchedCloud
    from measureapp.project.geometry.files import PlainPoints


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command("filter")
    def filter_cloud(
        cloud: Annotated[Path, typer.Argument(help="A cloud: PLY, STL, OBJ, PCD, XYZ.")],
        out: Annotated[Path, typer.Option(help="The filtered cloud (.ply or .xyz).", dir_okay=False)],
        box: Annotated[str | None, typer.Option(help="Keep the points in a box: X0,X1,Y0,Y1,Z0,Z1 (mm).")] = None,
        plane: Annotated[
            list[str] | None,
            typer.Option(
                help="Keep one side of a plane: NX,NY,NZ,D with the normal towards that side, D mm from the origin; may be repeated."
            ),
        ] = None,
        radius_mm: Annotated[float | None, typer.Option(min=1e-9, help="Radius outlier removal: radius in mm …")] = None,
        least: Annotated[int, typer.Option(min=1, help="… and least number of other points within it.")] = 5,
        statistical: Annotated[
            float | None,
            typer.Option(min=0, help="Statistical outlier removal: limit in standard deviations …"),
        ] = None,
        neighbours: Annotated[int, typer.Option(min=1, help="… of the mean distance to this number of neighbours.")] = 20,
        islands_mm2: Annotated[float | None, typer.Option(min=0, help="Remove isolated patches smaller than this area.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Crop and clean a cloud: box, planes, radius, statistical, isolated patches, in this order."""
        from measureapp.errors import InputError
        from measureapp.project.geometry.files import read_points, require_writable_geometry, write_cloud
        from measureapp.register.clouds.filter_chain import Filter, apply_filters

        require_writable_geometry(out)
        if out.exists() and out.samefile(cloud):
            raise InputError(f"{out} is the cloud to be filtered.", "Name another file for the filtered one.")
        requested = [] if box is None else [Filter("box", _numbers("--box", box, 6))]
        requested += [Filter("plane", _numbers("--plane", words, 4)) for words in plane or ()]
        requested += [] if radius_mm is None else [Filter("radius", (radius_mm, least))]
        requested += [] if statistical is None else [Filter("statistical", (statistical, neighbours))]
        requested += [] if islands_mm2 is None else [Filter("islands", (islands_mm2,))]
        if not requested:
            raise InputError("No filter is given.", "Give at least one: --box, --plane, --radius-mm, --statistical, --islands-mm2.")
        plain = read_points(cloud)
        kept, removed = apply_filters(np.asarray(plain.points_mm), requested, TerminalProgress())
        write_cloud(out, _select(plain, kept))
        document = {"points": len(kept), "before": len(plain), "removed": removed, "files": {"cloud": out}}
        lines = [f"{name}: {count} points removed" for name, count in removed.items()]
        reply(document, "\n".join([*lines, f"{len(kept)} of {len(plain)} points saved to {out}"]), as_json)


def _numbers(option: str, words: str, count: int) -> tuple[float, ...]:
    from measureapp.errors import InputError

    try:
        numbers = tuple(float(word) for word in words.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != count or not np.isfinite(numbers).all():
        raise InputError(f"{option} {words}: {count} numbers are expected.", "Separate the numbers by commas.")
    return numbers


def _select(plain: PlainPoints, kept: Any) -> PointCloud | StitchedCloud:
    """Return the kept points with the columns of the file."""
    from measureapp.data.cloud import PointCloud, StitchedCloud

    count = len(kept)

    def column(values: Any, otherwise: Any) -> Any:
        return otherwise if values is None else np.asarray(values)[kept]

    points, normals = np.asarray(plain.points_mm)[kept], column(plain.normals, np.zeros((count, 3)))
    sigma, grey = column(plain.sigma_mm, np.zeros(count)), column(plain.grey, np.full(count, 0.5))
    if plain.view is not None:
        view, frame = plain.view[kept], plain.frame or "part"
        drawn = None if plain.sampled_view is None else plain.sampled_view[kept]
        return StitchedCloud(
            points, normals, sigma, grey, view, (), frame, view_names=plain.view_names, sampled_view=drawn, errors=plain.errors
        )
    pixel, cameras = column(plain.pixel, np.full((count, 2), -1)), column(plain.cameras, np.ones(count, np.uint8))
    return PointCloud(points, normals, sigma, grey, pixel, cameras, plain.frame, plain.viewpoint_id)
