"""`plan extend`: viewpoints and exposures for what a scan has not measured."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.pipeline.closed_loop.next_views import Proposal
    from measureapp.pipeline.closed_loop.of_project import ClosedLoop


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def extend(
        project: Annotated[Path, typer.Argument(help="Project with a scan, its results and a nominal.")],
        most: Annotated[int, typer.Option("--most", min=1, max=100, help="Number of proposals.")] = 6,
        sigma: Annotated[
            float | None,
            typer.Option("--sigma", min=1e-4, help="Required standard deviation of a point, in mm; default: that it is measured."),
        ] = None,
        without_images: Annotated[
            bool, typer.Option("--without-images", help="Do not decode images again to find causes: faster, viewpoints only.")
        ] = False,
        write: Annotated[
            bool, typer.Option("--write", help="Store the extended plan in the project; `measureapp scan --resume` takes what is new.")
        ] = False,
        as_json: JsonOption = False,
    ) -> None:
        """State what a scan has measured of the nominal, and propose the viewpoints and exposures that gain most."""
        from measureapp.pipeline.closed_loop.next_views import NextViewsSettings
        from measureapp.pipeline.closed_loop.of_project import find_next_views
        from measureapp.project.folder import ProjectFolder

        folder = ProjectFolder.open(project)
        settings = NextViewsSettings(most=most)
        found = find_next_views(folder, settings, TerminalProgress(), required_mm=sigma, from_images=not without_images)
        written = write and bool(found.proposals)
        if written:
            with folder.lock():
                folder.save_plan(found.plan)
        reply({**_document(found), "written": written}, "\n".join(_lines(found, folder.path, written)), as_json)


def _document(found: ClosedLoop) -> dict[str, Any]:
    return {
        "coverage": {
            "measured": found.measured,
            "sufficient": found.sufficient,
            "accessible": found.accessible,
            "expected": found.expected,
            "median_sigma_mm": found.median_sigma_mm,
        },
        "missing": found.shares(),
        "holes": [
            {"cause": str(hole.cause), "area_mm2": hole.area_mm2, "fraction": hole.share, "place_mm": hole.place_mm}
            for hole in found.holes()
        ],
        "proposals": [_proposal(one) for one in found.proposals],
    }


def _proposal(one: Proposal) -> dict[str, Any]:
    return {
        "viewpoint": one.viewpoint.model_dump(mode="json", exclude_none=True),
        "kind": one.kind,
        "gain": one.share,
        "gain_mm2": one.area_mm2,
        "seconds": one.seconds,
        "reason": one.reason,
    }


def _lines(found: ClosedLoop, folder: Path, written: bool) -> list[str]:
    lines = [
        f"Measured: {found.sufficient:.1%} of the surface, of {found.accessible:.1%} that does not touch the support; "
        f"median standard deviation {found.median_sigma_mm:.4f} mm.",
        *(f"Missing: {share:.1%}, {words}." for words, share in found.shares().items()),
    ]
    if not found.proposals:
        return [*lines, "No viewpoint or exposure within reach is expected to measure more."]
    lines += [
        f"  {one.viewpoint.id}: + {one.share:.1%} in {one.seconds:.0f} s, table {one.viewpoint.table_deg:g}°, {one.reason}"
        for one in found.proposals
    ]
    lines.append(f"Expected with all of them: {found.expected:.1%}.")
    if not written:
        return [*lines, "Store the extended plan with --write."]
    plan = folder / "plan.json"
    return [*lines, f"Stored in {plan}. Take them: measureapp scan {plan} --rig RIG --project {folder} --resume."]
