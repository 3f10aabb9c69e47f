"""`noise`: noise models of the cameras by photon transfer."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.fringe.noise.photon_transfer import NoiseEstimate

REPEATS = 4  # images of every exposure that a rig takes


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def noise(
        images: Annotated[
            list[str] | None, typer.Option("--images", help='CAMERA="PATTERN" of its flat-field images; once per camera.')
        ] = None,
        rig: Annotated[
            str | None, typer.Option("--rig", help="Rig whose cameras take the images: a TOML file, or a name in resources/rigs.")
        ] = None,
        fringes: Annotated[
            Path | None,
            typer.Option("--fringes", metavar="MANIFEST", help="MANIFEST.toml of recorded fringes, instead of flat-field images."),
        ] = None,
        plan: Annotated[Path | None, typer.Option("--plan", help="With --rig: first move to the first viewpoint of this plan.")] = None,
        out: Annotated[
            Path | None, typer.Option("--out", help="File for the noise models, used by `decode --noise`.", dir_okay=False)
        ] = None,
        project: Annotated[
            Path | None,
            typer.Option("--project", help="Project in which to store the noise models; its images are decoded with them from then on."),
        ] = None,
        dark: Annotated[list[str] | None, typer.Option("--dark", help='CAMERA="PATTERN" of dark images (lens covered).')] = None,
        saturation: Annotated[int | None, typer.Option("--saturation", help="Grey level of a saturated pixel; needed for 16 bit.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Estimate the noise of cameras (gain, read noise, quantisation) by photon transfer.

        From files: at least two images at each of five or more brightness levels, from dark to nearly saturated, of an evenly lit
        stationary surface; images are grouped by their mean. Dark images are needed if the camera adds a black level. With a rig:
        any stationary scene at seven exposures; without --plan nothing moves. From fringes: residuals of four or more phase steps;
        non-sinusoidal light and motion count as noise there, and are reported if detected.
        """
        from measureapp.errors import InputError
        from measureapp.project.folder import ProjectFolder
        from measureapp.project.fringes.noise_file import write_noise

        if sum([rig is not None, bool(images), fringes is not None]) != 1:
            raise InputError(
                "Exactly one of --images, --rig and --fringes is needed.", "Give --images once for every camera, or one of the others."
            )
        if out is None and project is None:
            raise InputError("There is no destination for the noise models.", "Add --out FILE or --project PROJECT.")
        if rig is None and plan is not None:
            raise InputError("--plan needs --rig.", "Add --rig, or omit --plan.")
        if not images and (dark or saturation is not None):
            raise InputError("--dark and --saturation need --images.", "Omit them: the rig or the manifest states the saturation.")
        opened = None if project is None else ProjectFolder.open(project)
        if fringes is not None:
            estimates = _of_fringes(fringes)
        else:
            estimates = _of_files(images or [], dark or [], saturation) if rig is None else _of_rig(rig, plan)
        if opened is not None:
            with opened.lock():
                opened.save_noise(estimates)
        if out is not None:
            write_noise(out, estimates)
        lines = [line for name, estimate in estimates.items() for line in _lines(name, estimate)]
        places = {key: place for key, place in (("file", out), ("project", project)) if place is not None}
        reply({"cameras": {name: asdict(estimate) for name, estimate in _plain(estimates).items()}, **places}, "\n".join(lines), as_json)


def _of_files(images: list[str], dark: list[str], saturation: int | None) -> dict[str, NoiseEstimate]:
    darks = _parse_assignments("--dark", dark)
    return {
        camera: _estimate(camera, pattern, darks.get(camera), saturation)
        for camera, pattern in _parse_assignments("--images", images).items()
    }


def _of_fringes(manifest: Path) -> dict[str, NoiseEstimate]:
    from measureapp.fringe.noise.stack_noise import noise_of_stack
    from measureapp.project.fringes.manifest import read_manifest

    stack = read_manifest(manifest)
    return {camera: noise_of_stack(stack, camera) for camera in stack.images}


def _of_rig(rig: str, plan: Path | None) -> dict[str, NoiseEstimate]:
    from measureapp.devices.connect import connect_rig
    from measureapp.pipeline.noise import measure_noise
    from measureapp.project.plan_file import read_plan
    from measureapp.project.rig_file import read_rig

    viewpoint = None if plan is None else read_plan(plan)[0]
    connected = connect_rig(read_rig(rig))
    try:
        if viewpoint is not None:
            connected.place_on_table("part")
        return measure_noise(connected, viewpoint, REPEATS, TerminalProgress())
    finally:
        connected.close()


def _parse_assignments(option: str, values: list[str]) -> dict[str, str]:
    """Parse CAMERA=PATTERN; raises InputError."""
    from measureapp.errors import InputError

    assigned = {}
    for value in values:
        camera, equals, pattern = value.partition("=")
        if not (camera and equals and pattern):
            raise InputError(f"{option} {value} does not name a camera.", f'Give {option} left="flats/left_*.png".')
        if camera in assigned:
            raise InputError(f"{option} names camera {camera} twice.", "Match all its images by one pattern.")
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
        raise InputError(f"The 16-bit images of camera {camera} need a saturation level.", "Add --saturation: 1023, 4095 or 65535.")
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
