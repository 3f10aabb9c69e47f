"""Holes whose cause is known, painted into the images of two cameras before a plane, are explained by that cause."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.settings import DecodeSettings
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.why import ExplainedView, explain_stack
from tests.fringe.conftest import images_of

HEIGHT, WIDTH, DISPARITY = 120, 400, 60  # px; 300 px · 100 mm / 60 px = 500 mm
SIDE = 24  # of a painted box
PLACES = {  # of the left image, row and column of the box
    "saturated": (10, 120),
    "weak modulation": (10, 180),
    "shadow": (10, 240),
    "order conflict": (10, 300),
    "out of range": (70, 120),
    "unmatched": (70, 180),
    "edge": (70, 240),
    "island": (70, 300),
}
STAGES = {"unmatched": "match", "island": "clean"}
REMEDIES = {
    "saturated": "shorter exposure",
    "weak modulation": "longer exposure",
    "shadow": "add a viewpoint",
    "order conflict": "more pitches",
    "out of range": "reflection",
    "unmatched": "occluded from them",
    "edge": "Another viewpoint",
    "island": "fewer than",
}


def box(reason: str, shift: int = 0) -> tuple[slice, slice]:
    row, column = PLACES[reason]
    return slice(row, row + SIDE), slice(column + shift, column + shift + SIDE)


def plane_seen(shift: int) -> FloatArray:
    """Projector columns of a plane, as the camera ``shift`` px further to the right sees them."""
    return np.repeat(100.0 + 2.0 * (np.arange(WIDTH) + shift)[None], HEIGHT, axis=0)


def left_images() -> ImageArray:
    column, mean = plane_seen(0), np.full((HEIGHT, WIDTH), 110.0)
    modulation = np.full_like(mean, 80.0)
    mean[box("saturated")], modulation[box("saturated")] = 2000.0, 1500.0
    modulation[box("weak modulation")] = 8.0  # not enough, and well above the noise
    mean[box("shadow")], modulation[box("shadow")] = 3.0, 0.0
    column[box("out of range")] = 1038.0
    rows, columns = box("edge")
    column[rows, columns] += 200.0  # another surface; its border alone is an edge
    rows, columns = box("island")
    middle = slice(rows.start + 9, rows.stop - 9), slice(columns.start + 9, columns.stop - 9)
    kept = modulation[middle].copy()
    mean[rows, columns], modulation[rows, columns] = 3.0, 0.0
    mean[middle], modulation[middle] = 110.0, kept
    images = images_of(column, PAPER_PATTERNS, mean=mean, modulation=modulation, seed=5)
    moved = column + np.random.default_rng(6).integers(-16, 16, column.shape) + 0.5  # half a period from any order, each from another
    for group, seen in ((slice(0, 4), column), (slice(4, 8), moved)):
        images[0, group, *box("order conflict")] = images_of(seen, PAPER_PATTERNS, seed=None)[0, group, *box("order conflict")]
    return images


def right_images() -> ImageArray:
    mean, modulation = np.full((HEIGHT, WIDTH), 110.0), np.full((HEIGHT, WIDTH), 80.0)
    mean[box("unmatched", -DISPARITY)], modulation[box("unmatched", -DISPARITY)] = 3.0, 0.0  # something stands before the part
    return images_of(plane_seen(DISPARITY), PAPER_PATTERNS, mean=mean, modulation=modulation, seed=8)


@pytest.fixture(scope="module")
def explained() -> ExplainedView:
    matrix = np.array([[300.0, 0, WIDTH / 2], [0, 300, HEIGHT / 2], [0, 0, 1]])
    cameras = {
        name: CameraCalibration(
            name, PinholeCamera(WIDTH, HEIGHT, matrix, np.zeros(5)), RigidTransform.from_parts(np.eye(3), [x, 0, 0], "camera", name)
        )
        for name, x in (("left", 0.0), ("right", 100.0))
    }
    stack = FringeStack("v", PAPER_PATTERNS, (100_000,), {"left": left_images(), "right": right_images()}, 255)
    return explain_stack(stack, CameraArrayCalibration("left", cameras), DecodeSettings(blooming_radius_px=2))


@pytest.mark.parametrize("reason", list(PLACES))
def test_a_painted_cause_is_the_answer_with_its_stage_and_remedy(explained: ExplainedView, reason: str) -> None:
    row, column = PLACES[reason]
    place = (row + SIDE // 2, column) if reason == "edge" else (row + SIDE // 2, column + SIDE // 2)
    found = explained.pixel("left", *place).found
    assert (found.stage, found.reason) == (STAGES.get(reason, "decode"), reason)
    assert REMEDIES[reason] in found.sentence


@pytest.mark.parametrize("reason", [reason for reason in PLACES if reason not in ("edge", "island")])
def test_a_painted_box_has_lost_its_pixels_to_its_cause(explained: ExplainedView, reason: str) -> None:
    row, column = PLACES[reason]
    inner = explained.region("left", (row + 3, column + 3, row + SIDE - 3, column + SIDE - 3))
    assert next(iter(inner.shares)) == reason
    assert inner.shares[reason] > 0.8
    assert inner.example is not None and inner.example.found.reason == reason


def test_beside_a_saturated_box_the_guard_leaves_a_rim_and_says_so(explained: ExplainedView) -> None:
    row, column = PLACES["saturated"]
    for offset, reason in ((-1, "blooming"), (-2, "blooming"), (-6, "point")):
        assert explained.pixel("left", row + SIDE // 2, column + offset).found.reason == reason


def test_between_the_boxes_there_are_points(explained: ExplainedView) -> None:
    assert explained.region("left", (45, 120, 65, 330)).shares["point"] > 0.99
