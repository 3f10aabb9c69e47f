"""`bracket`: choice of exposures for a scene, from a recorded probe."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.fringe.exposures.bracket import BracketFigures, BracketProposal

MultipleOption = Annotated[
    float | None,
    typer.Option("--multiple-us", help="Exposures are multiples of this: the projector's frame time, or 10000 against 50 Hz flicker."),
]


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def bracket(
        manifest: Annotated[Path, typer.Argument(help="MANIFEST.toml of a recorded probe: the patterns at one or a few exposures.")],
        budget_s: Annotated[float, typer.Option("--budget-s", min=0.001, help="Time for all images of one viewpoint.")] = 5.2,
        most: Annotated[int, typer.Option("--max-exposures", min=1, max=16, help="Greatest number of exposures.")] = 5,
        noise: Annotated[Path | None, typer.Option("--noise", help="Noise models of the cameras, from `measureapp noise`.")] = None,
        readout_ms: Annotated[float, typer.Option("--readout-ms", min=0.0, help="Read-out of an image, after its exposure.")] = 69.0,
        longest_us: Annotated[int, typer.Option("--longest-us", min=1, help="Longest exposure of the cameras.")] = 500_000,
        multiple_us: MultipleOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Propose exposures for a scene from a probe, with the predicted phase noise and share of decodable pixels.

        The manifest is that of `decode`; its exposures are compared with the proposal. A probe with a long and a short exposure
        is best: the long one shows dark areas, the short one glossy areas.
        """
        from measureapp.fringe.exposures.bracket import BracketLimits, propose_bracket
        from measureapp.fringe.exposures.probe import read_probe
        from measureapp.project.fringes.manifest import read_manifest
        from measureapp.project.fringes.noise_file import read_noise

        stack = read_manifest(manifest)
        limits = BracketLimits(budget_s, most, readout_ms, longest_us=longest_us, multiple_us=multiple_us)
        models = read_noise(noise) if noise is not None else {}
        proposal = propose_bracket(read_probe(stack, models), stack.patterns, limits, compare={"probe": stack.exposures_us})
        reply(asdict(proposal), "\n".join(_lines(proposal)), as_json)


def _lines(proposal: BracketProposal) -> list[str]:
    lines = [f"proposed: {_line(proposal.figures)}"]
    lines += [f"best with {len(figures.exposures_us)}: {_line(figures)}" for figures in proposal.by_count]
    lines += [f"{name}: {_line(figures)}" for name, figures in proposal.compared.items()]
    return [*lines, proposal.note] if proposal.note else lines


def _line(figures: BracketFigures) -> str:
    exposures = ", ".join(f"{exposure / 1000:g}" for exposure in figures.exposures_us)
    return (
        f"{exposures} ms: {figures.decodable_share:.2%} of the lit pixels decodable, phase noise {figures.median_sigma_rad:.4f} rad (median), "
        f"{figures.time_s:.2f} s"
    )
