"""Pixels at the border of a surface are left out: their phase is that of a place further in."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.reconstruct.discontinuities import exclude_discontinuities
from measureapp.reconstruct.projector.with_projector import reconstruct_alone
from measureapp.reconstruct.reconstruct import reconstruct
from measureapp.reconstruct.why import why
from tests.reconstruct.conftest import plane
from tests.reconstruct.projector_scene import ProjectorHead
from tests.reconstruct.projector_scene import make_head as make_projector_head

HEIGHT, WIDTH = 40, 50
BLUR_PX = 0.76
SLOPE = 0.3


def phase_map(state: IntArray, phase: FloatArray | None = None) -> PhaseMap:
    nothing = np.zeros(state.shape, np.uint8)
    some = np.zeros(state.shape, np.float32) if phase is None else phase.astype(np.float32)
    return PhaseMap("one", "v", some, some, nothing, nothing, state, nothing.astype(np.int8), 16.0, 1024)


def cameras(blur_px: float) -> CameraArrayCalibration:
    lens = PinholeCamera(WIDTH, HEIGHT, np.array([[90.0, 0, 25], [0, 90, 20], [0, 0, 1]]), np.zeros(5))
    return CameraArrayCalibration("one", {"one": CameraCalibration("one", lens, RigidTransform.identity("camera", "one"), blur_px=blur_px)})


def blurred(head: ProjectorHead) -> CameraArrayCalibration:
    return replace(head.cameras, cameras={name: replace(each, blur_px=BLUR_PX) for name, each in head.cameras.cameras.items()})


def rims(hole: BoolArray, blur_px: float = BLUR_PX) -> BoolArray:
    made = exclude_discontinuities({"one": phase_map(np.where(hole, np.uint8(PixelState.SHADOW), np.uint8(0)))}, cameras(blur_px))["one"]
    assert (made.state[hole] == PixelState.SHADOW).all()
    return np.asarray(made.state == PointState.RIM)


@pytest.mark.parametrize(("blur_px", "width"), [(0.5, 2), (BLUR_PX, 2), (0.95, 2), (1.2, 3), (1.5, 4), (2.0, 5)])
def test_pixels_around_a_hole_are_a_discontinuity_as_wide_as_the_blur(blur_px: float, width: int) -> None:
    hole = np.zeros((HEIGHT, WIDTH), np.bool_)
    hole[15:22, 20:30] = True
    cross = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))
    expected = cv2.dilate(hole.astype(np.uint8), cross, iterations=width).astype(bool) & ~hole
    np.testing.assert_array_equal(rims(hole, blur_px), expected)
    np.testing.assert_array_equal(rims(hole.T.copy()[:HEIGHT], blur_px), expected.T[:HEIGHT])


def test_single_pixels_without_a_phase_end_no_surface_and_borders_of_the_image_are_none() -> None:
    hole = np.zeros((HEIGHT, WIDTH), np.bool_)
    hole[5::7, 4::6] = True
    assert not rims(hole).any()
    hole[:] = False
    hole[10:30, 48:] = True  # within reach of the border nothing is left out
    assert not rims(hole)[:, -3:].any()


@pytest.mark.parametrize("blur_px", [0.5, BLUR_PX, 1.0, 1.2, 1.5])
def test_what_is_left_of_a_blurred_border_lies_where_it_should(blur_px: float) -> None:
    """Light of a surface that ends in the dark: beside its border the phase is that of a place further in, by about one and a half times the blur."""
    columns = np.mgrid[:HEIGHT, :WIDTH][1].astype(float)
    truth = 10 + SLOPE * columns
    fringes = np.where(columns >= 20, 1000.0, 0.0) * np.exp(1j * truth)
    blurred = cv2.GaussianBlur(fringes.real, (0, 0), blur_px) + 1j * cv2.GaussianBlur(fringes.imag, (0, 0), blur_px)
    seen = truth + np.angle(blurred * np.exp(-1j * truth))
    state = np.where(np.abs(blurred) > 100, np.uint8(0), np.uint8(PixelState.SHADOW))
    made = exclude_discontinuities({"one": phase_map(state, seen)}, cameras(blur_px))["one"]
    inner = (slice(5, -5), slice(5, -5))
    off = np.abs(seen - truth)[inner] / SLOPE
    assert off[(state == 0)[inner]].max() > 0.2
    assert off[made.valid[inner]].max() < 0.1 * off[(state == 0)[inner]].max()


def test_a_camera_whose_blur_is_not_known_keeps_its_rims() -> None:
    hole = np.zeros((HEIGHT, WIDTH), np.uint8)
    hole[15:22, 20:30] = PixelState.SHADOW
    seen = phase_map(hole)
    assert exclude_discontinuities({"one": seen}, cameras(0.0))["one"] is seen
    assert exclude_discontinuities({"other": seen}, cameras(BLUR_PX))["other"] is seen


@pytest.mark.parametrize("chosen", [("left",), ("left", "right"), ("left", "right", "upper")])
def test_rims_give_no_points_and_say_so(chosen: tuple[str, ...]) -> None:
    head = make_projector_head()
    known = blurred(head)
    maps = {name: each for name, each in head.phase_maps(plane(550, 0.2, 0.1)).items() if name in chosen}
    state = maps["left"].state.copy()
    state[80:140, 100:180] = PixelState.SHADOW
    seen = {**maps, "left": replace(maps["left"], state=state)}
    made = reconstruct(seen, known) if len(chosen) > 1 else reconstruct_alone(seen["left"], known)
    states = made.states["left"]
    assert (states[110, 97:100] == [PointState.VALID, PointState.RIM, PointState.RIM]).all()
    assert (states[110, 180:183] == [PointState.RIM, PointState.RIM, PointState.VALID]).all()
    assert states[110, 120] == PointState.NO_PHASE
    assert made.rejected["at a rim"] >= (states == PointState.RIM).sum() > 400
    told = why(seen, made, "left", 110, 98)
    assert (told.stage, told.reason) == ("clean", "rim")
    assert "border of its surface" in told.sentence


def test_the_phase_at_a_discontinuity_affects_no_other_pixel() -> None:
    """What blur does is told without it: beside a border it would bend the phase of pixels up to six further in."""
    head = make_projector_head()
    maps = head.phase_maps(plane(550, 0.2, 0.1))
    state = maps["left"].state.copy()
    state[80:140, 100:180] = PixelState.SHADOW
    seen = {**maps, "left": replace(maps["left"], state=state)}
    rim = exclude_discontinuities({"left": seen["left"]}, blurred(head))["left"].state == PointState.RIM
    off = {**seen, "left": replace(seen["left"], phase_rad=(seen["left"].phase_rad + 0.3 * rim).astype(np.float32))}
    made, shifted = (reconstruct(phases, blurred(head)).cloud for phases in (seen, off))
    np.testing.assert_array_equal(made.points_mm, shifted.points_mm)
    alone, shifted_alone = (reconstruct_alone(phases["left"], blurred(head)).cloud for phases in (seen, off))
    np.testing.assert_array_equal(alone.points_mm, shifted_alone.points_mm)
