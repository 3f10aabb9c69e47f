"""Clouds are kept while everything they were computed from is what it was, and then equal, bit for bit, those computed from the images."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo, linked_copy

from measureapp.cli.outcome import report_event
from measureapp.data.calibration import RigCalibration
from measureapp.data.camera_shift import ShiftEvidence
from measureapp.data.decode_limits import DecodeLimits
from measureapp.data.measurement import ViewResult
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.pipeline import measure
from measureapp.pipeline.events import CloudsKept, Event, ViewFailed
from measureapp.pipeline.kept_views import kept_views
from measureapp.pipeline.measure import compute_clouds
from measureapp.pipeline.noise import decode_settings_of
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.fringes.decode_limits_file import save_decode_limits

ARRAYS = ("points_mm", "normals", "sigma_mm", "grey", "pixel", "cameras")
OF_SHIFT = ("information", "gradient", "image_px2", "depth_mm2")


@pytest.fixture
def project(demo: Demo, tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.open(linked_copy(demo.folder, tmp_path / "p"))


def computed(project: ProjectFolder, calibration: RigCalibration) -> tuple[tuple[ViewResult, ...], list[Event]]:
    events = list[Event]()
    return compute_clouds(project, calibration, events.append, NoProgress(), Stopwatch()), events


def with_another_hand_eye(calibration: RigCalibration) -> RigCalibration:
    hand_eye = calibration.hand_eye
    turn = RigidTransform.from_parts(rotation_about([0, 1, 0], 1e-3), np.array([0.1, 0.2, -0.3]), "camera", "camera")
    return replace(calibration, hand_eye=replace(hand_eye, flange_from_camera=hand_eye.flange_from_camera @ turn))


def same_shift(one: ShiftEvidence | None, other: ShiftEvidence | None) -> bool:
    if one is None or other is None:
        return one is other
    numbers = (one.cameras, one.samples, one.misfit, one.freedom) == (other.cameras, other.samples, other.misfit, other.freedom)
    return numbers and all(np.array_equal(getattr(one, name), getattr(other, name)) for name in OF_SHIFT)


def test_after_a_new_hand_eye_clouds_are_placed_anew_without_decoding_and_equal_those_from_the_images(
    project: ProjectFolder, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    calibration = with_another_hand_eye(project.require_calibration())
    bare = ProjectFolder.open(linked_copy(project.path, tmp_path / "bare"))
    shutil.rmtree(bare.results)
    scratch, events = computed(bare, calibration)
    assert not [event for event in events if isinstance(event, CloudsKept)]

    def decoding(*arguments: object, **named: object) -> None:
        raise AssertionError("images are decoded")

    monkeypatch.setattr(measure, "decode", decoding)
    kept, events = computed(project, calibration)
    assert events[0] == CloudsKept(len(kept), len(kept), placed_anew=True)
    report_event(events[0])
    assert capsys.readouterr().err == "6 of 6 clouds kept, placed anew.\n"
    assert len(kept) == len(scratch) == 6
    for one, other in zip(kept, scratch, strict=True):
        for name in ARRAYS:
            mine, theirs = getattr(one.cloud, name), getattr(other.cloud, name)
            assert mine.dtype == theirs.dtype and mine.tobytes() == theirs.tobytes(), name
        assert one.part_from_camera.matrix.tobytes() == other.part_from_camera.matrix.tobytes()
        assert (one.quality, one.findings, one.made_from) == (other.quality, other.findings, other.made_from)
        assert same_shift(one.shift, other.shift)


def test_without_any_change_clouds_are_kept_as_they_were(project: ProjectFolder, capsys: pytest.CaptureFixture[str]) -> None:
    kept = kept_views(project, project.require_calibration(), decode_settings_of(project))
    assert kept.unchanged == 6 and not kept.placed_anew
    report_event(CloudsKept(6, 6, placed_anew=False))
    assert capsys.readouterr().err == "6 of 6 clouds kept, as they were.\n"


def test_other_cameras_or_limits_or_another_program_keep_no_cloud(project: ProjectFolder, monkeypatch: pytest.MonkeyPatch) -> None:
    calibration, settings = project.require_calibration(), decode_settings_of(project)
    name = calibration.cameras.names[1]
    camera = calibration.cameras.cameras[name]
    matrix = np.array(camera.pinhole.matrix)
    matrix[0, 0] = np.nextafter(matrix[0, 0], np.inf)  # the least change there is
    longer = replace(camera, pinhole=replace(camera.pinhole, matrix=matrix))
    others = replace(calibration.cameras, cameras={**calibration.cameras.cameras, name: longer})
    assert kept_views(project, replace(calibration, cameras=others), settings).unchanged == 0
    with project.lock():
        save_decode_limits(project.path, DecodeLimits(min_modulation=20.0))
    assert kept_views(project, calibration, decode_settings_of(project)).unchanged == 0
    assert kept_views(project, calibration, settings).unchanged == 6
    monkeypatch.setattr("measureapp.pipeline.kept_views.fingerprint", lambda: "another program")
    assert kept_views(project, calibration, settings).unchanged == 0


def test_a_view_with_a_damaged_image_is_not_kept_and_said_to_be_damaged(project: ProjectFolder) -> None:
    image = sorted((project.path / "stacks" / "view02").glob("*.npy"))[0]
    content = bytearray(image.read_bytes())
    content[-1] ^= 1
    image.unlink()  # a link until now
    image.write_bytes(content)
    views, events = computed(project, project.require_calibration())
    assert [view.viewpoint_id for view in views] == [f"view{number:02d}" for number in (1, 3, 4, 5, 6)]
    failed = [event for event in events if isinstance(event, ViewFailed)]
    assert [one.viewpoint_id for one in failed] == ["view02"] and failed[0].damaged


def test_damaged_results_keep_nothing(project: ProjectFolder) -> None:
    document = project.results / "measurement.json"
    content = document.read_text(encoding="utf-8")
    document.unlink()  # a link until now
    document.write_text(content.replace('"quality"', '"Quality"'), encoding="utf-8")
    assert kept_views(project, project.require_calibration(), decode_settings_of(project)).views == {}
