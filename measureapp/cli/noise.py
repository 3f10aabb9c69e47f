"""`noise`: the noise model of cameras from flat images."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.fringe.noise.photon_transfer import NoiseEstimate


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def noise(
        images: Annotated[list[str], typer.Option("--images", help='CAMERA="PATTERN" of its flat images; once per camera.')],
        out: Annotated[Path, typer.Option("--out", help="File of the noise models, for `decode --noise`.")],
        dark: Annotated[list[str] | None, typer.Option("--dark", help='CAMERA="PATTERN" of images with covered lens.')] = None,
        saturation: Annotated[int | None, typer.Option("--saturation", help="Grey level of a saturated pixel; needed for 16 bit.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Estimate the noise of cameras (gain, read noise, quantisation) from flat images by photon transfer.

        Take at least two images of each of five or more brightnesses, from dark to nearly saturated, of an evenly lit surface that
        does not move; images are grouped by their mean. Dark images are needed where the camera adds a black level.
        """
        from measureapp.project.fringes.noise_file import write_noise

        darks = _assigned("--dark", dark or [])
        estimates = {
            camera: _estimate(camera, pattern, darks.get(camera), saturation) for camera, pattern in _assigned("--images", images).items()
        }
        write_noise(out, estimates)
        lines = [line for name, estimate in estimates.items() for line in _lines(name, estimate)]
        reply({"cameras": {name: asdict(estimate) for name, estimate in _plain(estimates).items()}, "file": out}, "\n".join(lines), as_json)


def _assigned(option: str, values: list[str]) -> dict[str, str]:
    """Take CAMERA=PATTERN apart; raises InputError."""
    from measureapp.errors import InputError

    assigned = {}
    for value in values:
        camera, equals, pattern = value.partition("=")
        if not (camera and equals and pattern):
            raise InputError(f"{option} {value} does not name a camera.", f'Give {option} left="flats/left_*.png".')
        if camera in assigned:
            raise InputError(f"{option} gives camera {camera} twice.", "Put all its images into one pattern.")
        assigned[camera] = pattern
    return assigned


def _estimate(camera: str, pattern: str, dark: str | None, saturation: int | None) -> NoiseEstimate:
    import numpy as np

    from measureapp.errors import InputError
    from measureapp.fringe.noise.photon_transfer import estimate_noise
    from measureapp.project.fringes.noise_file import brightness_levels, read_flats

    flats = read_flats(pattern)
    eight_bit = next(iter(flats.values())).dtype == np.uint8
    if saturation is None and not eight_bit:
        raise InputError(f"The images of camera {camera} have 16 bit.", "Add --saturation: 1023, 4095 or 65535.")
    covered = None if dark is None else np.stack(list(read_flats(dark).values()))
    return estimate_noise(brightness_levels(flats), saturation or 255, camera, covered)


def _plain(estimates: dict[str, NoiseEstimate]) -> dict[str, Any]:
    from dataclasses import replace

    return {name: replace(estimate, noise=estimate.noise.model_dump()) for name, estimate in estimates.items()}  # type: ignore[arg-type]


def _lines(name: str, estimate: NoiseEstimate) -> list[str]:
    return [
        f"{name}: {estimate.gain_e_per_grey:.3g} ± {estimate.gain_sd:.1g} electrons per grey level, "
        f"full well {estimate.noise.full_well_e:.0f} ± {estimate.full_well_sd_e:.0f} e, "
        f"read noise {estimate.noise.read_noise_e:.2f} ± {estimate.read_noise_sd_e:.2f} e, grey step {estimate.noise.step_grey:g}",
        f"  {estimate.verdict}; {len(estimate.points)} brightness points",
    ]
