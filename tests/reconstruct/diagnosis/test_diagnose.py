"""Mistakes that decode smoothly are named; good rigs of any geometry are left alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import tau

import numpy as np
import pytest

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.errors import ReconstructError
from measureapp.geometry.transform import RigidTransform
from measureapp.reconstruct.diagnosis.diagnose import Finding, diagnose
from tests.reconstruct.conftest import Surface, nearest, plane, sphere
from tests.reconstruct.projector_scene import HEAD, PITCH_PX, Pose, ProjectorHead, make_head, projector_lens, wrong_sign

PLANE, BALL = plane(550, 0.2, 0.1), nearest(sphere((20, -10, 500), 40), plane(560, 0.1, -0.05))
BEAT_PX = 1056.0  # of 32 and 33 px
LEFT, RIGHT, UPPER = HEAD["left"], HEAD["right"], HEAD["upper"]
UPSIDE_DOWN: Pose = ((0, 0, 0), (0, 0, 180))


def portrait(pose: Pose) -> Pose:
    """The same camera turned by a quarter about its optical axis."""
    return pose[0], (pose[1][0], pose[1][1], 90)


RIGS: dict[str, tuple[dict[str, Pose], Pose]] = {
    "three cameras": (HEAD, ((0, 0, 0), (0, 0, 0))),
    "one on either side": ({"left": LEFT, "right": RIGHT}, ((0, 0, 0), (0, 0, 0))),
    "right one is the reference": ({"right": RIGHT, "left": LEFT}, ((0, 0, 0), (0, 0, 0))),
    "both right of the projector": ({"a": ((120, 0, 0), (0, -12, 0)), "b": ((260, 0, 0), (0, -25, 0))}, ((0, 0, 0), (0, 0, 0))),
    "both left of the projector": ({"a": ((-260, 0, 0), (0, 25, 0)), "b": ((-120, 0, 0), (0, 12, 0))}, ((0, 0, 0), (0, 0, 0))),
    "portrait cameras": ({"left": portrait(LEFT), "right": portrait(RIGHT)}, ((0, 0, 0), (0, 0, 0))),
    "one camera on its head": ({"left": LEFT, "right": (RIGHT[0], (0, -17.6, 180))}, ((0, 0, 0), (0, 0, 0))),
    "parallel cameras": ({"left": ((-60, 0, 0), (0, 0, 0)), "right": ((60, 0, 0), (0, 0, 0))}, ((0, 0, 0), (0, 0, 0))),
    "one camera": ({"left": LEFT}, ((0, 0, 0), (0, 0, 0))),
    "one camera above": ({"upper": UPPER}, ((0, 0, 0), (0, 0, 0))),
    "projector on its head": (HEAD, UPSIDE_DOWN),
}


@pytest.fixture(scope="module")
def head() -> ProjectorHead:
    return make_head()


def kinds(findings: tuple[Finding, ...]) -> set[str]:
    return {finding.kind for finding in findings}


def exchanged(maps: Mapping[str, PhaseMap], one: str, other: str) -> dict[str, PhaseMap]:
    return dict(maps) | {one: replace(maps[other], camera=one), other: replace(maps[one], camera=other)}


def turned(phase_map: PhaseMap) -> PhaseMap:
    def half(image: np.ndarray) -> np.ndarray:
        return np.ascontiguousarray(image[::-1, ::-1])

    return replace(phase_map, phase_rad=half(phase_map.phase_rad), sigma_rad=half(phase_map.sigma_rad), state=half(phase_map.state))


def moved(cameras: CameraArrayCalibration, name: str, vector_mm: tuple[float, float, float], angles_rad: tuple[float, float, float]):
    """The calibration of before the camera moved."""
    pose = cameras.cameras[name].reference_from_camera
    stale = replace(cameras.cameras[name], reference_from_camera=pose @ RigidTransform.from_vector(angles_rad, vector_mm, name, name))
    return replace(cameras, cameras={**cameras.cameras, name: stale})


@pytest.mark.parametrize("surface", [PLANE, BALL], ids=["plane", "ball before a wall"])
@pytest.mark.parametrize("across", [False, True], ids=["vertical", "both directions"])
@pytest.mark.parametrize("rig", RIGS)
def test_a_good_rig_has_no_finding(rig: str, across: bool, surface: Surface) -> None:
    poses, projector = RIGS[rig]
    good = make_head(poses, projector)
    maps = good.phase_maps(surface, noise_seed=7, across=across)
    assert diagnose(maps, good.cameras) == ()
    expected = {"phase-runs-backwards"} if rig == "projector on its head" else set()
    assert kinds(diagnose(maps, good.without_projector())) == expected


@pytest.mark.parametrize("sigma_rad", [0.05, 0.15])
def test_noise_alone_is_no_finding(head: ProjectorHead, sigma_rad: float) -> None:
    maps = head.phase_maps(BALL, noise_seed=7, sigma_rad=sigma_rad)
    assert diagnose(maps, head.cameras) == ()
    assert diagnose(maps, head.without_projector()) == ()


@pytest.mark.parametrize("rig", [rig for rig in RIGS if rig != "projector on its head"])
def test_a_wrong_shift_sign_is_an_error_with_a_calibrated_projector(rig: str) -> None:
    good = make_head(*RIGS[rig])
    maps = {name: wrong_sign(phase_map, BEAT_PX) for name, phase_map in good.phase_maps(BALL, noise_seed=7).items()}
    findings = diagnose(maps, good.cameras)
    assert findings[0].kind == "wrong-sign"
    assert findings[0].severity == "error"
    assert "shift_sign" in findings[0].remedy
    with pytest.raises(ReconstructError, match="increases against the columns"):
        raise findings[0].error()


def test_a_wrong_shift_sign_of_a_projector_on_its_head_is_an_error_too() -> None:
    good = make_head(*RIGS["projector on its head"])
    maps = {name: wrong_sign(phase_map, BEAT_PX) for name, phase_map in good.phase_maps(BALL, noise_seed=7).items()}
    assert "wrong-sign" in kinds(diagnose(maps, good.cameras))


@pytest.mark.parametrize("rig", ["three cameras", "one on either side", "parallel cameras", "one camera"])
def test_without_a_calibrated_projector_a_wrong_sign_and_a_projector_on_its_head_are_both_named(rig: str) -> None:
    good = make_head(*RIGS[rig])
    maps = {name: wrong_sign(phase_map, BEAT_PX) for name, phase_map in good.phase_maps(BALL, noise_seed=7).items()}
    (finding,) = diagnose(maps, good.without_projector())
    assert (finding.kind, finding.severity) == ("phase-runs-backwards", "warning")
    assert "shift_sign" in finding.remedy
    assert "upside down" in finding.remedy


@pytest.mark.parametrize("with_projector", [False, True])
@pytest.mark.parametrize("surface", [PLANE, BALL], ids=["plane", "ball before a wall"])
@pytest.mark.parametrize("pair", [("left", "right"), ("left", "upper"), ("right", "upper")])
def test_exchanged_images_of_three_cameras_are_named(
    head: ProjectorHead, pair: tuple[str, str], surface: Surface, with_projector: bool
) -> None:
    maps = exchanged(head.phase_maps(surface, noise_seed=7), *pair)
    (finding,) = diagnose(maps, head.cameras if with_projector else head.without_projector())
    assert finding.kind == "swapped-cameras"
    assert finding.message == f"The images of {pair[0]} and {pair[1]} appear to be exchanged."


def test_a_cycle_of_three_cameras_is_named(head: ProjectorHead) -> None:
    maps = head.phase_maps(BALL, noise_seed=7)
    order = {"left": "right", "right": "upper", "upper": "left"}
    wrong = {name: replace(maps[other], camera=name) for name, other in order.items()}
    (finding,) = diagnose(wrong, head.without_projector())
    assert "left and right and upper appear to be exchanged" in finding.message
    # The true images of left are those now called upper.
    assert "left ← upper" in finding.remedy


@pytest.mark.parametrize(
    ("rig", "surface", "with_projector", "across"),
    [
        ("parallel cameras", PLANE, False, False),  # matches lie behind the cameras
        ("one on either side", PLANE, True, False),
        ("one on either side", PLANE, False, True),
        ("both right of the projector", BALL, True, False),
    ],
)
def test_exchanged_images_of_a_pair_are_named(rig: str, surface: Surface, with_projector: bool, across: bool) -> None:
    good = make_head(*RIGS[rig])
    one, other = good.cameras.names
    maps = exchanged(good.phase_maps(surface, noise_seed=7, across=across), one, other)
    findings = diagnose(maps, good.cameras if with_projector else good.without_projector())
    assert kinds(findings) == {"swapped-cameras"}


@pytest.mark.parametrize("surface", [PLANE, BALL], ids=["plane", "ball before a wall"])
@pytest.mark.parametrize("rig", ["one on either side", "both right of the projector", "right one is the reference"])
def test_a_print_on_the_part_shows_that_the_images_of_a_pair_are_exchanged(rig: str, surface: Surface) -> None:
    good = make_head(*RIGS[rig])
    maps = good.phase_maps(surface, noise_seed=7, print_on_part=True)
    assert diagnose(maps, good.without_projector()) == ()
    assert kinds(diagnose(exchanged(maps, *good.cameras.names), good.without_projector())) == {"swapped-cameras"}


def test_one_turned_image_is_named(head: ProjectorHead) -> None:
    maps = head.phase_maps(BALL, noise_seed=7)
    maps["right"] = turned(maps["right"])
    for cameras in (head.cameras, head.without_projector()):
        findings = diagnose(maps, cameras)
        assert findings[0].kind == "turned-image"
        assert "right" in findings[0].message


def test_images_of_another_calibration_are_said_to_be_unrelated(head: ProjectorHead) -> None:
    maps = head.phase_maps(BALL, noise_seed=7)
    elsewhere = moved(head.without_projector(), "right", (60, 40, 0), (0.1, 0.2, 0.1))
    elsewhere = moved(elsewhere, "upper", (-30, 60, 0), (0.15, 0.1, 0.3))
    assert "unrelated-cameras" in kinds(diagnose(maps, elsewhere))


@pytest.mark.parametrize(
    ("name", "vector_mm", "angles_rad"),
    [
        ("upper", (0.6, 0, 0), (0, 0, 0)),
        ("upper", (0, 0, 0), (0, 0, 8e-3)),
        ("right", (0, 0, 0), (0, 3e-3, 0)),
        ("left", (0, 0, 0), (0, 2e-3, 0)),
    ],
)
def test_a_camera_that_moved_is_a_warning_with_pixels_and_millimetres(head: ProjectorHead, name, vector_mm, angles_rad) -> None:
    cameras = head.without_projector()
    if name == cameras.reference:  # its frame is that of all: the others moved against it
        for other in ("right", "upper"):
            turn = RigidTransform.from_vector(angles_rad, vector_mm, "camera", "camera")
            camera = cameras.cameras[other]
            stale = replace(camera, reference_from_camera=turn @ camera.reference_from_camera)
            cameras = replace(cameras, cameras={**cameras.cameras, other: stale})
    else:
        cameras = moved(cameras, name, vector_mm, angles_rad)
    (finding,) = diagnose(head.phase_maps(BALL, noise_seed=7), cameras)
    assert (finding.kind, finding.severity) == ("moved-camera", "warning")
    assert finding.figures["px"] > 0.25
    assert finding.figures["mm"] > 0.01
    assert "px" in finding.message
    assert "mm" in finding.message


def test_a_camera_that_moved_less_than_the_noise_of_a_pixel_is_found_all_the_same() -> None:
    fine = make_head(binning=4)
    maps = fine.phase_maps(BALL, noise_seed=7, sigma_rad=0.05)
    assert diagnose(maps, fine.without_projector()) == ()
    (finding,) = diagnose(maps, moved(fine.without_projector(), "upper", (0.3, 0, 0), (0, 0, 0)))
    assert finding.kind == "moved-camera"


def test_horizontal_fringes_show_that_one_camera_of_a_pair_moved() -> None:
    good = make_head(*RIGS["one on either side"])
    cameras = moved(good.without_projector(), "right", (0, 0, 0), (3e-3, 0, 0))
    (finding,) = diagnose(good.phase_maps(BALL, noise_seed=7, across=True), cameras)
    assert finding.kind == "moved-camera"
    assert diagnose(good.phase_maps(BALL, noise_seed=7), cameras) == ()  # vertical ones cannot


def test_a_projector_that_moved_is_a_warning(head: ProjectorHead) -> None:
    turn = RigidTransform.from_vector([0, 0.02, 0], [0, 0, 0], "projector", "projector")
    pose = head.projector.reference_from_projector @ turn
    cameras = replace(head.cameras, projector=replace(head.projector, reference_from_projector=pose))
    (finding,) = diagnose(head.phase_maps(BALL, noise_seed=7), cameras)
    assert (finding.kind, finding.severity) == ("projector-off", "warning")
    assert abs(finding.figures["columns"]) == pytest.approx(0.02 * 1609, rel=0.1)


@pytest.mark.parametrize("factor", [0.9, 1.05])
def test_a_wrong_pitch_is_named(head: ProjectorHead, factor: float) -> None:
    maps = {name: replace(found, pitch_px=PITCH_PX * factor) for name, found in head.phase_maps(BALL, noise_seed=7).items()}
    assert kinds(diagnose(maps, head.cameras)) == {"wrong-pitch"}


def test_columns_beyond_the_calibrated_projector_are_named(head: ProjectorHead) -> None:
    smaller = replace(head.projector, pinhole=projector_lens(512, 384))
    findings = diagnose(head.phase_maps(BALL, noise_seed=7), replace(head.cameras, projector=smaller))
    assert kinds(findings) == {"wrong-pitch"}
    assert "calibrated projector has 512 columns" in findings[0].message


def test_rows_taken_for_columns_are_named(head: ProjectorHead) -> None:
    across = {name: found.orthogonal for name, found in head.phase_maps(BALL, noise_seed=7, across=True).items()}
    maps = {name: found for name, found in across.items() if found is not None}
    assert "fringe-direction" in kinds(diagnose(maps, head.cameras))


def test_a_single_camera_whose_columns_lie_behind_it_is_reported() -> None:
    good = make_head(*RIGS["one camera"])
    shifted = {
        name: replace(found, phase_rad=np.where(found.valid, found.phase_rad - np.float32(700 * tau / PITCH_PX), 0).astype(np.float32))
        for name, found in good.phase_maps(BALL, noise_seed=7).items()
    }
    assert kinds(diagnose(shifted, good.cameras)) == {"projector-off"}


def test_images_without_a_phase_are_no_finding(head: ProjectorHead) -> None:
    maps = head.phase_maps(BALL)
    dark = {name: replace(found, state=np.full_like(found.state, PixelState.SHADOW)) for name, found in maps.items()}
    assert diagnose(dark, head.cameras) == ()
