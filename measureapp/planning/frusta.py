"""What cameras and projector can see or light from a viewpoint, as pyramids."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import NominalPose, RigDescription
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.planning.aim import head_pose

Extent = tuple[int, int, float]  # width and height in pixels, focal length in pixels


@dataclass(frozen=True, slots=True, eq=False)
class Frustum:
    """The field of one camera or of the projector, cut by the plane at the stand-off."""

    name: str
    is_projector: bool
    apex_mm: FloatArray  # (3,), in the guide frame
    corners_mm: FloatArray  # (4, 3), in the guide frame, around the image

    def edges(self) -> tuple[FloatArray, ...]:
        """Return the edges as polylines: the four rays, and the outline at the stand-off."""
        rays = tuple(np.stack([self.apex_mm, corner]) for corner in self.corners_mm)
        return (*rays, np.vstack([self.corners_mm, self.corners_mm[:1]]))


def frusta(viewpoint: Viewpoint, rig: RigDescription) -> tuple[Frustum, ...]:
    """Return the nominal frusta of all cameras and of the projector at a viewpoint, in the guide frame."""
    guide_from_head = head_pose(viewpoint.flange, viewpoint.guide_mm, rig)
    devices: list[tuple[str, NominalPose, Extent]] = [
        (camera.name, camera.head_from_camera, (camera.width_px, camera.height_px, camera.focal_px)) for camera in rig.cameras
    ]
    projector = rig.projector
    devices.append((projector.name, projector.head_from_projector, (projector.width_px, projector.height_px, projector.focal_px)))
    return tuple(
        _frustum(name, pose, extent, guide_from_head, rig.standoff_mm, is_projector=place == len(rig.cameras))
        for place, (name, pose, extent) in enumerate(devices)
    )


def guide_from_part(viewpoint: Viewpoint, rig: RigDescription) -> RigidTransform:
    """Return where the part stands while the table is at the viewpoint's angle; its origin is the centre of the table's top."""
    turn = rotation_about([0, 0, 1], np.deg2rad(viewpoint.table_deg))
    return RigidTransform.from_parts(turn, rig.table.centre_in_guide_mm, "guide", "part")


def _frustum(
    name: str, mounted: NominalPose, extent: Extent, guide_from_head: RigidTransform, standoff_mm: float, *, is_projector: bool
) -> Frustum:
    width_px, height_px, focal_px = extent
    head_from_device = mounted.transform("head", "device")
    across, down = width_px / 2.0 / focal_px, height_px / 2.0 / focal_px
    rays = head_from_device.rotate(np.array([[-across, -down, 1.0], [across, -down, 1.0], [across, down, 1.0], [-across, down, 1.0]]))
    apex = head_from_device.translation_mm
    reach = (standoff_mm - apex[2]) / np.maximum(rays[:, 2], 0.05)  # to the plane at the stand-off; rays along it end somewhere
    corners = apex + rays * reach[:, None]
    return Frustum(name, is_projector, guide_from_head.apply(apex[None])[0], guide_from_head.apply(corners))
