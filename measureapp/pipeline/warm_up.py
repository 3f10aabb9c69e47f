"""Warm-up of the compiled kernels: compilation takes many seconds once per installation, loading from the cache little."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from measureapp.arrays import read_only
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.cloud import PointCloud
from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.mesh import Mesh
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.data.phase import PhaseMap
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.streaming import StreamingDecoder
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.alignment.best_fit import no_alignment
from measureapp.inspection.measured_points import sample_mesh
from measureapp.inspection.surface.closest.hierarchy import TriangleHierarchy
from measureapp.inspection.surface.deviation import compute_deviation
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.reconstruct.reconstruct import reconstruct
from measureapp.register.grid.voxels import CHUNK, VoxelSums
from measureapp.register.stitch import stitch
from measureapp.report.deviation_pictures import render_deviation, summarise_deviation
from measureapp.report.part_pictures import OBLIQUE
from measureapp.report.picture import surface_picture

HEIGHT_PX, WIDTH_PX, FOCAL_PX, BLUR_PX = 72, 320, 500.0, 0.7
WALL_MM, STEP_MM = 200.0, 40.0
SHIFT_PX = round(FOCAL_PX * STEP_MM / WALL_MM)
FIRST_COLUMN = 300
FULL_TABLE = 3 * CHUNK  # number of voxels that makes the table grow
PICTURED = 100  # points compared with a nominal
CAMERAS = ("first", "second", "third")
THREE_STEPS = PatternSet(
    name="warm-up", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32, steps=3), PhaseShiftGroup(pitch_px=33, steps=3))
)
GRAY_PATTERNS = PatternSet(name="warm-up", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32), GrayCodeGroup(planes=5)))


def warm_up(progress: Progress | None = None) -> None:
    """Decode, reconstruct, stitch and measure a small wall, so that all kernels of these stages are compiled and cached on disk.

    Parameters
    ----------
    progress : reported and cancellable after each stage; kernels compiled by then stay cached
    """
    progress = progress or NoProgress()
    steps = (
        "decoding",
        "decoding other steps",
        "decoding 16 bits",
        "decoding while images arrive",
        "reconstructing three cameras",
        "reconstructing two",
        "stitching",
        "distances from a nominal",
        "pictures of reports",
    )

    def begin(step: int) -> None:
        progress.report(step, len(steps), f"compiling: {steps[step]}")

    begin(0)
    maps = decode(_stack(PAPER_PATTERNS, np.uint8))
    begin(1)
    for patterns in (GRAY_PATTERNS, THREE_STEPS):
        decode(_stack(patterns, np.uint8))
    begin(2)
    decode(_stack(PAPER_PATTERNS, np.uint16))
    begin(3)
    for patterns, dtype in ((PAPER_PATTERNS, np.uint8), (THREE_STEPS, np.uint8), (PAPER_PATTERNS, np.uint16)):
        _stream(_stack(patterns, dtype))
    begin(4)
    cloud = _cloud(maps, CAMERAS, PartOf(progress, 4 / len(steps), 5 / len(steps)))
    begin(5)
    _cloud(maps, CAMERAS[:2], PartOf(progress, 5 / len(steps), 6 / len(steps)))
    begin(6)
    pose = RigidTransform.identity("part", "camera")
    stitch([cloud, cloud], [pose, pose])
    VoxelSums(1).add(np.arange(FULL_TABLE), np.zeros((FULL_TABLE, 1)))
    begin(7)
    TriangleHierarchy(np.eye(3)[None]).closest(np.zeros((1, 3)))
    begin(8)
    triangle = Mesh(np.eye(3), np.array([[0, 1, 2]]), "nominal")
    surface_picture(triangle, OBLIQUE)
    deviation = compute_deviation(sample_mesh(triangle, PICTURED), triangle, no_alignment())
    render_deviation(triangle, deviation, summarise_deviation(triangle, deviation))
    progress.report(1, 1, "compiled")


def _stack(patterns: PatternSet, dtype: type[np.unsignedinteger]) -> FringeStack:
    """Return the images of three cameras side by side of a wall parallel to their image planes: shifted patterns."""
    shown = pattern_images(patterns, patterns.projector_px, HEIGHT_PX).astype(dtype) // 2 + 20
    images = {}
    for number, camera in enumerate(CAMERAS):
        start = FIRST_COLUMN + number * SHIFT_PX
        images[camera] = read_only(shown[None, :, :, start : start + WIDTH_PX], dtype)
    return FringeStack("warm-up", patterns, (10_000,), images, 255)


def _stream(stack: FringeStack) -> None:
    """Decode a stack exposure by exposure, with the blooming guard."""
    decoder = StreamingDecoder(stack.patterns, stack.exposures_us, stack.saturation, DecodeSettings(blooming_radius_px=1))
    for camera, images in stack.images.items():
        decoder.add(camera, 0, images[0])
    decoder.finish()


def _cloud(maps: Mapping[str, PhaseMap], names: tuple[str, ...], progress: Progress) -> PointCloud:
    matrix = np.array([[FOCAL_PX, 0, (WIDTH_PX - 1) / 2], [0, FOCAL_PX, (HEIGHT_PX - 1) / 2], [0, 0, 1]])
    pinhole = PinholeCamera(WIDTH_PX, HEIGHT_PX, matrix, np.zeros(5))
    cameras = {
        name: CameraCalibration(
            name, pinhole, RigidTransform.from_parts(np.eye(3), [number * STEP_MM, 0, 0], "camera", name), blur_px=BLUR_PX
        )
        for number, name in enumerate(names)
    }
    return reconstruct({name: maps[name] for name in names}, CameraArrayCalibration(names[0], cameras), progress=progress).cloud
