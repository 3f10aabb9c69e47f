"""Second light has the strength of its form factors, is the same for all cameras on matt surfaces, and averages fine fringes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import dblquad

from measureapp.data.mesh import Mesh
from measureapp.data.rig import RigDescription
from measureapp.simulate.effects.bounce import Cells, Places, form_factors
from measureapp.simulate.options import PartEffects, WorldOptions
from measureapp.simulate.part import MATT_WHITE, Part
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import PLAIN_LIGHT, World

EXPOSURE_US = 60_000


def corner(albedo: float) -> Part:
    """Two walls at a right angle, open towards the head."""
    corners = [[0, -50, 0], [0, 50, 0], [0, 50, 100], [0, -50, 100], [-100, -50, 0], [-100, 50, 0]]
    mesh = Mesh(np.array(corners, float), np.array([[0, 2, 1], [0, 3, 2], [4, 0, 1], [4, 1, 5]]), "nominal")
    return Part("corner", mesh, (replace(MATT_WHITE, albedo=albedo),), np.zeros(4, np.uint8), watertight=False)


@pytest.fixture
def second_light(paper: RigDescription, look_from: Callable[..., None], ideal: WorldOptions) -> Callable[..., np.ndarray]:
    """Return the image of a camera without second light and what that adds, (2, H, W)."""

    def seen(
        part: Part, camera: str = "left", pattern: np.ndarray | None = None, strengths: tuple[float, float] = (0.0, 1.0)
    ) -> np.ndarray:
        images = []
        for strength in (0.0, 1.0):
            world = World(paper, part, 1, options=ideal.model_copy(update={"part": PartEffects(bounce=strength)}))
            world.table_holds = "part"
            look_from(world, 5.0, 40.0)
            if pattern is not None:
                world.load_patterns(pattern[None])
            world.show(PLAIN_LIGHT if pattern is None else 0)
            images.append(world.mean_image(camera, EXPOSURE_US))
        return np.stack([images[0], images[1] - images[0]])

    return seen


def test_the_light_between_two_walls_is_that_of_the_integral_over_the_sender() -> None:
    """A wall of 40 x 40 mm in cells of 2 mm beside places at a right angle to it, at 3 to 50 mm."""
    y, z = (index.ravel() * 2.0 + 1.0 for index in np.indices((20, 20)))
    wall = Places(np.column_stack([0 * y, y, z]), np.tile([1.0, 0.0, 0.0], (400, 1)), np.tile([1.0, 0.0, 1.0], (400, 1)))
    cells = Cells((20, 20), (20, 20), y.astype(int) // 2, z.astype(int) // 2, wall, np.full(400, 4.0), np.ones(400))
    distance = np.array([3.0, 10.0, 50.0])
    floor = Places(np.column_stack([distance, [20.0] * 3, [0.0] * 3]), np.tile([0.0, 0.0, 1.0], (3, 1)), np.tile([1.0, 0.0, 1.0], (3, 1)))
    received = form_factors(floor, cells, lambda rays: np.zeros(len(rays), bool)).sum(axis=1)
    whole = [dblquad(lambda y, z, x=x: x * z / (np.pi * (x * x + (y - 20) ** 2 + z * z) ** 2), 0, 40, 0, 40)[0] for x in distance]
    np.testing.assert_allclose(received, whole, rtol=0.03)
    hidden = form_factors(floor, cells, lambda rays: np.ones(len(rays), bool))
    assert not hidden.any()


def test_walls_of_a_corner_light_each_other_by_the_square_of_their_albedo(second_light: Callable[..., np.ndarray]) -> None:
    added = {}
    for albedo in (0.8, 0.4):
        without, gain = second_light(corner(albedo))
        assert gain.min() > -1e-4
        added[albedo] = gain[without > 0.02].mean()
    bare, more = second_light(make_part("flat"))
    assert added[0.8] == pytest.approx(4 * added[0.4], rel=0.05)
    assert added[0.8] > 0.05 * 0.8 * bare.max()
    assert np.abs(more)[bare > 0.02].mean() < 0.01 * added[0.8]


def test_matt_walls_have_the_same_second_light_in_every_camera(
    second_light: Callable[..., np.ndarray], paper: RigDescription, look_from: Callable[..., None], ideal: WorldOptions
) -> None:
    """Up to a corner: whatever the cameras' pixels, the light that a pixel of the projector's image shows is one."""
    part = corner(0.8)
    columns = np.arange(paper.projector.width_px)
    fringes = np.tile(np.uint8(np.round(127.5 + 127.5 * np.cos(2 * np.pi * columns / 32))), (paper.projector.height_px, 1))
    world = World(paper, part, 1, options=ideal)
    world.table_holds = "part"
    look_from(world, 5.0, 40.0)
    by_place = []
    for camera in ("left", "upper"):
        pixels = np.round(world.true_light(camera)[..., :2] / 4.0).astype(int)
        lit = np.all((pixels > 0) & (pixels < 190), axis=-1)
        sums, counts = np.zeros((2, 200 * 200))
        flat = pixels[lit] @ [200, 1]
        np.add.at(sums, flat, second_light(part, camera, fringes)[1][lit])
        np.add.at(counts, flat, 1.0)
        by_place.append(np.where(counts > 0, sums / np.maximum(counts, 1.0), np.nan))
    both = np.isfinite(by_place[0]) & np.isfinite(by_place[1])
    assert np.count_nonzero(both) > 2000
    difference = (by_place[0] - by_place[1])[both]
    assert np.percentile(np.abs(difference), 99) < 0.03 * np.max(by_place[0][both])


def test_fringes_finer_than_the_cells_leave_an_even_second_light(second_light: Callable[..., np.ndarray], paper: RigDescription) -> None:
    """Of a pattern with two pixels a period and of one of half the light everywhere, walls send the same."""
    fine = np.tile(np.uint8(np.arange(paper.projector.width_px) % 2 * 255), (paper.projector.height_px, 1))
    grey = np.full_like(fine, 128)
    _, of_fine = second_light(corner(0.8), pattern=fine)
    _, of_grey = second_light(corner(0.8), pattern=grey)
    assert np.abs(of_fine - of_grey).max() < 0.02 * of_grey.max()


def test_second_light_falls_into_shadows(
    second_light: Callable[..., np.ndarray], paper: RigDescription, look_from: Callable[..., None]
) -> None:
    part = make_part("gypsum")
    world = World(paper, part, 1, options=WorldOptions())
    world.table_holds = "part"
    look_from(world, 5.0, 40.0)
    light = world.true_light("upper")
    shadow = (light[..., 0] < 0) & (light[..., 3] > 0)
    white = np.full((paper.projector.height_px, paper.projector.width_px), 255, np.uint8)
    gain = second_light(part, "upper", white)[1]
    assert np.count_nonzero(shadow) > 300
    assert gain[shadow].max() > 0.02 * gain.max() > 0.0


def test_second_light_on_gloss_is_another_one_for_every_camera(second_light: Callable[..., np.ndarray]) -> None:
    """Two walls of a corner: what the glossy one adds is brighter, and its ratio between two cameras is not that of matt walls."""
    matt, glossy = corner(0.5), corner(0.5)
    glossy = replace(glossy, materials=(replace(glossy.materials[0], gloss=3.0, sharpness=15.0),))
    added = {}
    for name, part in (("matt", matt), ("glossy", glossy)):
        for camera in ("left", "upper"):
            without, gain = second_light(part, camera)
            added[name, camera] = float(gain[without > 0.02].mean())
    assert added["glossy", "left"] > 1.2 * added["matt", "left"]
    ratios = [added[name, "left"] / added[name, "upper"] for name in ("matt", "glossy")]
    assert abs(ratios[1] / ratios[0] - 1.0) > 0.05
