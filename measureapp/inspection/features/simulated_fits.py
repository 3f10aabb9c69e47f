"""Monte Carlo uncertainty (JCGM 101) of round features of small segments, where the law of propagation is not sufficient.

A small arc determines a curvature: its normal errors are asymmetric in the radius, and correlated with the axis. For a short cone the
tilt of the axis, the angle and the radius are strongly correlated.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.geometry.contours import is_contour
from measureapp.geometry.fits import LARGEST_RATIO, LEAST_POINTS, Scaled, state_of
from measureapp.geometry.shapes import MODELS, Model, State
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.features.shapes import outward_normals, signed_distances
from measureapp.inspection.settings import InspectionSettings

NONLINEAR = 0.1  # relative standard deviation of a radius above which it is simulated
TILTED_RAD = 0.04  # standard deviation of a direction above which it is simulated
SIMULATED_POINTS = 200
FAILING = 0.05  # greatest share of failed draws of a determined shape
STEPS, SETTLED = 30, 1e-5  # of the Gauss-Newton iteration, relative to the size of the points
COVERAGE = 0.95
SEED = 15


def needs_simulation(found: FoundFeature) -> bool:
    """Return whether the linear uncertainty of a round feature is insufficient.

    For a curvature with relative standard deviation u, the interval ± 2 σ at the fitted radius contains the true one in 95.4 % of cases at
    u = 3 %, 95.3 % at 10 %, 93.7 % at 20 % and 92.0 % at 30 %, and misses it on one side only. A tilt θ of the axis has an effect of
    second order in θ: for segments of cones with directions known to 0.03, 0.06 and 0.12 rad, the interval of the radius contains the
    true one in 95, 90 and 84 % of cases.
    """
    feature = found.feature
    if feature is None or feature.radius_mm is None or len(found.points_mm) == 0 or is_contour(feature):
        return False
    return found.radius_sigma > NONLINEAR * feature.radius_mm or found.direction_sigma > TILTED_RAD


def simulate_uncertainties(found: Mapping[str, FoundFeature], settings: InspectionSettings) -> dict[str, FoundFeature]:
    """Return the features, those of small segments with Monte Carlo instead of linear uncertainties."""
    return {name: _simulate(one, settings.radius_trials) if needs_simulation(one) else one for name, one in found.items()}


def _simulate(found: FoundFeature, draws: int) -> FoundFeature:
    """Replace the covariance by the spread of fits to simulated points (JCGM 101); a feature with too large a spread is not found.

    At most 200 of its points are used, with the noise reduced accordingly. The covariance keeps its principal directions; along each, two
    standard deviations are the 95 % quantile of the draws.
    """
    feature = found.feature
    assert feature is not None and feature.covariance is not None
    off = _offsets(found, feature, draws)
    reach = float(np.quantile(np.abs(off[:, 6]), COVERAGE)) if len(off) >= (1 - FAILING) * draws else np.inf
    if reach > (feature.radius_mm or 0.0):
        what = "a radius" if feature.direction is None else "a radius and an axis"
        return replace(found, feature=None, reason=f"{found.name}: its points cover too small a segment to determine {what} at their noise")
    directions = np.linalg.eigh(feature.covariance)[1]
    sigmas = np.quantile(np.abs(off @ directions), COVERAGE, axis=0) / 2 / found.correlation_factor
    covariance = (directions * sigmas**2) @ directions.T
    known = {
        "position_mm": _largest(covariance[:3, :3]),
        "direction_rad": _largest(covariance[3:6, 3:6]),
        "radius_mm": reach / 2 / found.correlation_factor,
    }
    if feature.half_angle_rad is not None:
        known["half_angle_rad"] = float(np.quantile(np.abs(off[:, 7]), COVERAGE)) / 2 / found.correlation_factor
    deviations = {name: known.get(name, value) for name, value in feature.standard_deviations.items()}
    return replace(found, feature=replace(feature, covariance=covariance, standard_deviations=deviations), draws=draws)


def _offsets(found: FoundFeature, feature: Feature, draws: int) -> FloatArray:
    """Return the errors (D, 6 + S) of point, direction and sizes of the simulated fits; fewer than ``draws`` if fits fail."""
    points = found.points_mm[:: -(-len(found.points_mm) // SIMULATED_POINTS)]
    normals = outward_normals(feature, points)
    feet = points - signed_distances(feature, points)[:, None] * normals
    freedoms = max(len(found.points_mm) - LEAST_POINTS[feature.shape], 1)
    noise = (
        feature.rms_mm * np.sqrt(len(found.points_mm) / freedoms) * found.correlation_factor * np.sqrt(len(points) / len(found.points_mm))
    )
    rng, scaled = np.random.default_rng(SEED), Scaled.of(feet)
    model, start = MODELS[feature.shape], state_of(feature, scaled)
    across = normals * (noise / scaled.scale_mm)
    true = _parameters(feature, start, scaled)
    made = [_fit_by_gauss_newton(model, start, scaled.points + rng.standard_normal((len(feet), 1)) * across) for _ in range(draws)]
    return np.array([_parameters(feature, one, scaled) - true for one in made if one is not None]).reshape(-1, len(true))


def _fit_by_gauss_newton(model: Model, state: State, points: FloatArray) -> State | None:
    """Return the least-squares state by Gauss-Newton iteration from the true one; None without convergence."""
    for _ in range(STEPS):
        distances, derivatives = model.evaluate(state, points)
        step = -np.linalg.lstsq(derivatives[0], distances[0], rcond=None)[0]
        if not np.isfinite(step).all() or np.abs(step[: model.moves]).max() > LARGEST_RATIO:
            return None
        state = model.move(state, step)
        if np.abs(step).max() < SETTLED:
            return state
    return None


def _parameters(feature: Feature, state: State, scaled: Scaled) -> FloatArray:
    """Return point (mm), direction and sizes (6 + S,) of a state, the point at the axial position of the feature's own."""
    if feature.direction is None:
        return np.concatenate([state.point * scaled.scale_mm, np.zeros(3), np.abs(state.sizes) * scaled.scale_mm])
    begin = (feature.point_mm - scaled.centre_mm) / scaled.scale_mm
    down = float((begin - state.point) @ feature.direction) / float(state.direction @ feature.direction)
    point, sizes = state.point + down * state.direction, np.abs(state.sizes) * scaled.scale_mm
    if feature.shape == "cone":
        angle = float(state.sizes[1])
        sizes = np.array([scaled.scale_mm * abs(state.sizes[0] / np.cos(angle) - down * np.tan(angle)), angle])
    return np.concatenate([point * scaled.scale_mm, state.direction, sizes])


def _largest(covariance: FloatArray) -> float:
    return float(np.sqrt(max(np.linalg.eigvalsh(covariance)[-1], 0.0)))
