"""The camera of a scene: standard views, fitting, and steering about a centre of rotation."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.standard_views import OPENING_DIRECTION, Direction

FILLED_FRACTION = 0.86  # of the free width or height, whichever is reached first
TURN_RAD = np.pi  # for a drag over the height of the picture
SMALLEST_MM, NEAREST = 1e-3, 1e-3  # height of the picture; near plane as a fraction of the far one


class SceneCamera:
    """Steers the camera of a renderer; pixels count from the lower left corner of the picture."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self.vtk: vtkCamera = renderer.GetActiveCamera()
        self.vtk.ParallelProjectionOn()
        self.keep_framed = True  # until the user moves the camera
        self.opening: Direction = OPENING_DIRECTION
        self.opening_up: Direction = (0.0, 0.0, 1.0)
        self.framed_mm: np.ndarray | None = None  # (N, 3), what the camera is opened on; None: everything
        self.centre_mm: np.ndarray | None = None  # (3,), of rotation; None: the middle of the picture
        self.free: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 1.0)  # room for the part: left, bottom, width, height as fractions

    @property
    def is_parallel(self) -> bool:
        """Whether sizes are comparable everywhere in the picture."""
        return bool(self.vtk.GetParallelProjection())

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height of the picture."""
        width, height = self._renderer.GetSize()
        return max(1, width), max(1, height)

    @property
    def axes(self) -> np.ndarray:
        """Right, up and the direction towards the viewer as rows (3, 3)."""
        towards = -np.array(self.vtk.GetDirectionOfProjection())
        right = np.cross(np.array(self.vtk.GetViewUp()), towards)
        right /= max(float(np.linalg.norm(right)), 1e-12)
        return np.stack([right, np.cross(towards, right), towards])

    @property
    def mm_per_px(self) -> float:
        """Length of a pixel at the focal point."""
        if self.is_parallel:
            return float(2.0 * self.vtk.GetParallelScale() / self.size_px[1])
        half = np.tan(np.radians(self.vtk.GetViewAngle()) / 2.0)
        return float(2.0 * self.vtk.GetDistance() * half / self.size_px[1])

    def projection(self) -> np.ndarray:
        """Return the matrix (4, 4) that projects the scene to −1…1."""
        matrix = self.vtk.GetCompositeProjectionTransformMatrix(self._renderer.GetTiledAspectRatio(), -1.0, 1.0)
        return np.array([[matrix.GetElement(line, place) for place in range(4)] for line in range(4)])

    def pixels(self, points_mm: np.ndarray) -> np.ndarray:
        """Project points (N, 3) in front of the camera to the picture."""
        matrix = self.projection()
        placed = points_mm @ matrix[:, :3].T + matrix[:, 3]
        return np.asarray((placed[:, :2] / placed[:, 3:] + 1.0) / 2.0 * np.array(self.size_px))

    def ray(self, x_px: float, y_px: float, depth: float | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Return a point (3,) of the ray through a pixel, at a value of the depth buffer or on the near plane, and its direction."""
        x, y = 2.0 * np.array([x_px, y_px]) / np.array(self.size_px) - 1.0
        first = -1.0 if depth is None else 2.0 * depth - 1.0
        ends = np.array([[x, y, -1.0, 1.0], [x, y, 1.0, 1.0], [x, y, first, 1.0]]) @ np.linalg.inv(self.projection()).T
        near, far, place = ends[:, :3] / ends[:, 3:]
        return place, (far - near) / np.linalg.norm(far - near)

    def view(self, width: float, height: float) -> CameraView:
        """Return the camera for a painter whose picture has this size."""
        per_px = self.mm_per_px * self.size_px[1] / height if self.is_parallel else None
        return CameraView(self.projection(), self.axes, width, height, per_px)

    def turn(self, right_rad: float, up_rad: float) -> None:
        """Rotate the part about the centre of rotation: to the right about the picture's vertical, up about its horizontal."""
        right, up, _ = self.axes
        rotation = _about(up, -right_rad) @ _about(right, up_rad)
        self._rotate(rotation)

    def drag(self, right_px: float, up_px: float) -> None:
        """Rotate as the mouse was dragged."""
        height = self.size_px[1]
        self.turn(TURN_RAD * right_px / height, TURN_RAD * up_px / height)

    def _rotate(self, rotation: np.ndarray) -> None:
        self.keep_framed = False
        focus, position = np.array(self.vtk.GetFocalPoint()), np.array(self.vtk.GetPosition())
        centre = focus if self.centre_mm is None else self.centre_mm
        up = rotation @ self.axes[1]
        self.vtk.SetFocalPoint(*(centre + rotation @ (focus - centre)))
        self.vtk.SetPosition(*(centre + rotation @ (position - centre)))
        self.vtk.SetViewUp(*up)

    def pan(self, right_px: float, up_px: float) -> None:
        """Move the part in the picture."""
        self.keep_framed = False
        right, up, _ = self.axes
        self._shift(-self.mm_per_px * (right_px * right + up_px * up))

    def zoom(self, times: float, x_px: float | None = None, y_px: float | None = None) -> None:
        """Enlarge the picture; what is at this pixel stays there."""
        self.keep_framed = False
        width, height = self.size_px
        right, up, _ = self.axes
        gap = np.array([0.0 if x_px is None else x_px - width / 2.0, 0.0 if y_px is None else y_px - height / 2.0])
        shift = self.mm_per_px * (1.0 - 1.0 / times) * (gap[0] * right + gap[1] * up)
        if self.is_parallel:
            self.vtk.SetParallelScale(max(self.vtk.GetParallelScale() / times, SMALLEST_MM))
        else:
            self.vtk.SetPosition(*(np.array(self.vtk.GetFocalPoint()) + self.axes[2] * self.vtk.GetDistance() / times))
        self._shift(shift)

    def zoom_to_box(self, low_px: tuple[float, float], high_px: tuple[float, float]) -> None:
        """Show a rectangle of the picture as large as possible."""
        width, height = self.size_px
        box = max(abs(high_px[0] - low_px[0]), 2.0), max(abs(high_px[1] - low_px[1]), 2.0)
        self.pan(width / 2.0 - (low_px[0] + high_px[0]) / 2.0, height / 2.0 - (low_px[1] + high_px[1]) / 2.0)
        self.zoom(min(width / box[0], height / box[1]))

    def set_parallel(self, parallel: bool) -> None:
        """Change the projection; what is at the focal point keeps its size."""
        half = np.tan(np.radians(self.vtk.GetViewAngle()) / 2.0)
        if parallel and not self.is_parallel:
            self.vtk.SetParallelScale(self.vtk.GetDistance() * half)
        elif not parallel and self.is_parallel:
            distance = self.vtk.GetParallelScale() / half
            self.vtk.SetPosition(*(np.array(self.vtk.GetFocalPoint()) + self.axes[2] * distance))
        self.vtk.SetParallelProjection(parallel)

    def open_from(self, direction: Direction, up: Direction = (0.0, 0.0, 1.0)) -> None:
        """Look from a direction at everything, with the next picture."""
        self.opening, self.opening_up, self.keep_framed = direction, up, True

    def orient(self, direction: Direction, up: Direction) -> None:
        """Look along a direction, without moving the focal point."""
        towards = np.array(direction, float) / np.linalg.norm(direction)
        self.vtk.SetPosition(*(np.array(self.vtk.GetFocalPoint()) + towards * max(self.vtk.GetDistance(), 1.0)))
        self.vtk.SetViewUp(*up)

    def reset(self, shown_mm: Sequence[np.ndarray]) -> None:
        """Look from the opening direction at these points, or at those that are framed."""
        self.vtk.SetFocalPoint(0.0, 0.0, 0.0)
        self.vtk.SetPosition(*(float(value) for value in self.opening))
        self.vtk.SetViewUp(*self.opening_up)
        self.centre_mm = None
        self.fill(shown_mm if self.framed_mm is None else [self.framed_mm])

    def fill(self, shown_mm: Sequence[np.ndarray]) -> None:
        """Move the camera without rotation so that these points fill the free room."""
        points = np.concatenate([np.empty((0, 3)), *shown_mm])
        if not len(points):
            return
        width, height = self.size_px
        left, bottom, wide, high = self.free
        placed = (points - np.array(self.vtk.GetFocalPoint())) @ self.axes.T
        room = max(wide, 0.2) * width / height, max(high, 0.2)  # in heights of the picture
        if self.is_parallel:
            low, high_mm = placed.min(axis=0), placed.max(axis=0)
            span = np.maximum(high_mm - low, SMALLEST_MM)
            whole = max(span[0] / room[0], span[1] / room[1]) / FILLED_FRACTION  # height of the picture in mm
            middle = (low + high_mm) / 2.0
            shift = np.array([(left + wide / 2.0 - 0.5) * width / height, bottom + high / 2.0 - 0.5]) * whole
            self.vtk.SetParallelScale(whole / 2.0)
            self._focus(np.array([middle[0] - shift[0], middle[1] - shift[1], middle[2]]), max(float(np.ptp(placed[:, 2])), whole) * 2.0)
            return
        half = np.tan(np.radians(self.vtk.GetViewAngle()) / 2.0) * FILLED_FRACTION
        x, across = _fit_camera(placed[:, 0], -placed[:, 2], half * room[0])
        y, along = _fit_camera(placed[:, 1], -placed[:, 2], half * room[1])
        distance = max(across, along, 1e-3)
        whole = 2.0 * distance * np.tan(np.radians(self.vtk.GetViewAngle()) / 2.0)
        shift = np.array([(left + wide / 2.0 - 0.5) * width / height, bottom + high / 2.0 - 0.5]) * whole
        self._focus(np.array([x - shift[0], y - shift[1], 0.0]), distance)

    def set_clipping_range(self, bounds_mm: Sequence[float]) -> None:
        """Fit near and far planes to the bounds of what is visible."""
        if self.is_parallel:  # the camera may be inside the part: only the order along the ray counts
            corners = np.array(np.meshgrid(bounds_mm[0:2], bounds_mm[2:4], bounds_mm[4:6])).reshape(3, -1).T
            depths = (np.array(self.vtk.GetFocalPoint()) - corners) @ self.axes[2]
            span = max(float(np.ptp(depths)), 1.0)
            distance = span + abs(float(depths.min())) + 1.0
            self.vtk.SetPosition(*(np.array(self.vtk.GetFocalPoint()) + self.axes[2] * distance))
            self.vtk.SetClippingRange(distance + float(depths.min()) - 0.05 * span, distance + float(depths.max()) + 0.05 * span)
            return
        self._renderer.ResetCameraClippingRange(list(bounds_mm))
        near, far = self.vtk.GetClippingRange()
        self.vtk.SetClippingRange(max(near, NEAREST * far), far)

    def _focus(self, placed: np.ndarray, distance: float) -> None:
        """Look at a point given along the axes of the picture."""
        axes = self.axes
        focus = np.array(self.vtk.GetFocalPoint()) + placed @ axes
        self.vtk.SetFocalPoint(*focus)
        self.vtk.SetPosition(*(focus + distance * axes[2]))

    def _shift(self, shift_mm: np.ndarray) -> None:
        self.vtk.SetFocalPoint(*(np.array(self.vtk.GetFocalPoint()) + shift_mm))
        self.vtk.SetPosition(*(np.array(self.vtk.GetPosition()) + shift_mm))


def _about(axis: np.ndarray, angle_rad: float) -> np.ndarray:
    """Return the rotation about a unit vector (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle_rad) * cross + (1.0 - np.cos(angle_rad)) * cross @ cross)


def _fit_camera(across: np.ndarray, depth: np.ndarray, slope: float) -> tuple[float, float]:
    """Return lateral position and distance of the camera at which all points are within a cone of this slope."""
    high, low = float(np.max(across - slope * depth)), float(np.min(across + slope * depth))
    return (high + low) / 2.0, (high - low) / (2.0 * slope)
