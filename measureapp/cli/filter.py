"""`measureapp filter`: cuts and cleans a cloud before or after stitching."""

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
        from measureapp.project.geometry.files import read_points, write_cloud
        from measureapp.register.clouds.sieve import Filter, sieved

        if out.suffix.lower() not in (".ply", ".xyz"):
            raise InputError(f"{out}: a cloud cannot be written as this.", "Use .ply or .xyz.")
        asked = [] if box is None else [Filter("box", _numbers("--box", box, 6))]
        asked += [Filter("plane", _numbers("--plane", words, 4)) for words in plane or ()]
        asked += [] if radius_mm is None else [Filter("radius", (radius_mm, least))]
        asked += [] if statistical is None else [Filter("statistical", (statistical, neighbours))]
        asked += [] if islands_mm2 is None else [Filter("islands", (islands_mm2,))]
        if not asked:
            raise InputError("No filter was asked for.", "Name at least one: --box, --plane, --radius-mm, --statistical, --islands-mm2.")
        plain = read_points(cloud)
        stays, removed = sieved(np.asarray(plain.points_mm), asked, TerminalProgress())
        write_cloud(out, _chosen(plain, stays))
        document = {"points": len(stays), "before": len(plain), "removed": removed, "files": {"cloud": out}}
        told = [f"{name}: {count} points removed" for name, count in removed.items()]
        reply(document, "\n".join([*told, f"{len(stays)} of {len(plain)} points in {out}"]), as_json)


def _numbers(option: str, words: str, count: int) -> tuple[float, ...]:
    from measureapp.errors import InputError

    try:
        numbers = tuple(float(word) for word in words.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != count or not np.isfinite(numbers).all():
        raise InputError(f"{option} {words} is not {count} numbers.", f"Give {count} numbers with commas between them.")
    return numbers


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
        drawn = None if plain.drawn_view is None else plain.drawn_view[stays]
        return StitchedCloud(
            points, normals, sigma, grey, view, (), frame, view_names=plain.view_names, drawn_view=drawn, errors=plain.errors
        )
    pixel, cameras = column(plain.pixel, np.full((count, 2), -1)), column(plain.cameras, np.ones(count, np.uint8))
    return PointCloud(points, normals, sigma, grey, pixel, cameras, plain.frame, plain.viewpoint_id)
