"""Orthogonal distance regression of line, plane, circle, sphere, cylinder, cone and torus."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.errors import FitError
from measureapp.geometry.feature import Feature, Shape
from measureapp.geometry.fit_starts import SAMPLE, find_starts
from measureapp.geometry.shapes import MODELS, Model, State

LEAST_POINTS: dict[Shape, int] = {"line": 2, "plane": 3, "circle": 3, "sphere": 4, "cylinder": 5, "cone": 6, "torus": 7}
ITERATIONS = 200
START_ITERATIONS = 40  # tell which of the starts is best; those of another shape than the points have would creep on for ever
CONVERGED = 1e-13  # step, relative to the size of the data
SHRINKING = 0.95  # greatest ratio of the lengths of successive final steps
ROUNDING = 1e-12  # of sums of squares, relative
PROBE = 1e-6  # step of a parameter for numerical derivatives
SINGULAR = 1e-9  # ratio of singular values below which the points do not determine the shape
MAD_TO_SIGMA = 1.4826
REJECTED_SIGMAS = 3.5
ROBUST_ROUNDS = 20
FAR_OFF = 0.1  # rms distance, relative to the size of the data, beyond which the points are not of the requested shape
LARGEST_RATIO = 1e4  # a radius larger than this times the size of the data is a plane


@dataclass(frozen=True, slots=True, eq=False)
class Scaled:
    """The points of a fit, centred and scaled to about 1 for numerical conditioning."""

    points: FloatArray
    centre_mm: FloatArray
    scale_mm: float

    @classmethod
    def of(cls, points_mm: FloatArray) -> Scaled:
        """Centre on the mean and scale by the rms distance from the mean."""
        centre = points_mm.mean(axis=0)
        offset = points_mm - centre
        centre, offset = centre + offset.mean(axis=0), offset - offset.mean(axis=0)
        scale = float(np.sqrt(np.mean(np.sum(offset**2, axis=1))))
        return cls(offset / max(scale, 1e-300), centre, scale)


def fit(
    shape: Shape, points_mm: FloatArray, *, weights: FloatArray | None = None, start: Feature | None = None, robust: bool = False
) -> Feature:
    """Fit ``shape`` to points by orthogonal least squares [1]_.

    Parameters
    ----------
    shape : "line", "plane", "circle", "sphere", "cylinder", "cone" or "torus"
    points_mm : (N, 3), in any order
    weights : (N,), inverse variances up to a common factor; None: all equal
    start : an approximate feature of the same shape; None: estimated from the points
    robust : reject outliers beyond 3.5 robust standard deviations; their number is ``left_out``

    Returns
    -------
    Feature
        With ``point_mm`` nearest the centroid of the points used. The standard deviations of point and axis are those in
        their least certain direction, scaled by the residual scatter; ``covariance`` is complete. A cone's direction points
        to its apex. ``form_error_mm`` is the range of signed distances: for a line the diameter of the enclosing cylinder,
        for a circle the radial range.

    Raises
    ------
    FitError
        Too few points, or points that do not determine the shape.

    References
    ----------
    .. [1] A. B. Forbes, Least-squares best-fit geometric elements, NPL report DITC 140/89, 1989.
    """
    points, weight = _check_points(shape, points_mm, weights)
    scaled = Scaled.of(points)
    begin = find_starts(shape, scaled.points) if start is None else [state_of(start, scaled)]
    keep = np.ones(len(points), np.bool_)
    if robust:
        state, keep = _robust(shape, scaled.points, weight, begin)
    else:
        state = _best(shape, scaled.points, weight, begin)
    return to_feature(shape, state, scaled, weight, keep)


def distances_mm(feature: Feature, points_mm: FloatArray) -> FloatArray:
    """Return the signed orthogonal distances (N,) of points from a feature; those from a line, point or circle are not negative."""
    if feature.shape == "point":
        return np.linalg.norm(points_mm - feature.point_mm, axis=1)
    scaled = Scaled(np.asarray(points_mm, float) - feature.point_mm, feature.point_mm, 1.0)
    distances, _ = MODELS[feature.shape].evaluate(state_of(feature, scaled), scaled.points)
    return distances[0] if len(distances) == 1 else np.hypot(*distances)


def point_sensitivities(feature: Feature, points_mm: FloatArray, weights: FloatArray | None = None) -> FloatArray:
    """Sensitivity of a fitted feature to its points: Jacobian (6 + S, N) of point (mm), direction and sizes, ordered as ``covariance``.

    Column n belongs to a displacement of point n along the normal of the shape, towards positive distances. From the normal
    equations, dθ = -(Jᵀ W J)⁻¹ Jᵀ W dd.

    Parameters
    ----------
    feature : result of `fit`, of a shape with one distance per point
    weights : (N,), as they were in the fit; None: all equal
    """
    model, scaled = MODELS[feature.shape], Scaled.of(points_mm)
    state = state_of(feature, scaled)
    _, derivatives = model.evaluate(state, scaled.points)
    root = np.sqrt(np.ones(len(points_mm)) if weights is None else weights)
    follows = -np.linalg.pinv(derivatives[0] * root[:, None]) * root / scaled.scale_mm
    return np.asarray(_spread(feature.shape, model, state, scaled.scale_mm) @ follows)


def _check_points(shape: Shape, points_mm: FloatArray, weights: FloatArray | None) -> tuple[FloatArray, FloatArray]:
    if shape not in MODELS:
        raise FitError(f"A {shape} cannot be fitted.", "Use one of: " + ", ".join(MODELS) + ".")
    points = np.asarray(points_mm, np.float64)
    if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
        raise FitError("Points for a fit must be rows of three finite numbers.", "Remove lines that are not points.")
    if len(points) < LEAST_POINTS[shape]:
        raise FitError(f"A {shape} needs at least {LEAST_POINTS[shape]} points; there are {len(points)}.", "Give more points.")
    weight = np.ones(len(points)) if weights is None else np.asarray(weights, np.float64)
    if weight.shape != (len(points),) or not np.isfinite(weight).all() or (weight < 0).any() or weight.max() <= 0:
        raise FitError("The weights of a fit must be positive, one per point.", "Give one weight per point.")
    return points, weight / weight.max()


def state_of(feature: Feature, scaled: Scaled) -> State:
    """Return a feature as a state in scaled coordinates."""
    point = (feature.point_mm - scaled.centre_mm) / scaled.scale_mm
    direction = np.array([0.0, 0.0, 1.0]) if feature.direction is None else np.asarray(feature.direction)
    radius = (feature.radius_mm or 0.0) / scaled.scale_mm
    if feature.shape == "cone":
        angle = feature.half_angle_rad or 0.0
        return State(point, direction, np.array([radius * np.cos(angle), angle]))
    if feature.shape == "torus":
        return State(point, direction, np.array([radius, (feature.minor_radius_mm or 0.0) / scaled.scale_mm]))
    return State(point, direction, np.array([radius] if feature.radius_mm is not None else []))


def _best(shape: Shape, points: FloatArray, weight: FloatArray, begin: list[State]) -> State:
    """Refine every start on a sample of the points until it is told which is best, and that one on all points."""
    model = MODELS[shape]
    if len(begin) == 1 and len(points) <= SAMPLE:
        return refine(model, begin[0], points, weight)
    chosen = slice(None) if len(points) <= SAMPLE else np.random.default_rng(0).choice(len(points), SAMPLE, replace=False)
    few, few_weights = points[chosen], weight[chosen]
    solved = [refine(model, state, few, few_weights, START_ITERATIONS) for state in begin]
    costs = [_cost(model.evaluate(state, few)[0], few_weights) for state in solved]
    return refine(model, solved[int(np.argmin(costs))], points, weight)


def _cost(distances: FloatArray, weight: FloatArray) -> float:
    cost = float(np.sum(weight * distances**2))
    return cost if np.isfinite(cost) else np.inf


def refine(model: Model, state: State, points: FloatArray, weight: FloatArray, iterations: int = ITERATIONS) -> State:
    """Minimise the weighted sum of squares, starting at ``state`` (Levenberg-Marquardt by QR, then Gauss-Newton)."""
    damping = 1e-6
    here = model.evaluate(state, points)
    cost = _cost(here[0], weight)
    for _ in range(iterations):
        step = _step(model, here, weight, damping)
        trial = model.move(state, step)
        there = model.evaluate(trial, points)
        trial_cost = _cost(there[0], weight)
        small = float(np.linalg.norm(step)) < CONVERGED * (1 + float(np.linalg.norm(state.sizes)))
        if trial_cost <= cost:
            state, here, cost, damping = trial, there, trial_cost, max(damping * 0.05, 1e-30)
        else:
            damping = min(damping * 10, 1e12)
        if small or (trial_cost > cost and damping >= 1e12):
            break
    return _polish(model, state, here, points, weight, iterations)


def _polish(
    model: Model, state: State, here: tuple[FloatArray, FloatArray], points: FloatArray, weight: FloatArray, iterations: int
) -> State:
    """Take full Gauss-Newton steps as long as they shrink, from ``state`` with its distances and derivatives.

    The sum of squares cannot resolve differences below √ε of the scatter; the length of the steps can.
    """
    shortest, cost = np.inf, _cost(here[0], weight)
    for _ in range(iterations):
        step = _step(model, here, weight, 0.0)
        length = float(np.linalg.norm(step))
        if not length < SHRINKING * shortest:
            break
        trial = model.move(state, step)
        here = model.evaluate(trial, points)
        if _cost(here[0], weight) > cost * (1 + ROUNDING) + ROUNDING**2:
            break
        state, shortest = trial, length
    return state


def _step(model: Model, here: tuple[FloatArray, FloatArray], weight: FloatArray, damping: float) -> FloatArray:
    distances, derivatives = here
    root = np.sqrt(weight)
    jacobian = (derivatives * root[None, :, None]).reshape(-1, model.parameters)
    q, r = np.linalg.qr(jacobian)
    size = np.maximum(np.linalg.norm(r, axis=0), 1e-30)
    stacked = np.vstack([r, np.diag(np.sqrt(damping) * size)])
    right = np.concatenate([q.T @ (distances * root).ravel(), np.zeros(model.parameters)])
    return np.asarray(-np.linalg.lstsq(stacked, right, rcond=None)[0])


def _robust(shape: Shape, points: FloatArray, weight: FloatArray, begin: list[State]) -> tuple[State, BoolArray]:
    """Robust fit: iteratively reweighted with Cauchy weights, then rejection of outliers until the set no longer changes."""
    model = MODELS[shape]
    state = _best(shape, points, weight, begin)
    for _ in range(ROBUST_ROUNDS):
        far = _length(model, state, points)
        sigma = max(MAD_TO_SIGMA * float(np.median(far)), 1e-9)
        state = refine(model, state, points, weight / (1 + (far / (2 * sigma)) ** 2))
    keep = np.ones(len(points), np.bool_)
    for _ in range(ROBUST_ROUNDS):
        far = _length(model, state, points)
        sigma = max(MAD_TO_SIGMA * float(np.median(far[keep])), 1e-9)
        found = far <= REJECTED_SIGMAS * sigma
        if np.count_nonzero(found) < LEAST_POINTS[shape] or np.array_equal(found, keep):
            break
        keep = found
        state = refine(model, state, points[keep], weight[keep])
    return state, keep


def _length(model: Model, state: State, points: FloatArray) -> FloatArray:
    distances, _ = model.evaluate(state, points)
    return np.sqrt(np.sum(distances**2, axis=0))


def to_feature(shape: Shape, state: State, scaled: Scaled, weight: FloatArray, keep: BoolArray) -> Feature:
    """Convert a state to a feature in millimetres, its point nearest the centroid; raises FitError when it is not determined."""
    model = MODELS[shape]
    points = scaled.points[keep]
    state = _normalise(shape, state, points.mean(axis=0))
    distances, derivatives = model.evaluate(state, points)
    _refuse_undetermined(shape, model, distances, derivatives, weight[keep], state)
    covariance = _covariance(model, distances, derivatives, weight[keep])
    spread = _spread(shape, model, state, scaled.scale_mm)
    form = model.form(distances) * scaled.scale_mm
    sizes = state.sizes * scaled.scale_mm
    return Feature(
        name=shape,
        shape=shape,
        point_mm=state.point * scaled.scale_mm + scaled.centre_mm,
        direction=None if shape == "sphere" else state.direction,
        radius_mm=_radius(shape, state, scaled.scale_mm),
        half_angle_rad=float(state.sizes[1]) if shape == "cone" else None,
        minor_radius_mm=float(sizes[1]) if shape == "torus" else None,
        points=int(np.count_nonzero(keep)),
        left_out=int(np.count_nonzero(~keep)),
        rms_mm=float(np.sqrt(np.mean(np.sum(distances**2, axis=0)))) * scaled.scale_mm,
        form_error_mm=float(form.max() - form.min()),
        standard_deviations=_deviations(shape, model, covariance, state, scaled.scale_mm),
        covariance=spread @ covariance @ spread.T,
        boundary_mm=np.stack([points.min(axis=0), points.max(axis=0)]) * scaled.scale_mm + scaled.centre_mm,
    )


def _radius(shape: Shape, state: State, scale_mm: float) -> float | None:
    if shape == "cone":
        return float(state.sizes[0] / np.cos(state.sizes[1])) * scale_mm
    return float(state.sizes[0]) * scale_mm if len(state.sizes) else None


def _normalise(shape: Shape, state: State, centroid: FloatArray) -> State:
    """Normalise a state: point nearest the centroid, positive sizes, and a unique sign of the direction."""
    direction, point, sizes = state.direction, state.point, state.sizes.copy()
    if shape in ("line", "cylinder", "cone"):
        shift = float((centroid - point) @ direction)
        point = point + shift * direction
        if shape == "cone":
            sizes[0] -= shift * np.sin(sizes[1])
            if sizes[1] < 0:
                direction, sizes[1] = -direction, -sizes[1]
    elif shape == "plane":
        point = centroid - float((centroid - point) @ direction) * direction
    if shape in ("sphere", "circle", "cylinder", "torus"):
        sizes = np.abs(sizes)
    if shape != "cone" and direction[np.argmax(np.abs(direction))] < 0:
        direction = -direction
    return State(point, direction, sizes)


def _refuse_undetermined(
    shape: Shape, model: Model, distances: FloatArray, derivatives: FloatArray, weight: FloatArray, state: State
) -> None:
    """Raise FitError when the Jacobian is rank deficient, or the points are not of this shape."""
    jacobian = (derivatives * np.sqrt(weight)[None, :, None]).reshape(-1, model.parameters)
    singular = np.linalg.svd(jacobian, compute_uv=False) if np.isfinite(jacobian).all() else np.zeros(model.parameters)
    if singular[-1] <= SINGULAR * singular[0] or np.any(np.abs(state.sizes) > LARGEST_RATIO):
        raise FitError(f"The points do not determine a {shape}.", f"Give points spread over more of the {shape}.")
    if shape == "cone" and not 0 < state.sizes[1] < np.pi / 2:
        raise FitError("The points do not determine a cone.", "Give points spread over more of the cone, or fit a cylinder.")
    if shape in ("cylinder", "cone", "torus") and np.sqrt(np.mean(distances**2)) > FAR_OFF:
        raise FitError(f"The points are not on a {shape}.", "Select the points of one surface only, or give a start.")


def _covariance(model: Model, distances: FloatArray, derivatives: FloatArray, weight: FloatArray) -> FloatArray:
    """Covariance (P, P) of the model's parameters, scaled by the residual scatter."""
    jacobian = (derivatives * np.sqrt(weight)[None, :, None]).reshape(-1, model.parameters)
    freedom = jacobian.shape[0] - model.parameters
    variance = float(np.sum(weight * distances**2)) / freedom if freedom > 0 else 0.0
    inverse = np.linalg.pinv(jacobian)  # of J itself: JᵀJ would square its condition
    return variance * (inverse @ inverse.T)


def _spread(shape: Shape, model: Model, state: State, scale_mm: float) -> FloatArray:
    """Jacobian (6 + sizes, P) of point (mm), direction and sizes of the feature by the model's parameters."""

    def reported(moved: State) -> FloatArray:
        sizes = moved.sizes * scale_mm
        if shape == "cone":
            sizes = np.array([_radius(shape, moved, scale_mm), moved.sizes[1]])
        return np.concatenate([moved.point * scale_mm, moved.direction, sizes])

    probes = PROBE * np.eye(model.parameters)
    return np.column_stack([(reported(model.move(state, probe)) - reported(model.move(state, -probe))) / (2 * PROBE) for probe in probes])


def _deviations(shape: Shape, model: Model, covariance: FloatArray, state: State, scale_mm: float) -> dict[str, float]:
    m, t = model.moves, model.moves + model.tilts
    found = {"position_mm": _largest(covariance[:m, :m]) * scale_mm}
    if model.tilts:
        found["direction_rad"] = _largest(covariance[m:t, m:t])
    sizes = np.sqrt(np.maximum(np.diag(covariance)[t:], 0))
    if shape == "cone":
        found |= {"radius_mm": _cone_radius_deviation(covariance[t:, t:], state) * scale_mm, "half_angle_rad": float(sizes[1])}
    else:
        found |= {name: float(size) * scale_mm for name, size in zip(("radius_mm", "minor_radius_mm"), sizes, strict=False)}
    return found


def _largest(covariance: FloatArray) -> float:
    return float(np.sqrt(max(np.linalg.eigvalsh(covariance)[-1], 0.0)))


def _cone_radius_deviation(covariance: FloatArray, state: State) -> float:
    """Propagate the covariance to the radius s / cos t."""
    distance, angle = state.sizes
    slope = np.array([1 / np.cos(angle), distance * np.sin(angle) / np.cos(angle) ** 2])
    return float(np.sqrt(max(slope @ covariance @ slope, 0.0)))
