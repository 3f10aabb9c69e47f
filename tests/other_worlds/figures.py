"""What this project makes of a stack beside what a plain decoder makes of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import FringeStack
from measureapp.fringe.decode import decode
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from tests.other_worlds.plain import plain_columns, plain_pairs, predicted_over_observed


@dataclass(frozen=True)
class Figures:
    """Fractions and ratios of one stack; of points only where there are two cameras."""

    modulation: float  # median of the plain decoder's pixels, grey levels
    plain: int  # pixels of the first camera that the plain decoder finds valid and consistent
    decoded: float  # fraction of them that are decoded
    wrong: float  # fraction of the decoded ones whose column is another than the plain decoder's, by more than half a period
    phase_ratio: float  # predicted over observed standard deviation of the phase
    pairs: int = 0  # pixels of the left camera with a partner in the right one, by the plain decoder
    points: float = 0.0  # fraction of them that are points
    point_ratio: float = 0.0

    def row(self, name: str) -> str:
        """Return a line of the table in `resources/docs/measurements.md`."""
        points = f"{self.pairs} | {self.points:.2%} | {self.point_ratio:.2f}" if self.pairs else "– | – | –"
        return (
            f"| {name} | {self.modulation:.0f} | {self.plain} | {self.decoded:.2%} | {self.wrong:.0e} | {self.phase_ratio:.2f} | {points} |"
        )


def figures_of(
    stack: FringeStack, cameras: CameraArrayCalibration | None = None, modulation: tuple[float, float] = (5.0, 255.0)
) -> Figures:
    """Measure the figures, at pixels whose plain modulation is within the limits."""
    seen = {camera: plain_columns(stack, camera, modulation[0]) for camera in stack.images}
    maps = decode(stack)
    first = "left" if "left" in maps else next(iter(maps))
    column, strength = seen[first]
    wanted = np.isfinite(column) & (strength <= modulation[1])
    found = maps[first]
    off = (found.column_px - column)[wanted & found.valid] / found.pitch_px
    off -= np.rint(np.median(off) * 2) / 2  # origin of the patterns
    figures = Figures(
        float(np.median(strength[wanted])),
        int(wanted.sum()),
        float(found.valid[wanted].mean()),
        float(np.mean(np.abs(off) > 0.5)),
        predicted_over_observed(found.phase_rad.astype(float), found.sigma_rad.astype(float), found.valid),
    )
    if cameras is None:
        return figures
    pairs = plain_pairs({camera: seen[camera][0] for camera in ("left", "right")}, cameras) & wanted
    made = reconstruct(maps, cameras)
    is_point = np.zeros(wanted.shape, bool)
    is_point[tuple(made.cloud.pixel.T)] = True
    return Figures(
        *(getattr(figures, name) for name in ("modulation", "plain", "decoded", "wrong", "phase_ratio")),
        int(pairs.sum()),
        float(is_point[pairs].mean()),
        _ratio_of_points(made, is_point),
    )


def _ratio_of_points(made: Reconstruction, is_point: BoolArray) -> float:
    distance, sigma = np.zeros(is_point.shape), np.ones(is_point.shape)
    place = tuple(made.cloud.pixel.T)
    distance[place] = np.linalg.norm(made.cloud.points_mm, axis=1)
    sigma[place] = made.cloud.sigma_mm
    return predicted_over_observed(distance, sigma, is_point)
