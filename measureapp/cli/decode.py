"""`decode`: absolute phase from recorded fringe images."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.fringe import FringeStack
    from measureapp.data.phase import PhaseMap
    from measureapp.fringe.settings import DecodeSettings

RuleOption = Annotated[
    str, typer.Option("--rule", help="combined: all unsaturated exposures; paper: the brightest unsaturated one of each pixel.")
]
PerFrequencyOption = Annotated[bool, typer.Option("--per-frequency", help="Choose the exposures for each pitch separately.")]
NoiseOption = Annotated[Path | None, typer.Option("--noise", help="Noise models of the cameras, from `measureapp noise`.")]
ResponseOption = Annotated[Path | None, typer.Option("--response", help="Projector response, from `measureapp response`.")]
ModulationOption = Annotated[
    float | None,
    typer.Option("--min-modulation", help="Least modulation of a valid pixel, in grey levels of 255; else 3."),
]
PhaseSigmaOption = Annotated[
    float | None, typer.Option("--max-phase-sigma", help="Largest standard deviation of a phase in radians; else 0.25.")
]
BloomingOption = Annotated[
    str,
    typer.Option(
        "--blooming-px",
        metavar="0…16|auto",
        help="Radius around saturated pixels within which the exposure is not used; auto: estimated from the images.",
    ),
]


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def decode(
        manifest: Annotated[Path, typer.Argument(help="MANIFEST.toml of the recorded images.")],
        out: Annotated[Path, typer.Option("--out", help="Folder for the phase maps, one .npz per camera.", file_okay=False)],
        rule: RuleOption = "combined",
        per_frequency: PerFrequencyOption = False,
        noise: NoiseOption = None,
        response: ResponseOption = None,
        blooming_px: BloomingOption = "0",
        min_modulation: ModulationOption = None,
        max_phase_sigma: PhaseSigmaOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Decode fringe images: exposure synthesis, wrapped phase, absolute phase.

        MANIFEST.toml has shift_sign (image n is A + B cos(phase + shift_sign · 2πn/N)), saturation, projector_px, and from long to
        short [[exposure]] tables with exposure_us and [[exposure.group]] tables: kind = "phase-shift" with pitch_px or periods, or
        kind = "gray-code" (most significant bit first; complementary = true when a shifted last plane follows); each with
        images = { camera = ["file", …] }. Groups may have direction = "horizontal" (then projector_rows is the height, over which
        periods extend), and steps or planes, the expected number of images; one file may contain both directions.
        `measureapp patterns export` writes a manifest template.

        A phase map contains phase_rad, sigma_rad, modulation, grey, snr (modulation over noise), exposure_index and mask: 0 valid,
        1 saturated, 2 weak modulation, 3 shadow, 4 order conflict, 5 out of range, 6 edge, 7 blooming. For sets with orthogonal
        fringes it contains the same arrays for the horizontal ones, with the prefix across_.
        """
        from measureapp.fringe.decode import decode as decode_stack
        from measureapp.project.fringes.manifest import read_manifest
        from measureapp.project.fringes.phase_file import write_phase_map

        stack = read_manifest(manifest)
        settings = with_limits(decode_settings(stack, rule, per_frequency, noise, response, blooming_px), min_modulation, max_phase_sigma)
        maps = decode_stack(stack, settings, TerminalProgress())
        cameras = {}
        for name, phase_map in maps.items():
            file = out / f"{name}.npz"
            write_phase_map(file, phase_map)
            cameras[name] = {**figures(phase_map), "file": file}
            if not phase_map.valid.any():
                cameras[name]["no_phase"] = "no pixel has a phase: {}. {}".format(*most_frequent_loss(phase_map))
        lines = [line for name, entry in cameras.items() for line in _lines(name, entry)]
        reply({"cameras": cameras, "settings": settings.model_dump()}, "\n".join(lines), as_json)


def decode_settings(
    stack: FringeStack, rule: str, per_frequency: bool, noise: Path | None, response: Path | None, blooming_px: str = "0"
) -> DecodeSettings:
    """Return the decode settings of the options; raises InputError for an unknown rule, or a file that does not match the images."""
    from measureapp.errors import InputError
    from measureapp.fringe.settings import DecodeSettings
    from measureapp.project.fringes.noise_file import read_noise
    from measureapp.project.fringes.response_file import read_response

    if rule not in ("combined", "paper"):
        raise InputError(f"--rule {rule} is unknown.", "Give combined or paper.")
    known = read_noise(noise) if noise else {}
    missing = sorted(set(stack.images) - set(known)) if noise else []
    if missing:
        raise InputError(f"{noise} has no camera {missing[0]!r}.", "Measure the noise of every camera, or omit --noise.")
    settings = DecodeSettings(
        rule="paper" if rule == "paper" else "combined",
        joint=not per_frequency,
        camera_noise=known,
        phase_correction=read_response(response).phase_correction(stack.patterns) if response else (),
    )
    return settings.model_copy(update={"blooming_radius_px": _blooming_px(stack, settings, blooming_px)})


def with_limits(settings: DecodeSettings, min_modulation: float | None, max_phase_sigma: float | None) -> DecodeSettings:
    """Return the settings with limits of the command line; raises InputError for values that are none."""
    from measureapp.errors import InputError

    if min_modulation is not None and not 0 <= min_modulation < 255:
        raise InputError(f"--min-modulation {min_modulation:g} is not from 0 to below 255.", "Give grey levels of an 8-bit image.")
    if max_phase_sigma is not None and not 0 < max_phase_sigma <= math.pi:
        raise InputError(f"--max-phase-sigma {max_phase_sigma:g} is not an angle above 0, up to π.", "Give radians.")
    return settings.limited(min_modulation, max_phase_sigma)


def _blooming_px(stack: FringeStack, settings: DecodeSettings, wanted: str) -> int:
    """Return the radius of the blooming guard; raises InputError."""
    from measureapp.errors import InputError
    from measureapp.fringe.exposures.spill import FARTHEST_PX, spill_radius_px

    if wanted == "auto":
        return max(spill_radius_px(stack, camera, settings.noise_of(camera)) for camera in stack.images)
    if not wanted.isdecimal() or int(wanted) > FARTHEST_PX:
        raise InputError(f"--blooming-px {wanted} is not a radius.", f"Give a whole number up to {FARTHEST_PX}, or auto.")
    return int(wanted)


def figures(phase_map: PhaseMap) -> dict[str, Any]:
    """Return the decoding figures of one camera."""
    from dataclasses import asdict

    import numpy as np

    from measureapp.data.phase import PixelState

    valid = phase_map.valid
    return {
        "valid_ratio": {"exposures": phase_map.valid_ratio_exposures, "composite": phase_map.valid_ratio_composite},
        "decoded_ratio": float(valid.mean()),
        "decoded_px": int(valid.sum()),
        "modulation_median": float(np.median(phase_map.modulation[valid])) if valid.any() else 0.0,
        "phase_sigma_median": float(np.median(phase_map.sigma_rad[valid])) if valid.any() else None,
        "snr_median": float(np.median(phase_map.snr[valid])) if valid.any() else 0.0,
        "order_conflicts": int((phase_map.state == PixelState.ORDER_CONFLICT).sum()),
        "noise": None if phase_map.evidence is None else asdict(phase_map.evidence),
        "orders_repaired": int(phase_map.details.get("orders_repaired", 0)),
        "rejected": {state.name.lower(): int((phase_map.state == state).sum()) for state in PixelState if state != PixelState.VALID},
    }


def most_frequent_loss(phase_map: PhaseMap) -> tuple[str, str]:
    """Return the most frequent reason for missing phase with its share of the image, and a remedy."""
    from measureapp.data.phase import PixelState

    lost = {state: int((phase_map.state == state).sum()) for state in PixelState if state != PixelState.VALID}
    state = max(lost, key=lambda each: lost[each])
    share = f"{state.name.lower().replace('_', ' ')} in {lost[state] / phase_map.state.size:.0%} of the image"
    if state == PixelState.SATURATED:
        return share, "Add a shorter exposure, or reduce the light of the projector."
    if state in (PixelState.SHADOW, PixelState.WEAK_MODULATION):
        return share, "Add a longer exposure, and check that the projector illuminates the part."
    return share, "Check pitches, projector_px and shift_sign in the manifest."


def _lines(name: str, entry: dict[str, Any]) -> list[str]:
    exposures = ", ".join(f"{ratio:.1%}" for ratio in entry["valid_ratio"]["exposures"])
    sigma = entry["phase_sigma_median"]
    noise = (
        f"modulation {entry['modulation_median']:.1f}, phase noise {sigma:.4f} rad (medians)" if sigma is not None else entry["no_phase"]
    )
    return [
        f"{name}: valid per exposure {exposures}; composite {entry['valid_ratio']['composite']:.1%}; decoded {entry['decoded_ratio']:.1%}",
        *([_noise_line(entry["noise"])] if entry["noise"] else []),
        f"  {noise}; {entry['order_conflicts']} order conflicts → {entry['file']}",
    ]


def _noise_line(noise: dict[str, Any]) -> str:
    source = "by its images" if noise["from_images"] else "given or assumed"
    return (
        f"  noise {source}: full well {noise['full_well_e']:.0f} e, read noise {noise['read_noise_e']:.1f} e; "
        f"phases scatter {noise['scatter']:.2f} times as predicted from it, and the stated σ where that is more"
    )
