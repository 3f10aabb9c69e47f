"""A machined part whose deviations are known: a base with a side, a shaft, a bore, a slope, a ball, each off its drawing by what is asked."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.inspection.measured_points import MeasuredPoints

LENGTH_MM, RADIUS_MM, BORE_MM, BALL_MM = 60.0, 40.0, 8.0, 15.0
BORE_AT = (70.0, 25.0)
SLOPE_DEG = 30.0


@dataclass
class Part:
    """Points and outward normals, face by face; ``displaced`` moves the whole part away from its drawing."""

    rng: np.random.Generator
    noise_mm: float
    points: list[np.ndarray] = field(default_factory=list)
    normals: list[np.ndarray] = field(default_factory=list)

    def add(self, points: np.ndarray, normals: np.ndarray) -> None:
        self.points.append(points + self.noise_mm * self.rng.standard_normal((len(points), 1)) * normals)
        self.normals.append(normals)

    def square(self, centre, normal, along, half_mm=30.0, height=None, tilt_rad=0.0, count=4000) -> None:
        """A square face; ``height(u, v)`` lifts it, ``tilt_rad`` turns it about the axis that ``along`` is at right angles to."""
        normal, along = np.asarray(normal, float), np.asarray(along, float)
        turn = rotation_about(np.cross(normal, along), tilt_rad)
        u, v = self.rng.uniform(-half_mm, half_mm, (2, count))
        lifted = np.zeros(count) if height is None else height(u, v)
        flat = u[:, None] * along + v[:, None] * np.cross(normal, along) + lifted[:, None] * normal
        self.add(np.asarray(centre, float) + flat @ turn.T, np.tile(turn @ normal, (count, 1)))

    def round(self, centre, radius_mm, radial=None, bend=None, tilt_rad=0.0, length_mm=LENGTH_MM, hole=False, count=12000) -> None:
        """A cylinder along z about its middle; ``radial(φ)`` adds to the radius, ``bend(h)`` moves its axis along x, ``tilt_rad`` turns it about y."""
        turn, h = self.rng.uniform(0, 2 * np.pi, count), self.rng.uniform(-length_mm / 2, length_mm / 2, count)
        radius = radius_mm + (np.zeros(count) if radial is None else radial(turn))
        outward = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(count)])
        local = radius[:, None] * outward + h[:, None] * np.array([0, 0, 1.0])
        local[:, 0] += np.zeros(count) if bend is None else bend(h)
        leaning = rotation_about([0, 1, 0], tilt_rad)
        self.add(np.asarray(centre, float) + local @ leaning.T, (-1 if hole else 1) * outward @ leaning.T)

    def ball(self, centre, radius_mm=BALL_MM, count=3000) -> None:
        outward = self.rng.standard_normal((count, 3))
        outward[:, 2] = np.abs(outward[:, 2])
        outward /= np.linalg.norm(outward, axis=1, keepdims=True)
        self.add(np.asarray(centre, float) + radius_mm * outward, outward)

    def displaced(self) -> MeasuredPoints:
        placed = RigidTransform.from_vector([0.002, -0.0015, 0.0025], [0.15, -0.2, 0.1], "part", "nominal")
        return self.at_its_place().seen_from(placed)

    def at_its_place(self) -> MeasuredPoints:
        return MeasuredPoints(np.vstack(self.points), np.vstack(self.normals))


def plane(name, point, normal, **more):
    return {"name": name, "shape": "plane", "point_mm": list(point), "direction": list(normal), **more}


def cylinder(name, point, radius_mm, **more):
    return {"name": name, "shape": "cylinder", "point_mm": list(point), "direction": [0, 0, 1], "radius_mm": radius_mm, **more}
