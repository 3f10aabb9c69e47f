"""`measureapp fit`: fit of one shape to the points of a file."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from measureapp.cli.reply import JsonOption, UnitOption, reply, triple
from measureapp.data.length_unit import LengthUnit

if TYPE_CHECKING:
    from measureapp.arrays import FloatArray
    from measureapp.geometry.feature import Feature
    from measureapp.geometry.minimum_zone import MinimumZone


class ShapeName(StrEnum):
    """Shapes to fit."""

    PLANE = "plane"
    LINE = "line"
    CIRCLE = "circle"
    SPHERE = "sphere"
    CYLINDER = "cylinder"
    CONE = "cone"
    TORUS = "torus"


class Criterion(StrEnum):
    """Fit criterion."""

    LEAST_SQUARES = "least-squares"
    MINIMUM_ZONE = "minimum-zone"


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command("fit")
    def fit_points(
        shape: Annotated[ShapeName, typer.Argument(help="The shape to fit.")],
        points: Annotated[
            Path,
            typer.Argument(
                help="Text file with one point per line (white space, commas or semicolons; columns named x, y, z in any order), or a PLY, STL, OBJ or PCD file."
            ),
        ],
        criterion: Annotated[Criterion, typer.Option(help="Fit criterion.")] = Criterion.LEAST_SQUARES,
        robust: Annotated[bool, typer.Option("--robust", help="Reject outliers and report their number.")] = False,
        unit: UnitOption = LengthUnit.MM,
        as_json: JsonOption = False,
    ) -> None:
        """Fit a shape to points by orthogonal distances."""
        from measureapp.errors import FitError
        from measureapp.geometry.fits import fit
        from measureapp.geometry.minimum_zone import fit_minimum_zone

        read, dropped = _read(points, unit)
        if criterion is Criterion.MINIMUM_ZONE and robust:
            raise FitError("A minimum zone contains all points, it cannot reject outliers.", "Omit --robust.")
        if criterion is Criterion.MINIMUM_ZONE:
            zone = fit_minimum_zone(shape.value, read)
            document = _document(zone.feature, criterion.value) | {"proof": _proof(zone)}
        else:
            document = _document(fit(shape.value, read, robust=robust), criterion.value)
        document["without_coordinates"] = dropped
        reply(document, _lines(document), as_json)


def _read(path: Path, unit: LengthUnit) -> tuple[FloatArray, int]:
    """Return the points in mm, and the number of those in the file that have no finite coordinates."""
    from measureapp.errors import InputError
    from measureapp.project.geometry.files import KINDS, check_stated_unit, read_points
    from measureapp.project.geometry.point_files import read_text_points

    if path.suffix.lower() in KINDS or not path.is_file():
        read = read_points(path, unit)
        return read.points_mm, read.dropped
    table = read_text_points(path)
    check_stated_unit(path, table.unit, unit)
    if not np.isfinite(table.points).all():
        raise InputError(f"{path} contains non-finite coordinates.", "Remove these lines.")
    return table.points * unit.in_mm, 0


def _document(made: Feature, criterion: str) -> dict[str, Any]:
    from measureapp.geometry.fits import LEAST_POINTS

    is_judged = made.points > LEAST_POINTS[made.shape]  # else any scatter fits exactly, which is no precision
    document: dict[str, Any] = {"shape": made.shape, "criterion": criterion, "point_mm": made.point_mm, "direction": made.direction}
    document["radius_mm"] = made.radius_mm
    document["half_angle_deg"] = None if made.half_angle_rad is None else float(np.degrees(made.half_angle_rad))
    document["minor_radius_mm"] = made.minor_radius_mm
    document = {name: value for name, value in document.items() if value is not None}
    deviations = {name: value for name, value in made.standard_deviations.items() if not name.endswith("_rad")}
    deviations |= {
        f"{name[:-4]}_deg": float(np.degrees(value)) for name, value in made.standard_deviations.items() if name.endswith("_rad")
    }
    return document | {
        "form_error_mm": made.form_error_mm,
        "rms_mm": made.rms_mm,
        "points": made.points,
        "left_out": made.left_out,
        "standard_deviations": deviations if is_judged else None,
        "covariance": made.covariance if is_judged else None,
    }


def _proof(zone: MinimumZone) -> dict[str, Any]:
    """Return the proof of optimality of a minimum zone: contact points (from 1), their multipliers, and the remaining imbalance."""
    return {"contacts": (zone.contacts + 1).tolist(), "shares": zone.multipliers.tolist(), "imbalance": zone.imbalance}


def _lines(document: dict[str, Any]) -> str:
    rows = []
    for name, value in document.items():
        if name == "standard_deviations" and value is None:
            rows.append(f"{'σ':<18} not determined: as many points as the shape needs")
        elif name == "without_coordinates":
            rows += [f"{value} points of the file have no finite coordinates and are not used"] if value else []
        elif name == "standard_deviations":
            rows += [f"{'σ ' + key:<18} {sigma:.3g}" for key, sigma in value.items()]
        elif name == "proof":
            rows.append(f"{'proof':<18} contact points {', '.join(map(str, value['contacts']))}; imbalance {value['imbalance']:.0e}")
        elif name == "covariance":
            continue  # a table of numbers, for --json only
        elif isinstance(value, float):
            rows.append(f"{name:<18} {value:.6f}")
        elif isinstance(value, np.ndarray):
            rows.append(f"{name:<18} " + triple(value, 6))
        else:
            rows.append(f"{name:<18} {value}")
    return "\n".join(rows)
