"""`exposures`: fractions of valid pixels per exposure, and what both rules of selection make of them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.pipeline.exposures import ProjectExposures, RuleResult

TITLES = {"combined": "all unsaturated exposures", "paper": "brightest unsaturated exposure"}


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def exposures(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        viewpoint: Annotated[
            list[str] | None, typer.Option("--viewpoint", help="Viewpoint of the project; may be given several times. Default: all.")
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Count the valid pixels of every exposure and of their composite.

        A pixel is valid in an exposure when it is above zero and unsaturated in all its images, and in the composite when it is
        above zero in the longest exposure in which it is unsaturated; fractions are of the whole image. The stored images are decoded
        twice: combined, with all unsaturated exposures weighted by signal and noise, as the program measures; and by the paper's rule,
        with the brightest unsaturated one. The project is not changed.
        """
        from measureapp.pipeline.exposures import project_exposures
        from measureapp.project.folder import ProjectFolder

        found = project_exposures(ProjectFolder.open(project), viewpoint or (), TerminalProgress())
        reply(_document(found), "\n".join(_lines(found)), as_json)


def _document(found: ProjectExposures) -> dict[str, Any]:
    return {
        "viewpoints": {
            name: {
                camera: {
                    "exposures": [
                        {"exposure_us": time, "valid_ratio": ratio} for time, ratio in zip(one.exposures_us, one.valid_ratios, strict=True)
                    ],
                    "rules": {
                        rule: {
                            "composite_ratio": made.composite_ratio,
                            "decoded_ratio": made.decoded_ratio,
                            "phase_sigma_median": made.sigma_rad,
                        }
                        for rule, made in one.rules.items()
                    },
                }
                for camera, one in cameras.items()
            }
            for name, cameras in found.viewpoints.items()
        },
        "failed": dict(found.failed),
    }


def _lines(found: ProjectExposures) -> Iterator[str]:
    for name, cameras in found.viewpoints.items():
        for camera, one in cameras.items():
            pairs = zip(one.exposures_us, one.valid_ratios, strict=True)
            single = ", ".join(f"{time / 1000:g} ms {ratio:.1%}" for time, ratio in pairs)
            yield f"{name} {camera}: {single}"
            yield from (f"  {TITLES[rule]}: {_result(made)}" for rule, made in one.rules.items())
    yield from (f"{name}: {problem}" for name, problem in found.failed.items())


def _result(made: RuleResult) -> str:
    sigma = "" if made.sigma_rad is None else f", phase noise {made.sigma_rad:.4f} rad (median)"
    return f"composite {made.composite_ratio:.1%}, decoded {made.decoded_ratio:.1%}{sigma}"
