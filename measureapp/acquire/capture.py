"""Acquisition at one viewpoint: move, confirm, project, grab, and check the identity of every image."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from math import radians

import numpy as np

from measureapp.acquire.events import Event, ImageTaken
from measureapp.arrays import ImageArray, read_only
from measureapp.data.board import BoardView
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback, FringeStack, PatternSet
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.devices.camera import Camera, GrabbedImage
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError
from measureapp.progress import Progress

MOVE_TIMEOUT_S = 120.0
GRAB_TIMEOUT_S = 5.0
SHOW_TIMEOUT_S = 2.0
TRIES = 3  # for an image that a camera does not deliver or that is not the requested one
POSITION_TOLERANCE_MM = 0.1
ANGLE_TOLERANCE_RAD = radians(0.05)
BOARD_SATURATED_SHARE = 0.002
PLAIN_LIGHT = -1


def move_to(rig: Rig, viewpoint: Viewpoint) -> AxisReadback:
    """Move every axis to ``viewpoint`` and return the read-back.

    Raises
    ------
    LimitError, DeviceTimeout
        From the axes.
    DeviceError
        An axis stopped elsewhere: nothing is measured at an unconfirmed pose.
    """
    rig.table.move_to(radians(viewpoint.table_deg), timeout_s=MOVE_TIMEOUT_S)
    rig.guide.move_to(viewpoint.guide_mm, timeout_s=MOVE_TIMEOUT_S)
    goal = viewpoint.flange.transform()
    rig.robot.move_to(goal, timeout_s=MOVE_TIMEOUT_S)
    readback = rig.readback()
    off = readback.base_from_flange.inverse() @ goal
    if np.linalg.norm(off.translation_mm) > POSITION_TOLERANCE_MM or off.angle_rad > ANGLE_TOLERANCE_RAD:
        raise DeviceError(
            f"{viewpoint.id}: the robot stopped away from its goal.",
            "Check for a collision or a protective stop, then repeat the viewpoint.",
        )
    if abs(readback.guide_mm - viewpoint.guide_mm) > POSITION_TOLERANCE_MM:
        raise DeviceError(
            f"{viewpoint.id}: the guide stopped at {readback.guide_mm:.3f} mm.", "Check the guide, then repeat the viewpoint."
        )
    if abs(readback.table_rad - radians(viewpoint.table_deg)) > ANGLE_TOLERANCE_RAD:
        raise DeviceError(
            f"{viewpoint.id}: the table stopped at {np.degrees(readback.table_rad):.3f}°.", "Check the table, then repeat the viewpoint."
        )
    return readback


@dataclass(frozen=True, slots=True, eq=False)
class ExposureTaken:
    """All images of one exposure of a viewpoint, available before the other exposures are taken."""

    viewpoint_id: str
    patterns: PatternSet
    exposures_us: tuple[int, ...]  # of the whole bracket
    level: int  # index into `exposures_us`
    images: Mapping[str, ImageArray]  # camera -> (patterns, height, width), read-only
    saturation: int


def capture_stack(
    rig: Rig,
    viewpoint: Viewpoint,
    plan: ScanPlan,
    on_event: Callable[[Event], None],
    progress: Progress,
    on_exposure: Callable[[ExposureTaken], None],
    approach: str | None = None,
) -> FringeStack:
    """Take all patterns at all exposures with all cameras; the patterns must be loaded into the projector already.

    ``on_exposure`` is called as soon as the images of one exposure are complete; ``approach`` identifies the robot's approach.

    Raises
    ------
    DeviceError
        A device refused a setting, or delivered an image other than the requested one three times in a row.
    Cancelled
        From ``progress``.
    """
    readback = move_to(rig, viewpoint)
    exposures = plan.bracket.exposures_us
    count = plan.patterns.count
    images = {
        name: np.empty((len(exposures), count, camera.height_px, camera.width_px), np.uint8 if camera.bit_depth == 8 else np.uint16)
        for name, camera in rig.cameras.items()
    }
    saturation = min(camera.saturation for camera in rig.description.cameras)
    for level, exposure_us in enumerate(exposures):
        set_exposure(rig.cameras, exposure_us)
        for pattern in range(count):
            progress.report(
                level * count + pattern, len(exposures) * count, f"{viewpoint.id}: image {pattern + 1} at {exposure_us / 1000:g} ms"
            )
            rig.projector.show(pattern, timeout_s=SHOW_TIMEOUT_S)
            for name, camera in rig.cameras.items():
                images[name][level, pattern] = grab_checked(camera, exposure_us, pattern)
                if pattern == 0:
                    on_event(ImageTaken(viewpoint.id, name, exposure_us, read_only(images[name][level, 0].copy())))
        on_exposure(
            ExposureTaken(
                viewpoint.id, plan.patterns, exposures, level, {name: read_only(stack[level]) for name, stack in images.items()}, saturation
            )
        )
    _confirm_still(rig, readback, viewpoint.id)
    return FringeStack(
        viewpoint_id=viewpoint.id,
        patterns=plan.patterns,
        exposures_us=exposures,
        images={name: read_only(stack) for name, stack in images.items()},
        saturation=saturation,
        readback=readback,
        conditions=read_conditions(rig),
        approach=approach,
    )


def capture_board(rig: Rig, viewpoint: Viewpoint) -> BoardView:
    """Take one image of the board per camera in uniform light, at the longest exposure without significant saturation."""
    readback = move_to(rig, viewpoint)
    rig.projector.show(PLAIN_LIGHT, timeout_s=SHOW_TIMEOUT_S)
    images = {name: _well_exposed(camera, rig) for name, camera in rig.cameras.items()}
    _confirm_still(rig, readback, viewpoint.id)
    return BoardView(viewpoint.id, images, readback, read_conditions(rig))


def read_conditions(rig: Rig) -> Conditions:
    """Read the present time, temperature, serial numbers and lens settings."""
    return rig.conditions(datetime.now(UTC).isoformat(timespec="milliseconds"))


def _well_exposed(camera: Camera, rig: Rig) -> ImageArray:
    saturation = rig.description.camera(camera.name).saturation
    for exposure_us in rig.description.exposures_us:
        set_exposure({camera.name: camera}, exposure_us)
        pixels = grab_checked(camera, exposure_us, PLAIN_LIGHT)
        if np.mean(pixels >= saturation) <= BOARD_SATURATED_SHARE:
            break
    return read_only(pixels)


def set_exposure(cameras: Mapping[str, Camera], exposure_us: int) -> None:
    """Set the exposure of all cameras. Raises DeviceError when a camera does not read it back."""
    for name, camera in cameras.items():
        camera.set_exposure_us(exposure_us)
        if camera.exposure_us() != exposure_us:
            raise DeviceError(
                f"Camera {name} set {camera.exposure_us()} µs instead of the requested {exposure_us} µs.",
                "Choose an exposure that the camera supports.",
            )


def grab_checked(camera: Camera, exposure_us: int, pattern: int) -> ImageArray:
    """Grab an image and verify serial number, size, exposure and pattern; a wrong image is taken again.

    Raises
    ------
    DeviceError
        Three images in a row were wrong.
    """
    reason = ""
    for _ in range(TRIES):
        image = camera.grab(timeout_s=GRAB_TIMEOUT_S)
        reason = _difference(image, camera, exposure_us, pattern)
        if not reason:
            return image.pixels
    raise DeviceError(
        f"Camera {camera.name} delivered {TRIES} wrong images in a row: {reason}.",
        "Check its trigger line and cable, then repeat the viewpoint.",
    )


def _difference(image: GrabbedImage, camera: Camera, exposure_us: int, pattern: int) -> str:
    if image.serial != camera.serial:
        return f"the image is from camera {image.serial}, not {camera.serial}"
    if image.pixels.shape != (camera.height_px, camera.width_px):
        return f"the image is {image.pixels.shape[1]} × {image.pixels.shape[0]} px, not {camera.width_px} × {camera.height_px} px"
    if image.exposure_us != exposure_us:
        return f"the image was exposed for {image.exposure_us} µs, not {exposure_us} µs"
    if image.pattern_index != pattern:
        return f"the image shows pattern {image.pattern_index}, not {pattern}"
    return ""


def _confirm_still(rig: Rig, before: AxisReadback, viewpoint_id: str) -> None:
    after = rig.readback()
    moved = np.linalg.norm(after.base_from_flange.translation_mm - before.base_from_flange.translation_mm)
    if moved > POSITION_TOLERANCE_MM or abs(after.guide_mm - before.guide_mm) > POSITION_TOLERANCE_MM:
        raise DeviceError(f"{viewpoint_id}: an axis moved while images were taken.", "Check the drives, then repeat the viewpoint.")
    if abs(after.table_rad - before.table_rad) > ANGLE_TOLERANCE_RAD:
        raise DeviceError(f"{viewpoint_id}: the table moved while images were taken.", "Check its brake, then repeat the viewpoint.")
