"""Fractions of valid pixels of the exposures, as means over the viewpoints of a measurement."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.data.measurement import Measurement
from measureapp.report.model import Fact
from measureapp.report.words import number, percent

NOTE = (
    "Valid: above zero and unsaturated in all images of the exposure; composite: of the longest exposure in which the pixel is unsaturated; "
    "decoded: with a phase. Means over the viewpoints."
)


@dataclass(frozen=True, slots=True)
class ValidPixels:
    """Ratios of one camera, over the viewpoints that were taken with the same exposures; of all pixels of its images."""

    camera: str
    exposures_us: tuple[int, ...]  # long to short; empty where they are not stored
    exposures: tuple[float, ...]  # mean over the viewpoints, long to short
    composite: float
    decoded: float
    least_decoded: float
    least_viewpoint: str


def valid_pixels(measurement: Measurement, exposures_us: Mapping[str, tuple[int, ...]]) -> tuple[ValidPixels, ...]:
    """Summarise the stored decoding figures by camera and exposures; ``exposures_us`` by viewpoint, of the stored images."""
    groups: dict[tuple[str, tuple[int, ...], int], list[tuple[str, Mapping[str, Any]]]] = {}
    for view in measurement.views:
        for camera, figures in view.decode.items():
            if "valid_ratio" in figures:  # measurements of early versions have none
                count = len(figures["valid_ratio"]["exposures"])
                times = exposures_us.get(view.viewpoint_id, ())
                known = times if len(times) == count else ()
                groups.setdefault((camera, known, count), []).append((view.viewpoint_id, figures))
    return tuple(_summary(camera, times, members) for (camera, times, _), members in groups.items())


def _summary(camera: str, times: tuple[int, ...], members: Sequence[tuple[str, Mapping[str, Any]]]) -> ValidPixels:
    single = np.mean([figures["valid_ratio"]["exposures"] for _, figures in members], axis=0)
    decoded = [float(figures["decoded_ratio"]) for _, figures in members]
    least = int(np.argmin(decoded))
    return ValidPixels(
        camera,
        times,
        tuple(float(ratio) for ratio in single),
        float(np.mean([figures["valid_ratio"]["composite"] for _, figures in members])),
        float(np.mean(decoded)),
        decoded[least],
        members[least][0],
    )


def valid_pixel_facts(found: Sequence[ValidPixels]) -> tuple[Fact, ...]:
    """Return a line for every camera, and what the words mean."""
    return (*(Fact(one.camera, _words(one)) for one in found), Fact("Note", NOTE)) if found else ()


def _words(one: ValidPixels) -> str:
    names = [f"{number(time / 1000, 1)} ms" for time in one.exposures_us] or [
        f"exposure {place + 1}" for place in range(len(one.exposures))
    ]
    single = " · ".join(f"{name} {percent(ratio)}" for name, ratio in zip(names, one.exposures, strict=True))
    return f"{single}; composite {percent(one.composite)}; decoded {percent(one.decoded)} (least {percent(one.least_decoded)}, {one.least_viewpoint})"
