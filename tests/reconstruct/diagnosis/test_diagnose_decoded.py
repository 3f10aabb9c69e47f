"""A wrong shift sign, decoded: whatever the kind of set, either decoding refuses it or the geometry names it."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration
from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.phase import PhaseMap
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.images import read_image
from measureapp.reconstruct.diagnosis.diagnose import diagnose
from tests.reconstruct.conftest import nearest, plane, sphere
from tests.reconstruct.projector_scene import HEAD, ProjectorHead, make_head

BALL = nearest(sphere((20, -10, 500), 40), plane(560, 0.1, -0.05))


def sinusoids(*pitches_px: float) -> tuple[PhaseShiftGroup, ...]:
    return tuple(PhaseShiftGroup(pitch_px=pitch, steps=4) for pitch in pitches_px)


SETS = {
    "paper": PatternSet(name="2", projector_px=1024, groups=sinusoids(32, 33)),
    "three pitches": PatternSet(name="3", projector_px=1024, groups=sinusoids(1024 / 64, 1024 / 58, 1024 / 53)),
    "three uneven pitches": PatternSet(name="3u", projector_px=1024, groups=sinusoids(42, 45, 48)),
    "hierarchical": PatternSet(name="h", projector_px=1024, groups=sinusoids(1024, 128, 32)),
    "gray code": PatternSet(
        name="g", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32, steps=4), GrayCodeGroup(planes=6, complementary=True))
    ),
}


@pytest.fixture(scope="module")
def head() -> ProjectorHead:
    return make_head({name: HEAD[name] for name in ("left", "right")}, binning=6)


@pytest.fixture(scope="module")
def columns(head: ProjectorHead) -> dict[str, FloatArray]:
    """The projector's column that every camera pixel sees; -1 where its light does not arrive."""
    return {name: np.where(found.valid, found.column_px, -1.0) for name, found in head.phase_maps(BALL).items()}


def images(patterns: PatternSet, columns: dict[str, FloatArray]) -> dict[str, np.ndarray]:
    random = np.random.default_rng(2)
    drawn = np.asarray(pattern_images(patterns, 1024, 4))[:, 0].astype(float)
    shots = {}
    for name, column in columns.items():
        seen = np.array([np.interp(column, np.arange(1024), row) for row in drawn]) * 0.7 + 20
        noisy = np.where(column >= 0, seen, 5.0) + random.normal(0, 0.5, seen.shape)
        shots[name] = np.clip(np.rint(noisy), 0, 255).astype(np.uint8)[None]
    return shots


@pytest.mark.parametrize("kind", SETS)
def test_the_right_sign_has_no_finding(head: ProjectorHead, columns: dict[str, FloatArray], kind: str) -> None:
    maps = decode(FringeStack("v", SETS[kind], (1000,), images(SETS[kind], columns), 255))
    assert diagnose(maps, head.cameras) == ()
    assert diagnose(maps, head.without_projector()) == ()


@pytest.mark.parametrize("kind", SETS)
def test_the_wrong_sign_is_refused_or_named(head: ProjectorHead, columns: dict[str, FloatArray], kind: str) -> None:
    wrong = SETS[kind].model_copy(update={"shift_sign": -SETS[kind].shift_sign})
    stack = FringeStack("v", wrong, (1000,), images(SETS[kind], columns), 255)
    try:
        maps = decode(stack)
    except DecodeError as refused:
        assert "shift_sign" in refused.hint
        return
    (finding,) = diagnose(maps, head.cameras)
    assert finding.kind == "wrong-sign"
    (finding,) = diagnose(maps, head.without_projector())
    assert finding.kind == "phase-runs-backwards"


# ---- Recorded sets


def cameras_of(folder: Path) -> CameraArrayCalibration:
    file = cv2.FileStorage(str(folder / "caliInfo.yml"), cv2.FILE_STORAGE_READ)
    node = {name: file.getNode(name).mat() for name in ("M1", "D1", "M2", "D2", "Rlr", "Tlr", "M4", "D4", "Rlp", "Tlp")}
    file.release()
    left = CameraCalibration("left", PinholeCamera(1280, 1024, node["M1"], node["D1"]), RigidTransform.identity("camera", "left"))
    if node["M2"] is not None and node["Rlr"] is not None:
        pose = RigidTransform.from_parts(node["Rlr"], node["Tlr"].ravel(), "right", "camera").inverse()
        right = CameraCalibration("right", PinholeCamera(1280, 1024, node["M2"], node["D2"]), pose)
        return CameraArrayCalibration("left", {"left": left, "right": right})
    pose = RigidTransform.from_parts(node["Rlp"], node["Tlp"].ravel(), "projector", "camera").inverse()
    projector = ProjectorCalibration(PinholeCamera(1920, 1080, node["M4"], node["D4"]), pose)
    return CameraArrayCalibration("left", {"left": left}, projector=projector)


def decoded(
    folders: dict[str, Path], numbers: list[int], groups: tuple[PhaseShiftGroup | GrayCodeGroup, ...], sign: int
) -> dict[str, PhaseMap]:
    shots = {name: np.array([read_image(folder / f"{number:02d}.png") for number in numbers])[None] for name, folder in folders.items()}
    patterns = PatternSet.model_validate({"name": "r", "projector_px": 1920, "groups": groups, "shift_sign": sign})
    return decode(FringeStack("v", patterns, (1000,), shots, 255))


THREE = tuple(PhaseShiftGroup(pitch_px=1920 / periods) for periods in (64, 58, 53))


def test_the_rendered_three_frequency_set_is_fine_and_its_wrong_sign_is_named() -> None:
    folder = recorded("slmaster_render_3freq")
    cameras = cameras_of(recorded("slmaster_render_stereo"))  # the calibrated head of the same renderer
    assert diagnose(decoded({"left": folder}, list(range(12)), THREE, 1), cameras) == ()
    try:
        wrong = decoded({"left": folder}, list(range(12)), THREE, -1)
    except DecodeError as refused:
        assert "shift_sign" in refused.hint
        return
    (finding,) = diagnose(wrong, cameras)
    assert finding.kind == "phase-runs-backwards"


def test_the_rendered_pair_is_fine_its_wrong_sign_refused_and_its_exchange_named() -> None:
    folder = recorded("slmaster_render_stereo")
    groups = (PhaseShiftGroup(pitch_px=30, steps=4), GrayCodeGroup(planes=7, complementary=True))
    places = {"left": folder / "L", "right": folder / "R"}
    numbers = [0, 3, 6, 9, *range(12, 19)]
    with pytest.raises(DecodeError, match="phase decreases where the Gray code increases") as refused:
        decoded(places, numbers, groups, -1)
    assert "shift_sign" in refused.value.hint
    cameras = cameras_of(folder)
    assert diagnose(decoded(places, numbers, groups, 1), cameras) == ()
    (finding,) = diagnose(decoded({"left": folder / "R", "right": folder / "L"}, numbers, groups, 1), cameras)
    assert finding.message == "The images of left and right appear to be exchanged."


def test_the_real_camera_and_projector_are_fine_and_the_wrong_sign_is_refused() -> None:
    folder = recorded("slmaster_real_mono")
    groups = (PhaseShiftGroup(pitch_px=60, steps=12), GrayCodeGroup(planes=6, complementary=True))
    with pytest.raises(DecodeError, match="phase decreases where the Gray code increases"):
        decoded({"left": folder}, list(range(18)), groups, -1)
    assert diagnose(decoded({"left": folder}, list(range(18)), groups, 1), cameras_of(folder)) == ()
