"""Explanation of holes: stage and reason, for a pixel, a region and all images of a viewpoint."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.reconstruct.projector.state import ProjectorState
from measureapp.reconstruct.reconstruct import Reconstruction
from measureapp.reconstruct.settings import ReconstructSettings

POINT = "point"
OF_PHASE = {
    PixelState.SATURATED: "Saturated in every exposure: {grey:.0f} of {saturation:.0f} grey levels. Add a shorter exposure.",
    PixelState.WEAK_MODULATION: "Too little of the light follows the pattern: modulation {modulation:.1f} at {grey:.0f} grey levels. "
    "Add a longer exposure, shade ambient light, or dull a shiny surface.",
    PixelState.SHADOW: "Not reached by the projector's light: modulation {modulation:.1f} grey levels. Turn the part or add a viewpoint.",
    PixelState.ORDER_CONFLICT: "The fringe orders of the pitches contradict each other, at modulation {modulation:.1f} grey levels. "
    "Use patterns with more pitches, or a longer exposure.",
    PixelState.OUT_OF_RANGE: "The phase lies outside the projector's image: light arrives by a reflection, or the order is wrong.",
    PixelState.EDGE: "At a depth discontinuity, where the pixel covers two surfaces at once. Another viewpoint sees them apart.",
    PixelState.BLOOMING: "Beside a saturated pixel that spills over. Add a shorter exposure.",
}
OF_POINT = {
    PointState.UNMATCHED: "No other camera has the {lit} on the epipolar line: it is occluded from them, or outside their images. "
    "Add a viewpoint.",
    PointState.AMBIGUOUS: "The {lit} occurs at several places of an epipolar line, or hardly changes along it: a wrong fringe order, or "
    "fringes along the line.",
    PointState.CONTRADICTED: "Another camera sees a projector line there that differs from {lit} by more than {sigmas:g} standard "
    "deviations plus {px:g} px: reflections, or a camera that moved. Check the epipolar residual of the viewpoint.",
    PointState.UNCERTAIN: "The predicted standard deviation exceeds {max_sigma:.2g} mm: phase noise {sigma:.4f} rad. Add a longer exposure.",
    PointState.FLYING: "Fewer than {neighbours} of 24 places around it lie on the same surface: it is at a depth discontinuity or isolated.",
    PointState.OUTLIER: "Further from the plane through its neighbours than {outlier:g} standard deviations.",
    PointState.GRAZING: "Grazing incidence: the camera sees the surface more than {incidence:g}° off its normal. Turn the part towards the sensor.",
    PointState.PARTNER_GRAZING: "Grazing incidence on another camera of the point: more than {partner:g}° off the normal.",
    PointState.ISLAND: "Isolated patch: its connected component has fewer than {min_pixels} pixels.",
    PointState.SEEN_BY_ANOTHER: "Measured by an earlier camera already: the point is in that camera's image.",
    PointState.RIM: "At a depth discontinuity, where blur mixes in the light from beyond the border of its surface. Add a viewpoint from which it is not at a border.",
    PointState.VALID: "It has a point.",
}

OF_POINT_WITH_PROJECTOR = OF_POINT | {
    PointState.UNMATCHED: "The viewing ray does not meet the {lit} in front of the camera and inside the projector's image: a wrong fringe order, "
    "light from a reflection, or the calibration of another projector.",
    PointState.AMBIGUOUS: "The viewing ray is nearly parallel to the surface that the {lit} illuminates, so that the depth is undetermined. Move the projector "
    "or the camera apart, or add fringes of the other direction.",
    PointState.CONTRADICTED: "The {lit} belong to no point of the viewing ray, by more than {sigmas:g} standard deviations plus {px:g} px: "
    "reflections, or a projector or camera that moved.",
    PointState.UNCERTAIN: "The predicted standard deviation exceeds {max_sigma:.2g} mm and three times the median of the view: phase noise "
    "{sigma:.4f} rad. Add a longer exposure.",
    PointState.PARTNER_GRAZING: "The projector illuminates the surface more than {partner:g}° off its normal.",
}
OF_POINT_OF_NOBODY = OF_POINT | {
    PointState.UNMATCHED: "Only one camera sees the {lit}, which gives no depth. Add a second camera, or calibrate the projector.",
}


@dataclass(frozen=True, slots=True)
class HoleReason:
    """Stage and reason that decided about a pixel."""

    stage: str  # "decode", "match", "clean", or "point"
    reason: str  # in lower case, as in the shares
    sentence: str  # with the numbers that decided, and what to do about it


def why(
    phase_maps: Mapping[str, PhaseMap],
    made: Reconstruction,
    camera: str,
    row: int,
    column: int,
    settings: ReconstructSettings | None = None,
) -> HoleReason:
    """Explain why a pixel has no point.

    Parameters
    ----------
    settings : that the reconstruction was made with; None for the defaults

    Raises
    ------
    ReconstructError
        The view has no such camera or pixel.
    """
    states, phase_map = _images(phase_maps, made, camera)
    height, width = states.shape
    if not (0 <= row < height and 0 <= column < width):
        raise ReconstructError(
            f"Camera {camera!r} has no pixel in row {row}, column {column}.", f"Its images have {height} rows and {width} columns."
        )
    values = _values(phase_map, settings or ReconstructSettings(), row, column) | {"max_sigma": made.max_sigma_mm.get(camera, np.inf)}
    point = PointState(int(states[row, column]))
    if point == PointState.NO_PHASE:
        state = PixelState(int(phase_map.state[row, column]))
        return HoleReason("decode", _word(state), OF_PHASE[state].format(**values))
    sentence = _sentences(made)[point].format(lit=lit_by(phase_map, row, column), **values)
    return HoleReason(_stage(point), _word(point), sentence + _aside(phase_map, made, point, row, column))


def lit_by(phase_map: PhaseMap, row: int, column: int) -> str:
    """Return which line of the projector illuminates a pixel, in words: its column, its row, or both."""
    seen = [each for each in (phase_map, phase_map.orthogonal) if each is not None and each.state[row, column] == PixelState.VALID]
    return "projector " + " and ".join(f"{line_of(each)} {each.column_at(row, column):.2f}" for each in seen)


def line_of(phase_map: PhaseMap) -> str:
    """Return what the fringes of a map number: columns or rows."""
    return "column" if phase_map.direction == "vertical" else "row"


def _sentences(made: Reconstruction) -> dict[PointState, str]:
    """Return the sentences for what a camera was reconstructed with: others, the projector, or nothing."""
    if len(made.states) > 1:
        return OF_POINT
    return OF_POINT_WITH_PROJECTOR if any(state.words in made.rejected for state in ProjectorState) else OF_POINT_OF_NOBODY


def _aside(phase_map: PhaseMap, made: Reconstruction, point: PointState, row: int, column: int) -> str:
    """Return further causes for a pixel with a phase: pairs that were not matched, and orthogonal fringes without a phase."""
    text = ""
    if point == PointState.UNMATCHED:
        skipped = [pair for pair in made.pairs if pair.skipped and phase_map.camera in pair.names]
        text += "".join(f" {' and '.join(pair.names)} were not matched: {pair.skipped}." for pair in skipped)
    orthogonal = phase_map.orthogonal
    if orthogonal is not None and orthogonal.state[row, column] != PixelState.VALID:
        text += f" The orthogonal fringes give no {line_of(orthogonal)} there: {_word(PixelState(int(orthogonal.state[row, column])))}."
    return text


def shares_of_region(
    phase_maps: Mapping[str, PhaseMap], made: Reconstruction, camera: str, region: BoolArray | tuple[int, int, int, int]
) -> dict[str, float]:
    """Return the share of every reason in a region of a camera's image, the largest first; they sum to 1. "point" are no holes.

    Parameters
    ----------
    region : (H, W) bool, or (row, column, row, column) of a box, its end not included

    Raises
    ------
    ReconstructError
        No such camera, or a region without pixels.
    """
    states, phase_map = _images(phase_maps, made, camera)
    if isinstance(region, tuple):
        top, left, bottom, right = region
        chosen = np.zeros(states.shape, np.bool_)
        chosen[max(0, top) : max(0, bottom), max(0, left) : max(0, right)] = True
    else:
        chosen = region
    if chosen.shape != states.shape or not chosen.any():
        raise ReconstructError(
            f"The region has no pixel of camera {camera!r}.", f"Its images have {states.shape[0]} rows and {states.shape[1]} columns."
        )
    points = np.bincount(states[chosen], minlength=len(PointState))
    without = chosen & (states == PointState.NO_PHASE)
    phases = np.bincount(phase_map.state[without], minlength=len(PixelState))
    counts = {_word(state): int(points[state]) for state in PointState if state != PointState.NO_PHASE}
    counts |= {_word(state): int(phases[state]) for state in PixelState if state != PixelState.VALID}
    total = int(chosen.sum())
    return {reason: count / total for reason, count in sorted(counts.items(), key=lambda item: -item[1]) if count}


def shares_of_view(phase_maps: Mapping[str, PhaseMap], made: Reconstruction) -> dict[str, dict[str, float]]:
    """Return the shares of all reasons for every camera of a view."""
    return {camera: shares_of_region(phase_maps, made, camera, np.ones(states.shape, np.bool_)) for camera, states in made.states.items()}


def _images(phase_maps: Mapping[str, PhaseMap], made: Reconstruction, camera: str) -> tuple[np.ndarray, PhaseMap]:
    if camera not in made.states or camera not in phase_maps:
        raise ReconstructError(f"The view has no camera {camera!r}.", "Name one of: " + ", ".join(made.states) + ".")
    return np.asarray(made.states[camera]), phase_maps[camera]


def _values(phase_map: PhaseMap, settings: ReconstructSettings, row: int, column: int) -> dict[str, float]:
    return {
        "grey": float(phase_map.grey[row, column]),
        "saturation": phase_map.saturation,
        "modulation": float(phase_map.modulation[row, column]),
        "sigma": float(phase_map.sigma_rad[row, column]),
        "sigmas": settings.agreement_sigmas,
        "px": settings.agreement_px,
        "neighbours": settings.min_neighbours,
        "outlier": settings.outlier_sigmas,
        "incidence": settings.max_incidence_deg,
        "partner": settings.max_partner_incidence_deg,
        "min_pixels": settings.min_island_px,
    }


def _stage(point: PointState) -> str:
    if point == PointState.VALID:
        return POINT
    return (
        "match" if point in (PointState.UNMATCHED, PointState.AMBIGUOUS, PointState.CONTRADICTED, PointState.SEEN_BY_ANOTHER) else "clean"
    )


def _word(state: PointState | PixelState) -> str:
    return POINT if state is PointState.VALID else state.name.lower().replace("_", " ")
