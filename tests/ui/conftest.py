"""A measurement made by hand, and a window to show it in."""

from __future__ import annotations

import os

os.environ["QT_QPA_PLATFORM"] = "offscreen"
os.environ.pop("DISPLAY", None)

import threading
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from shiboken6 import delete, isValid

from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    Provenance,
    RigCalibration,
    RotationAxis,
)
from measureapp.data.cloud import CloudQuality, PointCloud, StitchedCloud, ViewPlacement
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.feature import Feature
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import Alignment, Inspection, Measurement, ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from tests.ui.heartbeat import Heartbeat
from ui.app import Application, build

VIEWS = 6


def sphere_points(count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    normals = rng.normal(size=(count, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return normals * 60.0 + [0, 0, 60.0], normals


def make_view(index: int) -> ViewResult:
    points, normals = sphere_points(2000, index)
    angle = 2 * np.pi * index / VIEWS
    seen = normals @ [np.cos(angle), np.sin(angle), 0.3] > 0.1
    points, normals = points[seen], normals[seen]
    count = len(points)
    part_from_camera = RigidTransform.from_vector([0, 0, angle], [200, 0, 300], "part", "camera")
    camera_points = part_from_camera.inverse().apply(points)
    cloud = PointCloud(
        camera_points,
        part_from_camera.inverse().rotate(normals),
        np.full(count, 0.012 + 0.004 * index),
        np.linspace(0.1, 0.9, count),
        np.full((count, 2), -1),
        np.full(count, 3),
        "camera",
        f"view-{index + 1:02d}",
    )
    accepted = index != 4
    quality = CloudQuality(count, 3.2, 0.018, 0.004, 0.93, accepted, "" if accepted else "point noise of 0.310 mm")
    readback = AxisReadback(RigidTransform.identity("base", "flange"), 0.0, angle)
    return ViewResult(cloud.viewpoint_id, cloud, quality, part_from_camera, {}, (), {"behind the table": 120}, readback)


@pytest.fixture
def calibration() -> RigCalibration:
    def camera(name: str, x: float) -> CameraCalibration:
        pinhole = PinholeCamera(1296, 972, np.array([[2045.3, 0, 648.2], [0, 2046.1, 486.4], [0, 0, 1]]), np.zeros(5))
        pose = RigidTransform.from_vector([0, 0, 0], [x, 0, 0], "camera", name)
        return CameraCalibration(name, pinhole, pose, {"fx": 0.21, "fy": 0.22, "cx": 0.4, "cy": 0.4}, 0.081, "VR-1", blur_px=0.75)

    cameras = {"left": camera("left", 0.0), "right": camera("right", 350.0), "upper": camera("upper", 175.0)}
    return RigCalibration(
        CameraArrayCalibration("left", cameras, {"left-right": 0.11}),
        HandEye(
            RigidTransform.from_vector([0, 0.3, 0], [-174.2, 1.3, 81.2], "flange", "camera"), 2e-5, 0.021, 0.213, 2e-4, "Tsai, refined"
        ),
        LinearGuide(np.array([0.001, 1.0, 0.002]), 1.00012, 1e-5, 2e-6, 0.034),
        RotationAxis(np.array([850.1, 0.2, 0.0]), np.array([0.001, 0.0, 1.0]), "guide", 0.006, 2e-5, 0.019),
        Provenance(datetime.now(UTC).isoformat(), "weighted least squares"),
    )


@pytest.fixture
def rig() -> RigDescription:
    import tomllib

    from measureapp.resources import resource

    return RigDescription.model_validate(tomllib.loads(resource("rigs/paper.toml").read_text(encoding="utf-8")))


@pytest.fixture
def plan() -> ScanPlan:
    flange = FlangePose.of(RigidTransform.from_vector([0, 2.2, 0], [450, 0, 500], "base", "flange"))
    points = tuple(Viewpoint(id=f"view-{i + 1:02d}", flange=flange, guide_mm=20.0 * i, table_deg=60.0 * i) for i in range(VIEWS))
    return ScanPlan(name="six views", viewpoints=points)


@pytest.fixture
def inspection() -> Inspection:
    plane = Feature(
        "top",
        "plane",
        np.array([0, 0, 120.0]),
        np.array([0, 0, 1.0]),
        points=4000,
        form_error_mm=0.06,
        rms_mm=0.014,
        boundary_mm=np.array([[-20, -20, 120], [20, -20, 120], [20, 20, 120], [-20, 20, 120.0]]),
    )
    circle = Feature(
        "equator", "circle", np.array([0, 0, 60.0]), np.array([0, 0, 1.0]), radius_mm=60.013, points=2500, form_error_mm=0.05, rms_mm=0.012
    )
    dimensions = (
        Dimension("a", 120.0, 120.021, 0.018, -0.1, 0.1, Verdict.PASS, features=("top", "equator")),
        Dimension("b", 40.0, 40.131, 0.02, -0.1, 0.1, Verdict.FAIL, features=("equator",)),
        Dimension("c", 25.0, 25.092, 0.02, -0.1, 0.1, Verdict.NOT_PROVEN, features=("top",)),
        Dimension("d", 10.0, None, None, -0.1, 0.1, Verdict.NOT_MEASURED, reason="No points lie near the feature."),
    )
    alignment = Alignment("best fit", RigidTransform.identity("nominal", "part"), 0.021)
    return Inspection("gypsum", alignment, (plane, circle), dimensions)


@pytest.fixture
def measurement(calibration: RigCalibration, inspection: Inspection) -> Measurement:
    views = tuple(make_view(index) for index in range(VIEWS))
    placements = tuple(
        ViewPlacement(
            view.viewpoint_id,
            view.part_from_camera,
            view.part_from_camera,
            0.21 + 0.01 * i,
            0.02,
            0.014 + 0.004 * i,
            0.62,
            "good",
            view.quality.accepted,
        )
        for i, view in enumerate(views)
    )
    points, normals = sphere_points(6000, 9)
    view_index = np.arange(6000) % VIEWS
    stitched = StitchedCloud(points, normals, np.full(6000, 0.01), np.full(6000, 0.5), view_index, placements)
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=3, radius=60.0)
    measured = ball.vertices[:, 2] > -55
    mesh = Mesh(np.asarray(ball.vertices) + np.array([0, 0, 60.0]), ball.faces, "part", measured)
    return Measurement(
        "demo-gypsum",
        "gypsum",
        "Paper rig (virtual)",
        datetime.now(UTC).isoformat(),
        calibration,
        views,
        stitched,
        mesh,
        inspection,
        {},
        {"scan": 12.3, "stitch": 4.5},
    )


@pytest.fixture
def application(qapp, qtbot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Application:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setattr("ui.look.language.language.system_language", lambda: "en")
    built = build(qapp)
    built.look.set_shade("light")
    qtbot.addWidget(built.window)
    yield built
    for runner in built.controllers.runners:
        runner.queue.cancel_all()
        runner.queue.wait(10_000)
    built.controllers.rig.close()
    if isValid(built.window):  # pytest-qt has closed it; an event loop within an event may have deleted it, too
        built.window.close()
    built.language.choose("en")
    built.language.retranslation.finish()
    delete_all(built)


def delete_all(built: Application) -> None:
    """Delete what a window is made of: slots of Qt refer to each other where Python's collection cannot look.

    Left over, some hundred windows make every later collection and every search for objects of Qt take longer.
    """
    for left in (built.window, built.controllers, built.session, built.look):
        if isValid(left):
            delete(left)
    vars(built.look).clear()  # its icons, which its signals keep


@cache
def graphics_are_missing() -> bool:
    """Ask once: every answer renders a picture."""
    from ui.viewport.backend import missing_graphics

    return bool(missing_graphics())


@pytest.fixture
def calibration_page(application: Application, window, rig: RigDescription):
    """Return the page from which the wizards are opened, with the virtual rig chosen."""
    application.session.set_rig(rig)
    window.show_page("calibration")
    return window.pages["calibration"]


@pytest.fixture
def window(application: Application):
    application.window.show()
    return application.window


@pytest.fixture
def filled(application: Application, window, measurement, plan, rig: RigDescription, qtbot):
    """Return the window after a measurement, with 3-D pictures where the graphics libraries are installed."""
    session = application.session
    session.set_graphics("failed" if graphics_are_missing() else "ready", "No graphics in this test.")
    session.open_project("gypsum-4711", "gypsum", None)
    session.set_rig(rig)
    session.set_plan(plan)
    session.set_measurement(measurement, {})
    qtbot.wait(50)
    return window


@pytest.fixture
def heartbeat(qapp) -> Iterator[Heartbeat]:
    """A running heartbeat of the window's thread; the test calls its `check`."""
    with Heartbeat() as heart:
        yield heart


@pytest.fixture
def working(application: Application, qtbot) -> Iterator[Callable[[], None]]:
    """A function that begins a job, which works until the test has ended; the project must be open by then."""
    go_on = threading.Event()

    def begin() -> None:
        application.controllers.jobs.run("Recomputing", lambda _job: go_on.wait(60), lambda _found: None)
        qtbot.waitUntil(lambda: application.session.busy_with == "Recomputing")

    yield begin
    go_on.set()
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy)
