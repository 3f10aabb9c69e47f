"""Renders fringes of both directions on a board before the virtual rig's head, and writes them as users record them."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from made_once import made_once

from measureapp.arrays import FloatArray
from measureapp.data.calibration import ProjectorCalibration
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.project.fringes.pattern_files import manifest_skeleton
from measureapp.project.rig_file import read_rig
from measureapp.simulate.optics import ProjectorLight, SeeingCamera, expose, project_images
from measureapp.simulate.options import LightSettings, RigErrors
from measureapp.simulate.printed_board import PrintedBoard
from measureapp.simulate.sensor import SensorSettings, read_out
from measureapp.simulate.truth import Truth, draw_truth
from measureapp.simulate.world import PAPER_BOARD

PATTERNS = PATTERN_SETS["three-close-both"]
EXPOSURE_US = 60_000
SEED, POSITIONS = 1, 6
BOARD = ("--board", "14x11", "--square-mm", "15")
RIG = read_rig("paper").at_resolution("quarter")


def true_head(seed: int) -> Truth:
    """Draw a rig; its cameras, projector and their places are the truth to find."""
    return draw_truth(RIG, PAPER_BOARD, RigErrors(), seed)


def board_poses(truth: Truth, count: int, generator: np.random.Generator) -> list[RigidTransform]:
    """Draw places of the board in the light of the projector, tilted by 15° to 40°."""
    light = truth.camera_from_projector
    poses = []
    for number in range(count):
        azimuth = 2.4 * number + generator.uniform(-0.3, 0.3)
        tilt = np.deg2rad(generator.uniform(15, 40))
        turn = (
            light.rotation
            @ rotation_about([np.cos(azimuth), np.sin(azimuth), 0], tilt)
            @ rotation_about([0, 0, 1], generator.uniform(-0.4, 0.4))
        )
        centre = light.apply(np.array([[*generator.uniform(-25, 25, 2), RIG.standoff_mm + generator.uniform(-50, 50)]]))[0]
        poses.append(RigidTransform.from_parts(turn, centre - turn @ PAPER_BOARD.middle_mm, "camera", "board"))
    return poses


def write_stacks(folder: Path, truth: Truth, poses: list[RigidTransform], cameras: tuple[str, ...] = ("left", "right")) -> list[Path]:
    """Write one folder of images with its MANIFEST.toml per pose; return the manifests."""
    shown = project_images(pattern_images(PATTERNS, RIG.projector.width_px, RIG.projector.height_px), LightSettings())
    printed = PrintedBoard(PAPER_BOARD, 0.0)
    manifests = []
    for number, pose in enumerate(poses):
        place = folder / f"position{number:02d}"
        lights = ProjectorLight(truth.projector, pose.inverse() @ truth.camera_from_projector, RIG.standoff_mm)
        for name in cameras:
            camera = truth.calibration.cameras.cameras[name]
            light = np.empty((camera.pinhole.height_px, camera.pinhole.width_px, 4), np.float32)
            printed.illuminate(SeeingCamera(camera.pinhole), pose.inverse() @ camera.reference_from_camera, lights, light)
            images = place / name / str(EXPOSURE_US)
            images.mkdir(parents=True)
            for pattern, lit in enumerate(shown):
                seen = read_out(expose(light, lit, EXPOSURE_US, LightSettings()), 8, SensorSettings(), 1000 * number + pattern + len(name))
                cv2.imwrite(str(images / f"{pattern:03d}.png"), seen)
        manifests.append(place / "MANIFEST.toml")
        manifests[-1].write_text(manifest_skeleton(PATTERNS, cameras, (EXPOSURE_US,)))
    return manifests


def shared_stacks(factory: pytest.TempPathFactory) -> list[Path]:
    """Return the manifests of `POSITIONS` positions before the head of `SEED`, which all processes of a run share."""

    def write(folder: Path) -> None:
        truth = true_head(SEED)
        write_stacks(folder, truth, board_poses(truth, POSITIONS, np.random.default_rng(SEED)))

    return sorted(made_once(factory, "board_fringes", write).glob("*/MANIFEST.toml"))


def in_sigmas(truth: Truth, projector: ProjectorCalibration) -> FloatArray:
    """Errors of lens and place over their stated standard deviations."""
    matrix = projector.pinhole.matrix - truth.projector.matrix
    errors = {"fx": matrix[0, 0], "fy": matrix[1, 1], "cx": matrix[0, 2], "cy": matrix[1, 2]}
    errors |= dict(zip(("k1", "k2", "p1", "p2", "k3"), projector.pinhole.distortion - truth.projector.distortion, strict=True))
    shift = projector.reference_from_projector.translation_mm - truth.camera_from_projector.translation_mm
    errors |= dict(zip(("x_mm", "y_mm", "z_mm"), shift, strict=True))
    return np.array([error / projector.standard_deviations[name] for name, error in errors.items()])
