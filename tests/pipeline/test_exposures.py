"""Valid pixels per exposure are those one counts in the images, and the composite has those of all exposures."""

from __future__ import annotations

import pytest

from measureapp.errors import InputError, StorageError
from measureapp.pipeline.exposures import RULES, project_exposures
from measureapp.progress import CallbackProgress, Cancelled
from tests.fringe_project import CAMERAS, EXPOSURES_US, fringe_project, shiny_stack, valid_in_each


def test_ratios_equal_the_pixels_counted_in_the_images(tmp_path) -> None:
    found = project_exposures(fringe_project(tmp_path / "p", "view01"))
    assert not found.failed
    stack = shiny_stack()
    for camera in CAMERAS:
        one, counted = found.viewpoints["view01"][camera], valid_in_each(stack, camera)
        assert one.exposures_us == EXPOSURES_US
        assert one.valid_ratios == pytest.approx(counted.mean(axis=(1, 2)), abs=1e-12)
        assert set(one.rules) == set(RULES)
        for made in one.rules.values():
            assert made.composite_ratio == pytest.approx(counted.any(axis=0).mean(), abs=0.002)
            assert made.composite_ratio > max(one.valid_ratios)
            assert made.decoded_ratio <= made.composite_ratio
        assert one.rules["combined"].sigma_rad < one.rules["paper"].sigma_rad  # more light of the same pixels


def test_only_the_viewpoints_that_are_asked_for_are_decoded(tmp_path) -> None:
    project = fringe_project(tmp_path / "p", "view01", "view02")
    assert list(project_exposures(project, ["view02", "view02"]).viewpoints) == ["view02"]
    with pytest.raises(InputError, match="'view09'"):
        project_exposures(project, ["view01", "view09"])


def test_a_damaged_viewpoint_is_named_and_the_others_are_counted(tmp_path) -> None:
    project = fringe_project(tmp_path / "p", "view01", "view02")
    file = project.path / "stacks" / "view01" / "left.npy"
    content = bytearray(file.read_bytes())
    content[-1] ^= 255
    file.write_bytes(content)
    found = project_exposures(project)
    assert list(found.viewpoints) == ["view02"]
    assert "left.npy" in found.failed["view01"]
    with pytest.raises(StorageError, match=r"left\.npy"):
        project_exposures(project, ["view01"])


def test_a_project_without_images_is_refused(tmp_path) -> None:
    with pytest.raises(InputError, match="no images"):
        project_exposures(fringe_project(tmp_path / "p"))


def test_counting_can_be_cancelled_between_the_rules(tmp_path) -> None:
    def stop(done: float, total: float, _note: str) -> None:
        if done >= 0.5 * total:
            raise Cancelled

    with pytest.raises(Cancelled):
        project_exposures(fringe_project(tmp_path / "p", "view01"), (), CallbackProgress(stop))
