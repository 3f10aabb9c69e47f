"""Fractions of valid pixels of every exposure and of their composite, by both rules of selection."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.data.fringe import FringeStack
from measureapp.data.phase import PhaseMap
from measureapp.errors import InputError, MeasureError
from measureapp.fringe.checks.stack import check_stack
from measureapp.fringe.decode import decode
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.measure import require_stored
from measureapp.pipeline.noise import decode_settings_of
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.project.folder import ProjectFolder

RULES = ("combined", "paper")  # values of `DecodeSettings.rule`


@dataclass(frozen=True, slots=True)
class RuleResult:
    """What one rule of selection makes of the exposures; ratios are of all pixels of the image."""

    composite_ratio: float  # above zero in all images of the longest exposure in which the pixel is unsaturated
    decoded_ratio: float  # with an absolute phase
    sigma_rad: float | None  # median standard deviation of that phase; None where no pixel has one


@dataclass(frozen=True, slots=True)
class CameraExposures:
    """The exposures of one camera at one viewpoint."""

    exposures_us: tuple[int, ...]  # long to short
    valid_ratios: tuple[float, ...]  # of every exposure: pixels above zero and unsaturated in all its images
    rules: Mapping[str, RuleResult]  # by the names in `RULES`


@dataclass(frozen=True, slots=True)
class ProjectExposures:
    """The exposures of viewpoints, by viewpoint and camera; and why some have none."""

    viewpoints: Mapping[str, Mapping[str, CameraExposures]]
    failed: Mapping[str, str]


def project_exposures(project: ProjectFolder, viewpoints: Sequence[str] = (), progress: Progress | None = None) -> ProjectExposures:
    """Decode stored viewpoints by both rules, and count their valid pixels; the project is not changed.

    Parameters
    ----------
    viewpoints : ids of those to count; empty: all that are stored

    Raises
    ------
    InputError
        No images are stored, or not of a viewpoint that is named.
    MeasureError
        That of the first viewpoint, when none can be decoded.
    """
    stored = require_stored(project)
    unknown = [name for name in viewpoints if name not in stored]
    if unknown:
        raise InputError(f"{project.path} contains no images of viewpoint {unknown[0]!r}.", f"Stored are: {', '.join(stored)}.")
    wanted, settings = tuple(dict.fromkeys(viewpoints)) or stored, decode_settings_of(project)
    progress = progress or NoProgress()
    found, failed = dict[str, Mapping[str, CameraExposures]](), dict[str, MeasureError]()
    for index, name in enumerate(wanted):
        part = PartOf(progress, index / len(wanted), (index + 1) / len(wanted), f"{name}: ")
        try:
            stack = project.frames.load(name)
            found[name] = ratios_of(stack, decode_by_rules(stack, settings, part))
        except MeasureError as error:
            failed[name] = error
    if not found:
        raise next(iter(failed.values()))
    return ProjectExposures(found, {name: str(error) for name, error in failed.items()})


def decode_by_rules(stack: FringeStack, settings: DecodeSettings, progress: Progress) -> dict[str, dict[str, PhaseMap]]:
    """Decode one stack by both rules of selection; return phase maps by rule and camera. Raises DecodeError."""
    check_stack(stack)
    return {
        rule: decode(stack, settings.model_copy(update={"rule": rule}), PartOf(progress, index / len(RULES), (index + 1) / len(RULES)))
        for index, rule in enumerate(RULES)
    }


def ratios_of(stack: FringeStack, maps: Mapping[str, Mapping[str, PhaseMap]]) -> dict[str, CameraExposures]:
    """Return the valid pixels of a stack that was decoded by both rules, by camera."""
    return {
        camera: CameraExposures(
            exposures_us=tuple(stack.exposures_us),
            valid_ratios=combined.valid_ratio_exposures,
            rules={rule: _result(maps[rule][camera]) for rule in RULES},
        )
        for camera, combined in maps["combined"].items()  # whose ratios are counted, where the paper's rule estimates some
    }


def _result(phase_map: PhaseMap) -> RuleResult:
    valid = phase_map.valid
    sigma = float(np.median(phase_map.sigma_rad[valid])) if valid.any() else None
    return RuleResult(phase_map.valid_ratio_composite, float(valid.mean()), sigma)
