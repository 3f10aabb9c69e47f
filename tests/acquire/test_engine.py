from dataclasses import dataclass, field

import numpy as np
import pytest

from measureapp.acquire.capture import capture_board
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import RunEnded, RunStarted, ViewpointFailed, ViewpointStarted, ViewpointStored
from measureapp.data.conditions import LensSetting
from measureapp.data.plan import ExposureBracket, FlangePose, ScanPlan, Viewpoint
from measureapp.devices.camera import GrabbedImage
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, DeviceTimeout, StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Cancelled, NoProgress
from measureapp.project.rig_file import read_rig

WIDTH, HEIGHT = 8, 6


@dataclass
class FakeProjector:
    name: str = "projector"
    width_px: int = 1024
    height_px: int = 768
    index: int = -1
    lag: int = 0  # shows the pattern before, this many times

    def load(self, images):
        self.count = len(images)

    def show(self, index, *, timeout_s):
        self.index = index

    def shown(self):
        return self.index

    def stop(self):
        self.index = -1


@dataclass
class FakeCamera:
    name: str
    projector: FakeProjector
    serial: str = "1"
    width_px: int = WIDTH
    height_px: int = HEIGHT
    bit_depth: int = 8
    exposure: int = 0
    longest_us: int = 10**9
    frames: int = 0
    level_per_us: float = 0.001

    def set_exposure_us(self, exposure_us):
        self.exposure = min(exposure_us, self.longest_us)

    def exposure_us(self):
        return self.exposure

    def grab(self, *, timeout_s):
        self.frames += 1
        shown = self.projector.index
        if self.projector.lag:
            self.projector.lag -= 1
            shown -= 1
        pixels = np.full((HEIGHT, WIDTH), min(255, int(self.exposure * self.level_per_us)), np.uint8)
        return GrabbedImage(pixels, self.frames, self.exposure, self.serial, shown)

    def temperature_c(self):
        return None

    def lens(self):
        return LensSetting()

    def stop(self):
        pass


@dataclass
class FakeAxis:
    name: str
    at: object
    stuck: bool = False
    slow: bool = False
    limits_mm: tuple = (-1e3, 1e3)
    limits_rad: tuple = (-7, 7)
    stops: int = 0

    def move_to(self, goal, *, timeout_s):
        if self.slow:
            raise DeviceTimeout(f"{self.name} did not arrive.", "Check it.")
        if not self.stuck:
            self.at = goal

    def position_mm(self):
        return self.at

    def angle_rad(self):
        return self.at

    def pose(self):
        return self.at

    def stop(self):
        self.stops += 1


@dataclass
class Memory:
    stacks: list = field(default_factory=list)
    full: bool = False
    heard: list = field(default_factory=list)  # exposures and dropped viewpoints

    def exposure_taken(self, taken):
        self.heard.append((taken.viewpoint_id, taken.level, {name: int(images[0, 0, 0]) for name, images in taken.images.items()}))

    def drop(self, viewpoint_id):
        self.heard.append((viewpoint_id, "dropped"))

    def store(self, stack):
        if self.full:
            raise StorageError("disk full.", "Free some space.")
        self.stacks.append(stack)


@pytest.fixture
def rig():
    projector = FakeProjector()
    cameras = {name: FakeCamera(name, projector) for name in ("left", "right")}
    return Rig(
        description=read_rig("paper"),
        cameras=cameras,
        projector=projector,
        robot=FakeAxis("robot", RigidTransform.identity("base", "flange")),
        guide=FakeAxis("guide", 0.0),
        table=FakeAxis("table", 0.0),
        place_on_table=lambda name: None,
    )


@pytest.fixture
def plan():
    pose = FlangePose(position_mm=(400, 0, 500), quaternion_wxyz=(1, 0, 0, 0))
    viewpoints = tuple(Viewpoint(id=f"v{i}", flange=pose, guide_mm=10.0 * i, table_deg=30.0 * i) for i in range(3))
    return ScanPlan(name="three", viewpoints=viewpoints, bracket=ExposureBracket(exposures_us=(100_000, 20_000)))


PATTERNS = np.zeros((8, 768, 1024), np.uint8)


def run(rig, plan, sink=None, progress=None, stored=()):
    events, sink = [], sink or Memory()
    try:
        Engine(rig, sink).run(plan, PATTERNS, events.append, progress or NoProgress(), stored)
    finally:
        assert isinstance(events[-1], RunEnded)
    return events, sink


def kinds(events):
    return [type(event) for event in events if type(event).__name__ != "ImageTaken"]


def test_every_viewpoint_is_taken_with_all_patterns_exposures_and_cameras(rig, plan):
    events, sink = run(rig, plan)
    assert kinds(events) == [RunStarted, *[ViewpointStarted, ViewpointStored] * 3, RunEnded]
    assert events[-1].reason == "done"
    assert [stack.viewpoint_id for stack in sink.stacks] == ["v0", "v1", "v2"]
    assert sink.stacks[0].images["left"].shape == (2, plan.patterns.count, HEIGHT, WIDTH)
    assert sink.stacks[2].readback.guide_mm == 20.0
    assert np.all(sink.stacks[0].images["right"][0] == 100)
    assert np.all(sink.stacks[0].images["right"][1] == 20)


def test_the_sink_hears_of_every_exposure_while_the_next_is_still_to_come(rig, plan):
    sink = Memory()
    taken_before = []
    genuine = sink.exposure_taken
    sink.exposure_taken = lambda taken: (taken_before.append(rig.cameras["right"].frames), genuine(taken))
    run(rig, plan, sink)
    # images of one camera, at two exposures from three viewpoints
    assert taken_before == [plan.patterns.count * number for number in range(1, 7)]
    assert sink.heard[:2] == [("v0", 0, {"left": 100, "right": 100}), ("v0", 1, {"left": 20, "right": 20})]


def test_the_sink_is_told_to_drop_a_viewpoint_that_failed_on_the_way(rig, plan):
    rig.cameras["right"].longest_us = 50_000
    _, sink = run(rig, plan)
    assert sink.heard == [(f"v{i}", "dropped") for i in range(3)]


def test_stacks_between_which_only_the_table_turned_say_so(rig, plan):
    here, there = plan.viewpoints[0].flange, FlangePose(position_mm=(400, 0, 505), quaternion_wxyz=(1, 0, 0, 0))
    places = [(here, 0.0), (here, 0.0), (there, 0.0), (here, 0.0), (here, 5.0), (here, 5.0)]
    viewpoints = tuple(Viewpoint(id=f"v{i}", flange=pose, guide_mm=slide, table_deg=30.0 * i) for i, (pose, slide) in enumerate(places))
    sink = Memory()
    engine = Engine(rig, sink)
    again = plan.model_copy(update={"viewpoints": viewpoints})
    engine.run(again, PATTERNS, lambda event: None, NoProgress())
    engine.run(again, PATTERNS, lambda event: None, NoProgress(), stored=[f"v{i}" for i in range(5)])
    approaches = [stack.approach for stack in sink.stacks]
    assert [approaches.index(approach) for approach in approaches] == [0, 0, 2, 3, 4, 4, 6]


def test_a_device_that_failed_may_have_let_the_robot_move(rig, plan):
    same = tuple(viewpoint.model_copy(update={"guide_mm": 0.0}) for viewpoint in plan)
    sink = Memory()
    genuine = rig.cameras["left"].grab

    def grab(*, timeout_s):
        if rig.table.at == pytest.approx(np.radians(30.0)):
            raise DeviceError("left is away.", "Check its cable.")
        return genuine(timeout_s=timeout_s)

    rig.cameras["left"].grab = grab
    Engine(rig, sink).run(plan.model_copy(update={"viewpoints": same}), PATTERNS, lambda event: None, NoProgress())
    assert [stack.viewpoint_id for stack in sink.stacks] == ["v0", "v2"]
    assert sink.stacks[0].approach != sink.stacks[1].approach


def test_viewpoints_on_disk_are_not_taken_again(rig, plan):
    _, sink = run(rig, plan, stored=("v0", "v1"))
    assert [stack.viewpoint_id for stack in sink.stacks] == ["v2"]


def test_an_exposure_that_a_camera_clamps_ends_the_viewpoint_before_any_image(rig, plan):
    rig.cameras["right"].longest_us = 50_000
    events, sink = run(rig, plan)
    failures = [event for event in events if isinstance(event, ViewpointFailed)]
    assert len(failures) == 3
    assert "right set 50000 µs instead of the requested 100000 µs" in failures[0].reason
    assert sink.stacks == []


def test_an_image_of_the_pattern_before_is_retaken(rig, plan):
    rig.projector.lag = 2
    events, sink = run(rig, plan)
    assert not [event for event in events if isinstance(event, ViewpointFailed)]
    assert len(sink.stacks) == 3


def test_a_projector_that_stays_late_fails_the_viewpoint_with_the_reason(rig, plan):
    rig.projector.lag = 10**6
    events, _ = run(rig, plan)
    assert "shows pattern -1, not 0" in next(event.reason for event in events if isinstance(event, ViewpointFailed))


def test_an_image_of_another_camera_is_refused(rig, plan):
    genuine = rig.cameras["left"].grab
    rig.cameras["left"].grab = lambda *, timeout_s: GrabbedImage(genuine(timeout_s=1).pixels, 1, rig.cameras["left"].exposure, "9", 0)
    events, _ = run(rig, plan)
    assert "is from camera 9, not 1" in next(event.reason for event in events if isinstance(event, ViewpointFailed))


@pytest.mark.parametrize("axis", ["robot", "guide", "table"])
def test_an_axis_that_stops_elsewhere_fails_the_viewpoint_and_never_passes_the_nominal_on(rig, plan, axis):
    getattr(rig, axis).stuck = True
    events, sink = run(rig, plan)
    assert any(isinstance(event, ViewpointFailed) and axis in event.reason for event in events)
    assert all(stack.readback.guide_mm == 10.0 * int(stack.viewpoint_id[1]) for stack in sink.stacks)


def test_an_axis_that_does_not_arrive_stops_everything(rig, plan):
    rig.guide.slow = True
    with pytest.raises(DeviceTimeout):
        run(rig, plan)
    assert rig.robot.stops == rig.guide.stops == rig.table.stops == 1


def test_a_full_disk_ends_the_run(rig, plan):
    with pytest.raises(StorageError):
        run(rig, plan, Memory(full=True))


def test_cancelling_stops_all_devices_and_says_so_last(rig, plan):
    class AfterTen:
        calls = 0

        def report(self, done, total, note=""):
            self.calls += 1
            if self.calls > 10:
                raise Cancelled

    with pytest.raises(Cancelled):
        run(rig, plan, progress=AfterTen())
    assert rig.table.stops == 1


def test_a_device_that_cannot_be_stopped_is_named(rig):
    def fail():
        raise DeviceError("no answer.", "")

    rig.guide.stop = fail
    with pytest.raises(DeviceError, match="guide: no answer"):
        rig.stop_all()
    assert rig.table.stops == 1


def test_the_board_is_taken_at_the_longest_exposure_that_does_not_saturate(rig, plan):
    for camera in rig.cameras.values():
        camera.level_per_us = 255 / 70_000
    view = capture_board(rig, plan.viewpoints[1])
    assert view.images["left"].max() == int(60_000 * 255 / 70_000)
    assert view.readback.guide_mm == 10.0
