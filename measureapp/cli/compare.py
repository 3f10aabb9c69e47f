"""`compare`: deviation of a cloud from a nominal mesh."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.measurement import Alignment
    from measureapp.data.mesh import Mesh
    from measureapp.project.geometry_files import PlainPoints


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def compare(
        cloud: Annotated[Path, typer.Argument(help="Cloud or mesh: PLY, STL, OBJ, PCD, XYZ; in mm.")],
        nominal: Annotated[Path, typer.Argument(help="Nominal mesh: STL, PLY, OBJ.")],
        align: Annotated[
            str, typer.Option("--align", help="best-fit, none, or a file with the 4×4 matrix nominal_from_part (text or JSON).")
        ] = "best-fit",
        as_json: JsonOption = False,
    ) -> None:
        """Compare a cloud with its nominal; deviations are positive outside."""
        from measureapp.inspection.deviation import deviation
        from measureapp.project.geometry_files import read_cloud_or_mesh, read_mesh
        from measureapp.report.json_document import alignment_document

        measured, surface = read_cloud_or_mesh(cloud), read_mesh(nominal)
        found = deviation(measured, surface, _alignment(align, measured, surface), progress=TerminalProgress())
        figures = {name: float(getattr(found, f"{name}_mm")) for name in ("mean", "rms", "p95", "min", "max")}
        document = {
            "deviation_mm": figures,
            "alignment": alignment_document(found.alignment),
            "points": len(found.distances_mm),
            "unmeasured_share": found.unmeasured_share,
        }
        lines = [
            f"Alignment: {found.alignment.name}",
            "Deviation: " + ", ".join(f"{name} {value:+.3f} mm" for name, value in figures.items()),
            f"{found.unmeasured_share:.1%} of the nominal's surface has no measured point near it.",
        ]
        if found.alignment.undetermined:
            lines.append("Left open by the points: " + ", ".join(found.alignment.undetermined) + ".")
        reply(document, "\n".join(lines), as_json)


def _alignment(align: str, measured: PlainPoints | Mesh, nominal: Mesh) -> Alignment:
    from measureapp.inspection.alignment import best_fit, given_alignment, no_alignment
    from measureapp.project.matrix_file import read_transform

    if align == "best-fit":
        return best_fit(measured, nominal)
    if align == "none":
        return no_alignment()
    return given_alignment(read_transform(Path(align), "nominal", "part"), f"given: {Path(align).name}")
