"""Predicted clouds: they lie on the nominal within their standard deviation, and only where cameras and projector see it."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.fringe import FringeStack, PhaseShiftGroup
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.data.phase import PixelState
from measureapp.fringe.decode import decode
from measureapp.fringe.noise.model import CameraNoise
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.prediction.light import NOT_USED, CameraExposures, PartLight
from measureapp.pipeline.prediction.measured_light import light_of_views
from measureapp.pipeline.prediction.uncertainty import exposing_of
from measureapp.pipeline.prediction.views import PredictedScene
from tests.pipeline.predicted_rig import box, joined, nominal_rig, plan_for

PATTERNS = PATTERN_SETS["three-close"]
EXPOSURES_US = (100_000, 50_000)
SATURATION = 255.0


def images_of(mean: float, modulation: float, shape: tuple[int, int], rng: np.random.Generator) -> np.ndarray:
    """Noisy images (exposures, patterns, H, W) of a plane with a slow phase, in grey levels of 8 bits, without saturation."""
    noise, column = CameraNoise(), np.broadcast_to(np.linspace(300.0, 320.0, shape[1]), shape)
    taken = []
    for exposure in EXPOSURES_US:
        share = exposure / EXPOSURES_US[0]
        images = []
        for group in PATTERNS.groups:
            assert isinstance(group, PhaseShiftGroup)
            for step in range(group.steps):
                phase = 2 * np.pi * (column / group.pitch_px + PATTERNS.shift_sign * step / group.steps)
                light = SATURATION * share * (mean + modulation * np.cos(phase))
                spread = np.sqrt(noise.variance(light, SATURATION) - 1 / 12)
                images.append(np.clip(np.rint(light + spread * rng.standard_normal(shape)), 0, 255).astype(np.uint8))
        taken.append(images)
    return np.array(taken)


@pytest.mark.parametrize(("mean", "modulation"), [(0.4, 0.35), (0.2, 0.15), (0.12, 0.08)])
def test_the_predicted_phase_noise_is_that_of_decoded_images(mean: float, modulation: float) -> None:
    shape = (64, 96)
    images = images_of(mean, modulation, shape, np.random.default_rng(3))
    stack = FringeStack("v", PATTERNS, EXPOSURES_US, {"left": images}, saturation=int(SATURATION))
    found = decode(stack)["left"]
    assert (found.state == PixelState.VALID).mean() > 0.99
    ramp = np.polynomial.polynomial.polyfit(np.arange(shape[1]), found.phase_rad.T, 1)
    rest = found.phase_rad - np.polynomial.polynomial.polyval(np.arange(shape[1]), ramp)
    exposures = CameraExposures(PATTERNS, EXPOSURES_US, EXPOSURES_US[0], CameraNoise(), SATURATION)
    predicted = exposures.phase_noise(np.array([mean]), np.array([modulation]))
    assert predicted.exposure[0] == 0
    # of 6000 pixels the scatter is known to 1 %; the ramp takes two of 96 degrees of freedom of each row
    assert float(rest[found.state == 0].std()) == pytest.approx(float(predicted.sigma_rad[0]), rel=0.06)
    assert float(np.median(found.sigma_rad)) == pytest.approx(float(predicted.sigma_rad[0]), rel=0.06)


def test_bright_places_use_shorter_exposures_until_all_are_saturated() -> None:
    exposures = CameraExposures(PATTERNS, EXPOSURES_US, EXPOSURES_US[0], CameraNoise(), SATURATION)
    found = exposures.phase_noise(np.array([0.4, 0.8, 3.0]), np.array([0.4, 0.7, 2.5]))
    assert found.exposure.tolist() == [0, 1, NOT_USED]
    assert np.isinf(found.sigma_rad[2])


def test_predicted_points_lie_on_the_nominal_within_their_standard_deviation() -> None:
    surface = NominalSurface(box((80.0, 60.0, 40.0)))
    rig = nominal_rig()
    plan = plan_for(rig.description, 3)
    scene = PredictedScene.of(rig, surface)
    view = scene.predict(plan[0], exposing_of(plan)(plan[0]))
    assert view is not None and view.quality.accepted
    cloud = view.cloud.seen_from(view.part_from_camera)
    points = scene.part_from_nominal.inverse().apply(cloud.points_mm)
    distances = signed_distances(points, surface)
    towards = view.part_from_camera.translation_mm - cloud.points_mm
    cosine = np.abs(np.einsum("ij,ij->i", cloud.normals, towards)) / np.linalg.norm(towards, axis=1)
    normalised = distances / (cosine * cloud.sigma_mm)
    assert 0.6 < 1.4826 * np.median(np.abs(normalised)) < 1.3  # neighbouring pixels share some noise, and sigma has a margin for blur
    assert abs(float(np.mean(distances))) < 0.02  # of pixels that cover 1 mm


def test_a_repeated_viewpoint_has_other_noise_and_the_same_one_the_same() -> None:
    rig = nominal_rig()
    plan = plan_for(rig.description, 3)
    scene, exposing = PredictedScene.of(rig, NominalSurface(box((80.0, 60.0, 40.0)))), exposing_of(plan)
    again = plan[0].model_copy(update={"id": "again"})
    first, second, other = (scene.predict(viewpoint, exposing(viewpoint)) for viewpoint in (plan[0], plan[0], again))
    assert first is not None and second is not None and other is not None
    assert np.array_equal(first.cloud.points_mm, second.cloud.points_mm)
    assert not np.array_equal(first.cloud.points_mm[:50], other.cloud.points_mm[:50])


def test_a_wall_in_the_projectors_shadow_gives_no_points() -> None:
    """A tall block stands between the head and a low one: the side of the low block that faces the head is in its shadow."""
    tall, low = box((20.0, 120.0, 120.0)), box((20.0, 40.0, 30.0), (60.0, 0.0, 0.0))
    rig = nominal_rig()
    plan = plan_for(rig.description, 3)
    still = plan[0].model_copy(update={"table_deg": 0.0})
    both = PredictedScene.of(rig, NominalSurface(joined(tall, low)))
    seen = both.look(still)[rig.description.reference]
    behind = (np.abs(seen.points_mm[:, 0] - 50.0) < 1e-6) & (seen.points_mm[:, 2] < 30.0)
    assert not seen.lit[behind].any()
    assert seen.lit.any()


def test_a_dark_part_gives_no_points_at_the_planned_exposures() -> None:
    rig = nominal_rig()
    plan = plan_for(rig.description, 3)
    scene = PredictedScene.of(rig, NominalSurface(box((80.0, 60.0, 40.0))), light=PartLight(white=0.02))
    assert scene.predict(plan[0], exposing_of(plan)(plan[0])) is None


def test_the_brightness_of_a_part_is_recovered_from_its_views() -> None:
    rig = nominal_rig()
    plan = plan_for(rig.description, 3)
    scene = PredictedScene.of(rig, NominalSurface(box((80.0, 60.0, 40.0))), light=PartLight(white=0.6))
    view = scene.predict(plan[0], exposing_of(plan)(plan[0]))
    assert view is not None
    found = light_of_views([view], rig.calibration, rig.description)
    assert found is not None and found.white == pytest.approx(0.6, rel=0.05)
    assert light_of_views([], rig.calibration, rig.description) is None
