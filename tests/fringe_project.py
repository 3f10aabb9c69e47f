"""A project with the images of small shiny surfaces, for tests that look at images, exposures and phases."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from measureapp.data.fringe import AxisReadback, FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.data.project_settings import ProjectSettings
from measureapp.geometry.transform import RigidTransform
from measureapp.project.folder import ProjectFolder
from measureapp.project.rig_file import read_rig
from tests.fringe.conftest import images_of, ramp

EXPOSURES_US = (80_000, 20_000, 5_000)
CAMERAS = ("left", "right")
HEIGHT, WIDTH = 60, 400
READBACK = AxisReadback(RigidTransform.identity("base", "flange"), 0.0, 0.0)


@cache
def shiny_stack(name: str = "view01") -> FringeStack:
    """Fringes on a surface that is dark at its top and saturates the longer exposures below; the right camera sees half of the light."""
    brightness = np.geomspace(0.15, 12.0, HEIGHT)[:, None] * np.ones((1, WIDTH))
    images = {}
    for number, camera in enumerate(CAMERAS):
        light = brightness / (1 + number)
        made = images_of(ramp(HEIGHT, WIDTH), PAPER_PATTERNS, EXPOSURES_US, 110.0 * light, 80.0 * light, seed=3 + number)
        made.flags.writeable = False
        images[camera] = made
    return FringeStack(name, PAPER_PATTERNS, EXPOSURES_US, images, 255, READBACK)


def fringe_project(folder: Path, *names: str) -> ProjectFolder:
    """A project with the images of these viewpoints."""
    project = ProjectFolder.create(folder, ProjectSettings(name="shiny", part="gear", rig=read_rig("paper")))
    for name in names:
        project.frames.store(shiny_stack(name))
    return project


def valid_in_each(stack: FringeStack, camera: str) -> np.ndarray:
    """Mask (exposures, H, W) of pixels that are above zero and unsaturated in all images of an exposure, straight from the images."""
    images = stack.images[camera]
    return ((images > 0) & (images < stack.saturation)).all(axis=1)
