"""Geometric constructions: each makes a feature from others; its errors follow from theirs by numerical derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature, Shape
from measureapp.errors import InspectionError
from measureapp.geometry.shapes import tangents

AXES = ("cylinder", "cone", "line")
FACES = ("plane", "point")  # between which a mid-plane lies; a surface point has the normal of its face
LEAST_CROSSING_DEG = 5.0
PARALLEL_WITHIN_DEG = 10.0
TOGETHER_MM, TOGETHER_DEG = 1.0, 1.0  # by which two features may be off one line or plane and still be one datum, whichever is more
IN_LINE = 1e-6  # relative extent across a line below which points do not determine a plane or circle

Maker = Callable[[Sequence[Feature]], Feature]
NamedMaker = Callable[[str, float, Sequence[Feature]], Feature]  # name, distance, parents


def _midpoint(name: str, _: float, of: Sequence[Feature]) -> Feature:
    first, second = of
    direction = first.direction
    if direction is not None and second.direction is not None:
        direction = direction + np.sign(direction @ second.direction or 1.0) * second.direction
        direction = direction / np.linalg.norm(direction)
    return Feature(name, "point", (first.point_mm + second.point_mm) / 2, direction)


def _midplane(name: str, distance: float, of: Sequence[Feature]) -> Feature:
    made = _midpoint(name, distance, of)
    if made.direction is None or any(one.shape not in FACES for one in of):  # midway on an axis the plane would lie across it
        raise InspectionError(f"{name}: a mid-plane needs two planes, {of[0].name} and {of[1].name} are not")
    return replace(made, shape="plane")


def _symmetry(name: str, distance: float, of: Sequence[Feature]) -> Feature:
    """Plane of symmetry of two planes (also inclined ones), axis of symmetry of two parallel axes, middle of two centres."""
    first, second = of
    if first.shape == second.shape == "plane":
        return _symmetry_plane(name, first, second)
    if first.shape in AXES and second.shape in AXES:
        _require_parallel(name, first, second)
        return replace(_midpoint(name, distance, of), shape="line")
    if first.direction is None or (first.shape not in ("plane", *AXES) and second.shape not in ("plane", *AXES)):
        return replace(_midpoint(name, distance, of), direction=None)
    raise InspectionError(f"{name}: symmetry needs two planes, two parallel axes, or two centres")


def _symmetry_plane(name: str, first: Feature, second: Feature) -> Feature:
    """Plane that bisects the angle of two planes through their line; of parallel planes the one midway between them."""
    one, other = _direction(first), _direction(second)
    facing = float(np.sign(one @ other) or -1.0)
    normal = one + facing * other
    normal = normal / np.linalg.norm(normal)
    across = np.cross(one, other)
    if np.linalg.norm(across) < np.sin(np.radians(LEAST_CROSSING_DEG)):
        return Feature(name, "plane", (first.point_mm + second.point_mm) / 2, normal)
    line = _line_of_planes(name, first, second)
    return Feature(name, "plane", line.point_mm, normal)


def _intersection(name: str, _: float, of: Sequence[Feature]) -> Feature:
    """Intersection of an axis and a plane (a point), of two planes (a line), or of three planes (a point)."""
    if len(of) == 3:
        return _point_of_planes(name, of)
    first, second = of
    if first.direction is None or second.direction is None or "plane" not in (first.shape, second.shape):
        raise InspectionError(f"{name}: an intersection needs a plane, and a plane or an axis")
    if first.shape == second.shape == "plane":
        return _line_of_planes(name, first, second)
    plane, axis = (first, second) if first.shape == "plane" else (second, first)
    return Feature(name, "point", _pierce(name, axis, plane), axis.direction)


def _pierce(name: str, axis: Feature, plane: Feature) -> FloatArray:
    normal, along = _direction(plane), _direction(axis)
    slope = float(normal @ along)
    if abs(slope) < np.sin(np.radians(LEAST_CROSSING_DEG)):
        raise InspectionError(f"{name}: the axis runs parallel to the plane and does not meet it")
    return np.asarray(axis.point_mm + float(normal @ (plane.point_mm - axis.point_mm)) / slope * along)


def _point_of_planes(name: str, of: Sequence[Feature]) -> Feature:
    for one in of:
        if one.shape != "plane":
            raise InspectionError(f"{name}: an intersection of three needs planes, {one.name} is a {one.shape}")
    normals = np.stack([_direction(one) for one in of])
    if abs(float(np.linalg.det(normals))) < np.sin(np.radians(LEAST_CROSSING_DEG)) ** 2:
        raise InspectionError(f"{name}: the three planes do not meet in one point: two are parallel, or all contain one direction")
    offsets = [float(normal @ one.point_mm) for normal, one in zip(normals, of, strict=True)]
    return Feature(name, "point", np.linalg.solve(normals, offsets))


def _projection(name: str, _: float, of: Sequence[Feature]) -> Feature:
    """Orthogonal projection of a centre or axis onto a plane: a point, or a line."""
    first, second = of
    if second.shape != "plane" or second.direction is None or first.shape == "plane":
        raise InspectionError(f"{name}: a projection needs a point or axis, and the plane it is projected onto")
    point = first.point_mm - float((first.point_mm - second.point_mm) @ second.direction) * second.direction
    if first.shape not in AXES or first.direction is None:
        return Feature(name, "point", point, second.direction)
    flat = first.direction - float(first.direction @ second.direction) * second.direction
    length = float(np.linalg.norm(flat))
    if length < np.sin(np.radians(LEAST_CROSSING_DEG)):
        raise InspectionError(
            f"{name}: the axis {first.name} is perpendicular to {second.name}; its projection is a point: use their intersection"
        )
    return Feature(name, "line", point, flat / length)


def _line_of_planes(name: str, first: Feature, second: Feature) -> Feature:
    one, other = _direction(first), _direction(second)
    direction = np.cross(one, other)
    length = float(np.linalg.norm(direction))
    if length < np.sin(np.radians(LEAST_CROSSING_DEG)):
        raise InspectionError(f"{name}: the planes are parallel and do not meet")
    direction /= length
    middle = (first.point_mm + second.point_mm) / 2
    system = np.stack([one, other, direction])
    offsets = np.array([one @ first.point_mm, other @ second.point_mm, direction @ middle])
    return Feature(name, "line", np.linalg.solve(system, offsets), direction)


def _offset(name: str, distance_mm: float, of: Sequence[Feature]) -> Feature:
    """A plane displaced along its outward normal."""
    (plane,) = of
    if plane.shape != "plane":
        raise InspectionError(f"{name}: an offset needs a plane, {plane.name} is a {plane.shape}")
    return Feature(name, "plane", plane.point_mm + distance_mm * _direction(plane), plane.direction)


def _point_on_axis(name: str, distance_mm: float, of: Sequence[Feature]) -> Feature:
    """The point of an axis at a distance from a plane, on the side of the plane's outward normal for a positive one."""
    axis, plane = of
    if axis.shape not in AXES or plane.shape != "plane":
        raise InspectionError(f"{name}: a point on an axis needs an axis, and the plane from which its distance counts")
    along = _direction(axis) * float(np.sign(_direction(axis) @ _direction(plane)) or 1.0)
    return Feature(name, "point", _pierce(name, axis, plane) + distance_mm * along, axis.direction)


def _best_fit_line(name: str, _: float, of: Sequence[Feature]) -> Feature:
    points = _centres(name, of)
    middle, spread, axes = _principal(points)
    if spread[0] <= 0:
        raise InspectionError(f"{name}: its points coincide")
    return Feature(name, "line", middle, _signed(axes[0], points))


def _best_fit_plane(name: str, _: float, of: Sequence[Feature]) -> Feature:
    points = _centres(name, of)
    middle, spread, axes = _principal(points)
    if spread[1] < IN_LINE * spread[0]:
        raise InspectionError(f"{name}: its points are on one line and determine no plane")
    expected = next((one.direction for one in of if one.direction is not None), None)
    sign = 1.0 if expected is None or axes[2] @ expected >= 0 else -1.0
    return Feature(name, "plane", middle, sign * axes[2] if expected is not None else _upright(axes[2]))


def _best_fit_circle(name: str, distance: float, of: Sequence[Feature]) -> Feature:
    """Circle through points: in their plane, by least squares of the radial distances."""
    plane = _best_fit_plane(name, distance, of)
    normal = _direction(plane)
    across = tangents(normal)
    points = (_centres(name, of) - plane.point_mm) @ across.T
    centre, radius = _circle_in_plane(name, points)
    return Feature(name, "circle", plane.point_mm + centre @ across, normal, radius)


def _pitch_circle(name: str, distance: float, of: Sequence[Feature]) -> Feature:
    """Circle through the axes or centres of a hole pattern, in the plane across their mean direction."""
    axes = [one for one in of if one.shape in (*AXES, "circle") and one.direction is not None]
    if len(axes) < len(of):
        return _best_fit_circle(name, distance, of)
    signs = [float(np.sign(_direction(one) @ _direction(axes[0])) or 1.0) for one in axes]
    normal = np.sum([sign * _direction(one) for sign, one in zip(signs, axes, strict=True)], axis=0)
    normal /= np.linalg.norm(normal)
    middle = np.mean([one.point_mm for one in axes], axis=0)
    across = tangents(normal)
    hits = [one.point_mm + float((middle - one.point_mm) @ normal) / float(_direction(one) @ normal) * _direction(one) for one in axes]
    centre, radius = _circle_in_plane(name, (np.stack(hits) - middle) @ across.T)
    return Feature(name, "circle", middle + centre @ across, normal, radius)


def _circle_in_plane(name: str, points: FloatArray) -> tuple[FloatArray, float]:
    """Return centre (2,) and radius: the algebraic circle, refined by Gauss-Newton on the radial distances."""
    design = np.column_stack([2 * points, np.ones(len(points))])
    solution, _, rank, _ = np.linalg.lstsq(design, np.sum(points**2, axis=1), rcond=1e-9)
    if rank < 3:
        raise InspectionError(f"{name}: its points are on one line and determine no circle")
    centre = solution[:2]
    for _ in range(20):
        away = points - centre
        rho = np.linalg.norm(away, axis=1)
        jacobian = np.column_stack([away / rho[:, None], np.ones(len(points))])
        step = np.linalg.lstsq(jacobian, rho, rcond=None)[0]  # the last unknown is the radius itself
        centre = centre + step[:2]
        if np.abs(step[:2]).max() < 1e-12 * rho.max():
            break
    return centre, float(np.linalg.norm(points - centre, axis=1).mean())


def _common_datum(name: str, distance: float, of: Sequence[Feature]) -> Feature:
    """Common datum (ISO 5459): the one axis of two axes in line, the one plane of two faces, the line through two centres.

    Both count together: their directions and the line from one middle to the other, each by its variance. To first order this is the
    least-squares fit to the points of both, since the middle and the direction of a fit are independent.
    """
    first, second = of
    shape: Shape = "line" if all(one.shape in AXES for one in of) else "plane"
    if shape == "plane" and {first.shape, second.shape} != {"plane"}:
        if any(one.shape in ("plane", *AXES) for one in of):
            raise InspectionError(
                f"{name}: {first.name} and {second.name} cannot be one datum, as two axes in line, two faces in one plane or two centres can"
            )
        return _best_fit_line(name, distance, of)
    if (off := _off_parallel_deg(first, second)) > PARALLEL_WITHIN_DEG:
        raise InspectionError(f"{name}: {first.name} and {second.name} are {off:.1f}° from parallel: they cannot be one datum")
    place, turn = _weights(of, "position_mm"), _weights(of, "direction_rad")
    facing = float(np.sign(_direction(first) @ _direction(second)) or 1.0)
    mean = turn[0] * _direction(first) + facing * turn[1] * _direction(second)
    mean /= np.linalg.norm(mean)
    between = second.point_mm - first.point_mm
    along = float(between @ mean)
    across = between - along * mean
    sides = float(np.linalg.norm(across))
    apart, lever = (sides, along) if shape == "line" else (abs(along), sides)
    if apart > max(TOGETHER_MM, abs(lever) * np.sin(np.radians(TOGETHER_DEG))):
        raise InspectionError(f"{name}: {first.name} and {second.name} are {apart:.3f} mm from one {shape}: they cannot be one datum")
    both = place[0] * place[1] / sum(place)
    tilt = both * along / (sum(turn) + both * lever**2) * across
    direction = mean + tilt if shape == "line" else mean - tilt
    middle = np.average([one.point_mm for one in of], axis=0, weights=place)
    return Feature(name, shape, middle, direction / np.linalg.norm(direction))


def _weights(of: Sequence[Feature], name: str) -> list[float]:
    """Return the inverse variances of features by noise; 1 each where they are not known, as of nominal ones."""
    deviations = [one.standard_deviations.get(name, 0.0) for one in of]
    return [1 / value**2 for value in deviations] if all(value > 0 for value in deviations) else [1.0] * len(of)


def _centres(name: str, of: Sequence[Feature]) -> FloatArray:
    for one in of:
        if one.shape in ("plane", *AXES):
            raise InspectionError(f"{name}: {one.name} is a {one.shape} and no point: intersect or project it first")
    return np.stack([one.point_mm for one in of])


def _principal(points: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle, full_matrices=True)
    return middle, np.append(spread, np.zeros(3 - len(spread))), axes


def _signed(direction: FloatArray, points: FloatArray) -> FloatArray:
    """Return a direction that points from the first to the last point."""
    return direction if (points[-1] - points[0]) @ direction >= 0 else -direction


def _upright(direction: FloatArray) -> FloatArray:
    """Return a direction whose largest component is positive."""
    return direction if direction[np.argmax(np.abs(direction))] > 0 else -direction


def _require_parallel(name: str, first: Feature, second: Feature) -> None:
    off = _off_parallel_deg(first, second)
    if off > PARALLEL_WITHIN_DEG:
        raise InspectionError(f"{name}: {first.name} and {second.name} are {off:.1f}° from parallel and have no axis of symmetry")


def _off_parallel_deg(first: Feature, second: Feature) -> float:
    return float(np.degrees(np.arccos(np.clip(abs(float(_direction(first) @ _direction(second))), 0, 1))))


def _direction(feature: Feature) -> FloatArray:
    if feature.direction is None:
        raise InspectionError(f"{feature.name} is a {feature.shape} and has no direction")
    return feature.direction


MAKERS: Mapping[str, NamedMaker] = {
    "midpoint": _midpoint,
    "midplane": _midplane,
    "symmetry": _symmetry,
    "intersection": _intersection,
    "projection": _projection,
    "offset": _offset,
    "point_on_axis": _point_on_axis,
    "best_fit_line": _best_fit_line,
    "best_fit_plane": _best_fit_plane,
    "best_fit_circle": _best_fit_circle,
    "pitch_circle": _pitch_circle,
    "common_datum": _common_datum,
}
