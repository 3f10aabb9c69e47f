"""The chain of the rig: its derivatives are those of differences, at any state."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.chain import Chain, Free
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.error_motions import MotionModel
from measureapp.calibrate.poses import apply_changes

AXES = np.array([[0.0, 0.6, 0.8], [1.0, 0.0, 0.0], [0.0, 0.8, -0.6]])
MOTIONS = MotionModel(np.array([310.0, 25.0, 90.0]), AXES, np.array([-100.0, 900.0]), np.full(11, 0.01))
SIGHTINGS, ROBOT_POSES, ANGLES, CAMERAS = 12, 4, 3, 5
STEP = 1e-5  # mm and rad: the differences are exact to some 1e-7 of rows of up to 1e3


def poses(generator, count, turn=1.0, shift=400.0):
    return apply_changes(np.tile(np.eye(4), (count, 1, 1)), generator.normal(size=(count, 6)) * [*[turn] * 3, *[shift] * 3])


def unit(vector):
    return vector / np.linalg.norm(vector)


@pytest.fixture
def state(generator):
    return ChainState(
        flange_from_camera=poses(generator, 1)[0],
        guide_direction=unit(np.array([0.02, 1.0, -0.03])),
        guide_scale=1.001,
        axis_point_mm=np.array([300.0, 20.0, 0.0]),
        axis_direction=unit(np.array([0.05, -0.02, 1.0])),
        guide_from_board=poses(generator, 1)[0],
        robot_changes=generator.normal(scale=0.2, size=(ROBOT_POSES, 6)),  # far larger than any robot errs
        table_changes=generator.normal(scale=0.1, size=ANGLES),
        camera_changes=generator.normal(scale=1e-3, size=CAMERAS),
        motions=generator.normal(scale=0.02, size=MOTIONS.size),  # likewise
    )


@pytest.fixture
def chain(generator, state):
    ideal = Chain(
        base_from_flange=poses(generator, SIGHTINGS),
        guide_mm=generator.uniform(0, 900, SIGHTINGS),
        table_rad=generator.uniform(-3, 3, SIGHTINGS),
        camera_from_board=np.tile(np.eye(4), (SIGHTINGS, 1, 1)),
        roots=np.triu(generator.normal(size=(SIGHTINGS, 6, 6))) + 3 * np.eye(6),
        robot_group=np.arange(SIGHTINGS) % ROBOT_POSES,
        table_group=np.arange(SIGHTINGS) % ANGLES,
        noise=AxisNoise(),
        free=Free(),
        camera_jacobian=generator.normal(size=(SIGHTINGS, 6, CAMERAS)),
        camera_covariance=np.eye(CAMERAS),
        motions=MOTIONS,
    )
    observed = apply_changes(ideal.predict(state), generator.normal(scale=0.1, size=(SIGHTINGS, 6)))
    return replace(ideal, camera_from_board=observed)


@pytest.mark.parametrize("free", [Free(), Free(guide=False, axis=False), Free(hand_eye=False), Free(axis=False)], ids=str)
def test_the_derivatives_of_the_chain_are_those_of_differences(chain, state, free):
    chain = replace(chain, free=free)
    if not free.axis:
        state = replace(state, table_changes=np.zeros(0))
    columns = [
        (chain.residuals(chain.apply_step(state, shift)) - chain.residuals(chain.apply_step(state, -shift))) / (2 * STEP)
        for shift in STEP * np.eye(chain.size)
    ]
    by_differences = np.array(columns).T
    np.testing.assert_allclose(chain.jacobian(state), by_differences, atol=1e-7 * np.abs(by_differences).max())
