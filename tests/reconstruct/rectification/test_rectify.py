from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.errors import ReconstructError
from measureapp.geometry.transform import RigidTransform
from measureapp.reconstruct.rectification.rectify import pixel_rays, rectify
from tests.reconstruct.conftest import Head


def test_rays_of_all_pixels_are_the_exact_ones(head: Head) -> None:
    pinhole = head.cameras.cameras["left"].pinhole
    pixels = np.random.default_rng(1).integers(0, [pinhole.width_px, pinhole.height_px], (500, 2))
    found = pixel_rays(pinhole)[pixels[:, 1], pixels[:, 0]]
    assert np.abs(found - pinhole.normalise(pixels.astype(float))).max() * pinhole.matrix[0, 0] < 1e-4


@pytest.mark.parametrize("names", [("left", "right"), ("left", "upper"), ("right", "upper"), ("right", "left")])
def test_a_point_lies_in_the_same_row_of_both_rectified_images_and_its_disparity_gives_its_depth(
    head: Head, names: tuple[str, str]
) -> None:
    pair = rectify(*(head.cameras.cameras[name] for name in names))
    points = np.random.default_rng(2).uniform([-80, -60, 480], [80, 60, 600], (200, 3))
    at = []
    for name, view in zip(names, (pair.here, pair.there), strict=True):
        camera = head.cameras.cameras[name]
        local = (head.head_from_reference @ camera.reference_from_camera).inverse().apply(points)
        turned = local @ view.rectified_from_camera.T
        focal, x0, y0 = view.frame
        at.append((focal * turned[:, 0] / turned[:, 2] - x0, focal * turned[:, 1] / turned[:, 2] - y0, turned[:, 2]))
    assert np.abs(at[0][1] - at[1][1]).max() < 1e-9
    disparity = at[0][0] + pair.here.frame[1] - at[1][0] - pair.there.frame[1]
    assert pair.baseline_mm * pair.here.frame[0] / disparity == pytest.approx(at[0][2])
    assert 0 < at[0][1].min() < at[0][1].max() < pair.rows


def test_the_grid_leads_back_to_the_image(head: Head) -> None:
    camera = head.cameras.cameras["upper"]
    pair = rectify(head.cameras.cameras["left"], camera)
    focal, x0, y0 = pair.there.frame
    i, j = 60, 80
    ray = np.array([(j * pair.stride + x0) / focal, (i * pair.stride + y0) / focal, 1.0]) @ pair.there.rectified_from_camera
    assert pair.there.grid[i, j] == pytest.approx(camera.pinhole.project(ray[None])[0], abs=1e-3)


def test_cameras_in_one_place_or_looking_along_their_baseline_are_refused(head: Head) -> None:
    left = head.cameras.cameras["left"]
    with pytest.raises(ReconstructError, match="one place"):
        rectify(left, left)
    ahead = replace(left, reference_from_camera=RigidTransform.from_parts(np.eye(3), [0, 0, 100], "camera", "left"))
    with pytest.raises(ReconstructError, match="along their baseline"):
        rectify(left, ahead)
