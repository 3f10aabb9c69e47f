"""A rig of fakes whose images have real fringes, with faults that can be injected into every device, and the truth of every image."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from measureapp.data.cell import CellDescription
from measureapp.data.conditions import LensSetting
from measureapp.data.fringe import FringeStack
from measureapp.data.plan import ExposureBracket, FlangePose, ScanPlan, Viewpoint
from measureapp.devices.camera import Frame, StreamStatistics
from measureapp.devices.rig import Rig
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceLost, DeviceTimeout, FrameError
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Cancelled
from measureapp.project.rig_file import read_rig

DEEP_FLOOR = CellDescription(floor_mm=-2000.0)  # the flange starts at the origin of the base, where no arm could be

WIDTH, HEIGHT, SIGMA = 96, 64, 1.0
FULL_LIGHT_US = 120_000.0  # exposure at which white on albedo 1 saturates
COLUMNS = np.linspace(100, 700, WIDTH).astype(int)  # of the projector, seen by the pixels of a row
Fault = Callable[[str, int], str]  # device, number of its call -> name of a fault, or ""


def no_fault(device: str, call: int) -> str:
    return ""


@lru_cache(maxsize=8)
def albedo(place: float) -> np.ndarray:
    """What the part looks like from a place, (H, W)."""
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    return 0.55 + 0.4 * np.sin(0.11 * x + 0.07 * y + place) * np.cos(0.05 * y - place)


@dataclass
class Cell:
    """What is really where."""

    fault: Fault = no_fault
    robot: RigidTransform = field(default_factory=lambda: RigidTransform.identity("base", "flange"))
    guide_mm: float = 0.0
    table_rad: float = 0.0
    patterns: np.ndarray = field(default_factory=lambda: np.zeros((0, 768, 1024), np.uint8))
    shown: int = -2
    random: np.random.Generator = field(default_factory=lambda: np.random.default_rng(7))
    moves: int = 0

    def mean(self, camera: str, exposure_us: int, pattern: int) -> np.ndarray:
        """Return the noise-free image of a pattern here and now, (H, W)."""
        place = self.robot.translation_mm.sum() * 0.031 + self.guide_mm * 0.17 + self.table_rad * 2.3 + len(camera)
        light = 0.6 if pattern == -1 else 0.0 if pattern < 0 else 0.1 + 0.8 * self.patterns[pattern, 300, COLUMNS] / 255.0
        return np.minimum(255.0, 255.0 * exposure_us / FULL_LIGHT_US * albedo(place) * light)

    def image(self, camera: str, exposure_us: int, pattern: int) -> np.ndarray:
        noisy = self.mean(camera, exposure_us, pattern) + self.random.normal(0.0, SIGMA, (HEIGHT, WIDTH))
        return np.clip(np.rint(noisy), 0, 255).astype(np.uint8)


class FakeDevice:
    def __init__(self, name: str, cell: Cell) -> None:
        self.name, self.cell = name, cell
        self.calls = self.stops = 0
        self.stopped = threading.Event()

    def fault(self) -> str:
        """The fault of this call; those that every device can have happen here."""
        self.calls += 1
        fault = self.cell.fault(self.name, self.calls)
        if fault == "oserror":
            raise OSError(f"{self.name}: connection reset")
        if fault == "lost":
            raise DeviceLost(f"{self.name} is gone.", "Connect it.")
        if fault == "interrupt":
            raise KeyboardInterrupt
        if fault == "blocked":
            self.stopped.clear()
            self.stopped.wait()
            raise Cancelled
        return fault

    def status(self) -> DeviceStatus:
        return DeviceStatus(True, "ready")

    def stop(self) -> None:
        self.stops += 1
        self.stopped.set()

    def close(self) -> None:
        self.stopped.set()


class FakeProjector(FakeDevice):
    width_px, height_px, frame_us = 1024, 768, 0

    def load(self, images: np.ndarray) -> None:
        self.cell.patterns = images

    def show(self, index: int, *, timeout_s: float) -> None:
        fault = self.fault() if index != -2 else ""
        if fault != "late":
            self.cell.shown = index

    def shown(self) -> int:
        return self.cell.shown

    def stop(self) -> None:
        super().stop()
        self.cell.shown = -2


class FakeCamera(FakeDevice):
    width_px, height_px, bit_depth = WIDTH, HEIGHT, 8
    shutter, readout_s, transfer_s = "global", 0.0, 0.0
    exposure_limits_us, exposure_step_us = (1, 10**9), 1

    def __init__(self, name: str, cell: Cell, serial: str) -> None:
        super().__init__(name, cell)
        self.serial, self.longest_us = serial, 10**9
        self.exposure, self.number = 0, 0
        self.frames: deque[Frame | FrameError] = deque()
        self.last = np.zeros((HEIGHT, WIDTH), np.uint8)
        self.history: deque[np.ndarray] = deque(maxlen=36)  # of one viewpoint

    def set_exposure_us(self, exposure_us: int) -> None:
        self.exposure = min(exposure_us, self.longest_us)

    def exposure_us(self) -> int:
        return self.exposure

    def arm(self, frames: int, trigger: str) -> None:
        self.frames.clear()
        self.number = 0

    def trigger(self) -> None:
        fault = self.fault()
        pixels = self.disturbed(fault)
        frame = Frame(
            pixels,
            "stranger" if fault == "serial" else self.serial,
            self.number,
            self.exposure // 2 if fault == "read-back" else self.exposure,
        )
        self.history.append(pixels)
        self.last = pixels
        self.number += 1
        if fault == "failed":
            self.frames.append(FrameError(f"Camera {self.name}: the buffer is incomplete.", "Check the link."))
        elif fault != "missing":
            self.frames.extend([frame, frame] if fault == "double" else [frame])

    def disturbed(self, fault: str) -> np.ndarray:
        pixels = self.cell.image(self.name, self.exposure, self.cell.shown)
        match fault:
            case "stale":
                return self.last.copy()
            case "earlier":
                return self.history[0].copy() if self.history else pixels
            case "half exposed":
                return self.cell.image(self.name, self.exposure // 2, self.cell.shown)
            case "torn":
                return np.where(np.arange(HEIGHT)[:, None] < HEIGHT // 2, pixels, 0).astype(np.uint8)
            case "wrapped":
                return (pixels.astype(int) * 16 % 256).astype(np.uint8)
            case "lamp":
                return (pixels * 0.8).astype(np.uint8)
            case "no rows":
                return pixels[:0]
        return pixels

    def wait_ready(self, *, timeout_s: float) -> None:
        pass

    def next_frame(self, *, timeout_s: float) -> Frame:
        if not self.frames:
            raise DeviceTimeout(f"Camera {self.name} delivered no image.", "Check its trigger line.")
        frame = self.frames.popleft()
        if isinstance(frame, FrameError):
            raise frame
        return frame

    def disarm(self) -> None:
        self.frames.clear()

    def statistics(self) -> StreamStatistics:
        return StreamStatistics()

    def temperature_c(self) -> None:
        return None

    def lens(self) -> LensSetting:
        return LensSetting()


class FakeAxis(FakeDevice):
    """Robot, guide or table; ``place`` names what it moves in the cell."""

    limits_mm, limits_rad = (-1e3, 1e3), (-7.0, 7.0)

    def __init__(self, name: str, cell: Cell, place: str, step: Callable[[object], object]) -> None:
        super().__init__(name, cell)
        self.place, self.step = place, step
        self.reads = 0

    def move_to(self, goal: object, *, timeout_s: float) -> None:
        fault = self.fault()
        if fault == "timeout":
            raise DeviceTimeout(f"{self.name} did not arrive.", "Check it.")
        if fault == "stuck":
            return
        self.cell.moves += 1
        setattr(self.cell, self.place, self.step(goal) if fault == "off" else goal)

    def read(self) -> object:
        self.reads += 1
        if self.cell.fault(f"{self.name} read", self.reads) == "creep":
            setattr(self.cell, self.place, self.step(getattr(self.cell, self.place)))
        if self.cell.fault(f"{self.name} read", self.reads) == "nan":
            return self.step(None)
        return getattr(self.cell, self.place)

    pose = position_mm = angle_rad = read

    def home(self, *, timeout_s: float) -> None:
        pass


def _pushed(pose: RigidTransform | None) -> RigidTransform:
    if pose is None:
        return RigidTransform.from_parts(np.eye(3), (np.nan, 0.0, 0.0), "base", "flange")
    turn = RigidTransform.from_parts(
        np.array([[np.cos(0.01), -np.sin(0.01), 0], [np.sin(0.01), np.cos(0.01), 0], [0, 0, 1]]), (0, 0, 0), "flange", "flange"
    )
    return pose @ turn


def fake_rig(cell: Cell) -> Rig:
    cameras = {name: FakeCamera(name, cell, str(number)) for number, name in enumerate(("left", "right"))}
    return Rig(
        description=read_rig("paper").model_copy(update={"exposures_us": (100_000, 80_000, 60_000, 40_000, 20_000), "cell": DEEP_FLOOR}),
        cameras=cameras,
        projector=FakeProjector("projector", cell),
        robot=FakeAxis("robot", cell, "robot", _pushed),
        guide=FakeAxis("guide", cell, "guide_mm", lambda at: float("nan") if at is None else at + 0.5),
        table=FakeAxis("table", cell, "table_rad", lambda at: float("nan") if at is None else at + 0.01),
        place_on_table=lambda name: None,
    )


def fake_plan(count: int = 3, exposures_us: tuple[int, ...] = (100_000, 50_000, 25_000)) -> ScanPlan:
    pose = FlangePose(position_mm=(400, 0, 500), quaternion_wxyz=(1, 0, 0, 0))
    viewpoints = tuple(Viewpoint(id=f"v{i}", flange=pose, guide_mm=10.0 * (i % 40), table_deg=17.0 * (i % 20)) for i in range(count))
    return ScanPlan(name="plan", viewpoints=viewpoints, bracket=ExposureBracket(exposures_us=exposures_us))


def drawn(plan: ScanPlan) -> np.ndarray:
    return pattern_images(plan.patterns, 1024, 768)


@contextmanager
def released(rig: Rig) -> Iterator[Rig]:
    """Let calls that still block end with the test."""
    try:
        yield rig
    finally:
        rig.close()


@dataclass
class Truthful:
    """A sink that compares every stored image with what the cell really showed then."""

    cell: Cell
    stacks: list[FringeStack] = field(default_factory=list)
    dropped: list[str] = field(default_factory=list)
    exposures: list[tuple[str, int]] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)
    keep: bool = True

    def exposure_taken(self, taken) -> None:
        self.exposures.append((taken.viewpoint_id, taken.level))

    def drop(self, viewpoint_id: str) -> None:
        self.dropped.append(viewpoint_id)

    def store(self, stack: FringeStack) -> None:
        for camera, images in stack.images.items():
            for level, exposure_us in enumerate(stack.exposures_us):
                for pattern in range(stack.patterns.count):
                    off = np.abs(images[level, pattern] - self.cell.mean(camera, exposure_us, pattern))
                    if (off > 6 * SIGMA + 1).mean() > 0.001:
                        self.wrong.append(f"{stack.viewpoint_id} {camera} {exposure_us} {pattern}")
        at = stack.readback
        if at.guide_mm != self.cell.guide_mm or at.table_rad != self.cell.table_rad or at.base_from_flange != self.cell.robot:
            self.wrong.append(f"{stack.viewpoint_id}: read-back")
        self.stacks.append(stack if self.keep else stack.viewpoint_id)
