"""`measureapp compare`: deviation of a cloud from a nominal mesh."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.outcome import alignment_lines
from measureapp.cli.reply import JsonOption, TerminalProgress, UnitOption, reply, triple
from measureapp.data.length_unit import LengthUnit
from measureapp.data.shown_number import shown_number
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.measurement import Alignment
    from measureapp.data.mesh import Mesh
    from measureapp.inspection.surface.cutting_surface import CuttingSurface
    from measureapp.inspection.surface.deviation import Deviation
    from measureapp.inspection.surface.statistics import DeviationStatistics
    from measureapp.project.geometry.files import PlainPoints

AMOUNTS = ("rms", "p95")  # figures that have no sign
LARGEST_MM = 1000.0
SECTION_FILE = Path("sections.csv")
SECTION = re.compile(r"\s*([xyzr])\s*=\s*([-+]?\d+(?:\.\d*)?)\s*")


def _millimetres(words: str) -> Any:
    """Return an option that is a distance."""
    return typer.Option(min=0.001, max=LARGEST_MM, help=words)


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def compare(
        cloud: Annotated[Path, typer.Argument(help="Cloud or mesh: PLY, STL, OBJ, PCD, XYZ.")],
        nominal: Annotated[Path, typer.Argument(help="Nominal: STL, PLY, OBJ, or STEP (with the optional library cascadio).")],
        align: Annotated[
            str,
            typer.Option("--align", help="best-fit, none, cyclic:COUNT, or a file with the 4×4 matrix nominal_from_part (text or JSON)."),
        ] = "best-fit",
        tolerance: Annotated[
            tuple[float, float] | None, typer.Option(help="Lower and upper tolerance in mm, for a histogram of the deviations.")
        ] = None,
        section: Annotated[
            list[str] | None, typer.Option(help="Section (may be repeated): x=0, y=-5, z=20, or r=100 about the z axis.")
        ] = None,
        section_width: Annotated[float, _millimetres("Width of the strip of points of a section, in mm.")] = 1.0,
        section_file: Annotated[Path, typer.Option(help="Output file of the sections: CSV or JSON, by its extension.")] = SECTION_FILE,
        map_file: Annotated[
            Path | None, typer.Option("--map", help="Write the nominal coloured by deviation as PLY; grey where not measured.")
        ] = None,
        reach: Annotated[float, _millimetres("The nominal counts as measured where a point lies closer than this, in mm.")] = 2.0,
        search: Annotated[
            float, _millimetres("Points farther than this from the nominal are counted, not compared (statistics), in mm.")
        ] = 2.0,
        unit: UnitOption = LengthUnit.MM,
        nominal_unit: Annotated[LengthUnit, typer.Option("--nominal-unit", help="Unit of the nominal.")] = LengthUnit.MM,
        as_json: JsonOption = False,
    ) -> None:
        """Compare a cloud with its nominal; deviations are positive outside the material."""
        from measureapp.inspection.surface.deviation import compute_deviation
        from measureapp.project.geometry.files import read_cloud_or_mesh, read_mesh
        from measureapp.report.json_document import alignment_document, statistics_document

        measured, surface = read_cloud_or_mesh(cloud, unit=unit), read_mesh(nominal, unit=nominal_unit)
        found = compute_deviation(measured, surface, _alignment(align, measured, surface), near_mm=reach, progress=TerminalProgress())
        figures = {name: float(getattr(found, f"{name}_mm")) for name in ("mean", "rms", "p95", "min", "max")}
        document: dict[str, Any] = {
            "deviation_mm": figures,
            "alignment": alignment_document(found.alignment),
            "points": len(found.distances_mm),
            "unmeasured_share": found.unmeasured_share,
        }
        lines = _summary_lines(found, figures)
        statistics = _statistics(found, surface, measured, tolerance, search)
        document["deviation_statistics"], lines = statistics_document(statistics), [*lines, *_statistics_lines(statistics)]
        if tolerance is not None:
            document["bands"] = _bands_document(found, tolerance, lines)
        if section:
            _write_sections(found, surface, section, section_width, section_file)
            document["sections"] = str(section_file)
            lines.append(f"Sections saved to {section_file}")
        if map_file is not None:
            _write_map(found, surface, reach, statistics, map_file)
            document["map"] = str(map_file)
            lines.append(f"Deviation map saved to {map_file}")
        reply(document, "\n".join(lines), as_json)


def _statistics(
    found: Deviation, nominal: Mesh, measured: PlainPoints | Mesh, tolerance: tuple[float, float] | None, search_mm: float
) -> DeviationStatistics:
    from measureapp.data.mesh import Mesh
    from measureapp.inspection.surface.statistics import compute_statistics

    surface = measured.seen_from(found.alignment.nominal_from_part) if isinstance(measured, Mesh) else None
    return compute_statistics(found, nominal, tolerance_mm=tolerance, search_mm=search_mm, surface=surface)


def _statistics_lines(found: DeviationStatistics) -> list[str]:
    confirmed = [
        f"{word} {shown_number(one.value_mm, signed=True)} mm at {triple(one.point_mm, 1)}"
        for word, one in (("smallest", found.minimum), ("greatest", found.maximum))
        if one is not None
    ]
    lines = [f"Confirmed by neighbours, as in reports: {', '.join(confirmed)}."] if confirmed else []
    area = found.no_data
    lines.append(f"No data: {area.not_seen:.1%} not seen, {area.filled:.1%} filled, {area.too_far:.1%} beyond {found.search_mm:g} mm.")
    return lines


def _summary_lines(found: Deviation, figures: dict[str, float]) -> list[str]:
    return [
        alignment_lines(found.alignment),
        f"Deviation of all {len(found.distances_mm):,} points: "
        + ", ".join(f"{name} {shown_number(value, signed=name not in AMOUNTS)} mm" for name, value in figures.items()),
        f"Not measured: {found.unmeasured_share:.1%} of the nominal's surface.",
    ]


def _alignment(align: str, measured: PlainPoints | Mesh, nominal: Mesh) -> Alignment:
    from measureapp.inspection.alignment.best_fit import best_fit, given_alignment, no_alignment
    from measureapp.project.calibration.matrix_file import read_transform

    if align == "best-fit":
        return best_fit(measured, nominal)
    if align == "none":
        return no_alignment()
    if align.startswith("cyclic:"):
        return _cyclic(align, measured, nominal)
    return given_alignment(read_transform(Path(align), "nominal", "part"), f"given: {Path(align).name}")


def _cyclic(align: str, measured: PlainPoints | Mesh, nominal: Mesh) -> Alignment:
    from measureapp.data.alignment_program import BestFit
    from measureapp.inspection.alignment.best_fit import best_fit
    from measureapp.inspection.alignment.cyclic_fit import cyclic_fit
    from measureapp.inspection.measured_points import MeasuredPoints
    from measureapp.inspection.settings import InspectionSettings
    from measureapp.inspection.surface.nominal import NominalSurface

    count = align.removeprefix("cyclic:")
    if not count.isdigit() or not 2 <= int(count) <= 1000:
        raise InputError(f"--align {align}: the number of positions must be 2 to 1000.", "Example: cyclic:7.")
    points, surface, settings = MeasuredPoints.of(measured), NominalSurface(nominal), InspectionSettings()
    return cyclic_fit(points, surface, BestFit(fold=int(count)), best_fit(points, surface, settings.alignment), settings)


def _bands_document(found: Deviation, tolerance: tuple[float, float], lines: list[str]) -> dict[str, Any]:
    """Return the histogram over the tolerance, and add its line."""
    from measureapp.inspection.surface.histogram import bin_deviations

    bands = bin_deviations(found.distances_mm, *tolerance)
    lines.append(f"Points below the tolerance {bands.below:.2%}, within {bands.within:.2%}, above {bands.above:.2%}.")
    shares = {"below": bands.below, "within": bands.within, "above": bands.above}
    return {**shares, "edges_mm": bands.edges_mm.tolist(), "counts": bands.counts.tolist()}


def _write_sections(found: Deviation, nominal: Mesh, named: list[str], width_mm: float, path: Path) -> None:
    from measureapp.inspection.surface.nominal import NominalSurface
    from measureapp.inspection.surface.section import cut_section
    from measureapp.project.geometry.deviation_files import write_sections

    surface = NominalSurface(nominal)
    made = [cut_section(words, found, surface, _cutting_surface(words), width_mm / 2) for words in named]
    write_sections(path, made, found.alignment.name)


def _cutting_surface(words: str) -> CuttingSurface:
    """Parse a section: a plane at a coordinate (`z=20`), or a cylinder about the nominal's z axis (`r=100`). Raises InputError."""
    import numpy as np

    from measureapp.inspection.surface.cutting_surface import CuttingCylinder, CuttingPlane

    match = SECTION.fullmatch(words)
    if match is None or (match[1] == "r" and float(match[2]) <= 0):
        raise InputError(f"{words!r} is not a section.", "Give a plane like x=0, y=-5 or z=20, or a cylinder about the z axis like r=100.")
    value, up = float(match[2]), np.array([0.0, 0.0, 1.0])
    if match[1] == "r":
        return CuttingCylinder.about(np.zeros(3), up, value)
    normal = np.eye(3)["xyz".index(match[1])]
    return CuttingPlane.through(value * normal, normal)


def _write_map(found: Deviation, nominal: Mesh, reach_mm: float, statistics: DeviationStatistics, path: Path) -> None:
    import numpy as np

    from measureapp.inspection.surface.colour_scale import ColourScale
    from measureapp.inspection.surface.deviation_map import map_deviation
    from measureapp.project.geometry.deviation_files import write_deviation_map
    from measureapp.report.deviation_pictures import NOT_MEASURED

    made = map_deviation(found, nominal, reach_mm)
    scale = ColourScale(*statistics.range_mm, tolerance=statistics.tolerance_mm)
    colours = scale.colours(np.nan_to_num(made.distances_mm)) / 255.0
    colours[~made.measured] = NOT_MEASURED
    write_deviation_map(path, made, colours, found.alignment.name)
