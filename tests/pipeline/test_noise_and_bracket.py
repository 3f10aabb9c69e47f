"""A rig measures its cameras' noise and chooses its exposures; the simulated world knows what is true."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.acquire.engine import run_once
from measureapp.acquire.session import RigSession
from measureapp.acquire.tasks.fringes import FringeTask
from measureapp.acquire.tasks.probe import ProbeTask
from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.data.plan import Viewpoint
from measureapp.devices.connect import connect_rig
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.exposures.bracket import BracketLimits
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.bracket import propose_bracket
from measureapp.pipeline.noise import describe_noise, measure_noise
from measureapp.planning.viewpoints import LookAt, viewpoint_looking_at
from measureapp.progress import NoProgress
from measureapp.project.rig_file import read_rig

PATTERNS = PatternSet(name="3", projector_px=1024, groups=tuple(PhaseShiftGroup(pitch_px=pitch) for pitch in (16, 17.5, 19.5)))


def rig_with(part: str, world: dict[str, object] | None = None) -> tuple[Rig, Viewpoint]:
    """A small virtual rig that looks at a part, and from where."""
    description = read_rig("paper").at_resolution("quarter")
    rig: Rig = connect_rig(description.model_copy(update={"driver_settings": {"part": part, "seed": 3, "world": world or {}}}))
    rig.place_on_table("part")
    target = np.add(description.table.centre_in_guide_mm, [0.0, 0.0, 30.0])
    return rig, viewpoint_looking_at(description, "view", target, LookAt(10.0, 50.0, description.standoff_mm), guide_mm=0.0, table_deg=0.0)


def test_the_noise_of_a_project_is_that_of_its_fringe_images_where_they_show_it(demo: Demo) -> None:
    measurement = demo.project.measurement()
    assert measurement is not None
    shown = {"full_well_e": 9000.0, "read_noise_e": 3.04, "from_images": True}
    coarse = {**shown, "read_noise_e": 0.0}
    decoded = {"left": {"noise": shown}, "right": {"noise": coarse}, "upper": {"noise": {**shown, "from_images": False}}}
    assert describe_noise(demo.project, [replace(measurement.views[0], decode=decoded)]) == {
        "left": "from the fringe images: full well 9000 e, read noise 3.0 e",
        "right": "from the fringe images: full well 9000 e, read noise less than their grey levels show",
        "upper": "assumed: full well 6000 e, read noise 7.0 e",
    }


def test_the_noise_of_the_virtual_cameras_is_found() -> None:
    rig, view = rig_with("gypsum", {"sensor": {"full_well_e": 9000.0, "read_noise_e": 25.0}})
    found = measure_noise(rig, view, repeats=4)
    assert set(found) == set(rig.cameras)
    for estimate in found.values():
        assert estimate.accepted, estimate.verdict
        assert estimate.noise.full_well_e == pytest.approx(9000, rel=0.04)
        assert abs(estimate.noise.full_well_e - 9000) < 5 * estimate.full_well_sd_e
        assert abs(estimate.noise.read_noise_e - 25) < 5 * estimate.read_noise_sd_e
        assert estimate.read_noise_sd_e < 8


def test_a_rig_that_sees_nothing_says_so() -> None:
    rig, view = rig_with("gypsum")
    rig.place_on_table("empty")
    with pytest.raises(CalibrationError, match=r"The image of camera 'left' is dark at \d+ µs"):
        measure_noise(rig, view)
    with pytest.raises(DecodeError, match="No camera sees fringes"):
        propose_bracket(rig, PATTERNS, BracketLimits(4.0), view)


def test_a_camera_saturated_at_every_exposure_is_named() -> None:
    rig, view = rig_with("flat", {"light": {"lamp": 1e6}})
    with pytest.raises(CalibrationError, match="is saturated even at"):
        measure_noise(rig, view)


def test_the_bracket_a_rig_proposes_gives_what_it_promises() -> None:
    rig, view = rig_with("impeller")
    found = propose_bracket(rig, PATTERNS, BracketLimits(4.8), view)
    assert found.figures.time_s <= 4.8
    assert set(found.compared) == {"paper", "rig"}
    assert found.figures.exposures_us == found.exposures_us
    shares = []
    for figures in (found.figures, found.compared["rig"]):
        observed, sigma = taken(rig, view, figures.exposures_us)
        predicted = np.mean(list(figures.decodable.values()))
        assert observed == pytest.approx(predicted, abs=0.06)
        assert sigma == pytest.approx(figures.median_sigma_rad, rel=0.15)
        shares.append(observed)
    better, usual = shares
    assert better > usual - 0.005


class Kept:
    """A sink that keeps the stacks of a scan."""

    def __init__(self) -> None:
        self.stacks: list[FringeStack] = []

    def exposure_taken(self, taken: object) -> None:
        pass

    def drop(self, viewpoint_id: str) -> None:
        pass

    def store(self, stack: FringeStack) -> None:
        self.stacks.append(stack)


def taken(rig: Rig, view: Viewpoint, exposures: tuple[int, ...]) -> tuple[float, float]:
    """Decode a bracket that is really taken: share of the lit pixels that are valid, and median noise."""
    sink = Kept()
    run_once(rig, "bracket", view, FringeTask(PATTERNS, exposures, pattern_images(PATTERNS, 1024, 768), sink), NoProgress())
    maps = decode(sink.stacks[0], DecodeSettings(vote_radius=0, edge_step_rad=1e6))
    shares, sigmas = [], []
    for name, phase_map in maps.items():
        lit = lit_pixels(rig, name)
        shares.append(float(phase_map.valid[lit].mean()))
        sigmas.append(float(np.median(phase_map.sigma_rad[phase_map.valid])))
    return float(np.mean(shares)), float(np.mean(sigmas))


def lit_pixels(rig: Rig, name: str) -> np.ndarray:
    """Pixels in which two opposite steps differ clearly at a long exposure, or that are saturated in both."""
    with RigSession(rig) as session:
        images = [shot.frames[name].pixels.astype(int) for shot in session.shots(range(4), (100_000,), (name,))]
    high, low = np.max(images, axis=0), np.min(images, axis=0)
    return np.asarray((high - low > 6) | (low >= 255))


def test_the_probe_takes_only_the_finest_pitch_at_two_exposures() -> None:
    rig, view = rig_with("flat")
    patterns = PATTERNS.model_copy(update={"groups": PATTERNS.groups[::-1]})
    propose_bracket(rig, patterns, BracketLimits(4.8, 2, multiple_us=10_000), view)
    stacks: list[FringeStack] = []
    run_once(rig, "probe", None, ProbeTask(patterns, pattern_images(patterns, 1024, 768), stacks.append), NoProgress())
    (stack,) = stacks
    assert stack.exposures_us == (100_000, 12_500)
    assert stack.patterns.pitches_px == (16,)
    assert {images.shape[:2] for images in stack.images.values()} == {(2, 4)}
