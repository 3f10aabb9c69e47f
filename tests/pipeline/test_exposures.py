"""Valid pixels per exposure are those one counts in the images, and the composite has those of all exposures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.errors import InputError, StorageError
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.exposures import RULES, decode_by_rules, project_exposures, ratios_of
from measureapp.progress import CallbackProgress, Cancelled, NoProgress
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


def test_the_composite_takes_the_longest_unsaturated_exposure_also_where_noise_lights_a_shorter_one() -> None:
    stack = shiny_stack()
    images = {name: made.copy() for name, made in stack.images.items()}
    random = np.random.default_rng(11)
    for made in images.values():
        made[:, :, :20] = random.choice([0, 1, 2], p=[0.02, 0.49, 0.49], size=made[:, :, :20].shape)  # a background without light
    dark = replace(stack, images=images)
    found = ratios_of(dark, decode_by_rules(dark, DecodeSettings(), NoProgress()))
    for camera in CAMERAS:
        unsaturated = (images[camera] < stack.saturation).all(axis=1)
        longest = np.argmax(unsaturated, axis=0)[None]
        lit = np.take_along_axis((images[camera] > 0).all(axis=1), longest, axis=0)[0]
        counted = (lit & unsaturated.any(axis=0)).mean()
        assert valid_in_each(dark, camera).any(axis=0).mean() > counted + 0.01
        assert [made.composite_ratio for made in found[camera].rules.values()] == pytest.approx([counted, counted], abs=1e-12)


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
