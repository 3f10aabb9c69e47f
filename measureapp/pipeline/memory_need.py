"""The memory that processing a project needs at its peak: estimated before it starts, and refused where there is less."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.calibration_session.detection import DETECTION_THREADS
from measureapp.errors import InputError, StorageError
from measureapp.memory import GIB, available_bytes
from measureapp.pipeline.events import Event, MemoryShort
from measureapp.project.folder import ProjectFolder
from measureapp.project.large_clouds import LARGE_BYTES

PROGRAM_BYTES = 500_000_000  # with its libraries and compiled kernels
DETECTION_BYTES = 120  # of a pixel of the two images that a thread searches for the board
VIEW_BYTES = 130  # of a pixel of each camera of the view that is decoded, matched and cleaned
CLOUD_BYTES = 53  # of a point; large clouds are on disk
STITCHING_BYTES = 60  # of a point, while clouds are registered and merged, and while the part is inspected: 33 where ten views overlap
SURFACE_BYTES = 400_000_000  # of the program that computes the surface beside the inspection, from at most a million points
SAMPLED_VIEWS, ROWS, COLUMNS = 3, 16, 4  # of views, and of rows and columns of their images, lit pixels are counted
LIT = 0.04  # of saturation: a pixel that changes by so much from pattern to pattern may become a point


@dataclass(frozen=True, slots=True)
class Need:
    """Bytes at the peak of each stage, and what they were estimated from."""

    calibration: int  # with one thread
    detection: int  # of each thread beyond the first
    clouds: int
    stitching: int
    words: str

    def peak(self, threads: int = 1) -> int:
        """Return the peak of all stages."""
        return max(self.calibration + (threads - 1) * self.detection, self.clouds, self.stitching)


def detection_threads(project: ProjectFolder, on_event: Callable[[Event], None], available: Callable[[], int] = available_bytes) -> int:
    """Return in how many threads the board is detected, so that processing fits in the memory that is available; fewer than usual are told.

    Raises
    ------
    InputError
        It will not fit, also with a single thread; states the numbers.
    """
    need, there = memory_need(project), available()
    if need.peak() > there:
        raise InputError(
            f"Processing {project.path} needs about {_gib(need.peak())} of memory ({need.words}), and {_gib(there)} are available.",
            "Close other programs, raise the memory limit of the container, or use a computer with more memory.",
        )
    threads = next(count for count in range(DETECTION_THREADS, 0, -1) if count == 1 or need.peak(count) <= there)
    if threads < DETECTION_THREADS:
        on_event(MemoryShort(threads, DETECTION_THREADS, need.peak(DETECTION_THREADS) / GIB, there / GIB))
    return threads


def memory_need(project: ProjectFolder) -> Need:
    """Estimate what processing needs, from the numbers of views and pixels, and the share of pixels that are lit."""
    rig, views, boards = project.rig(), project.stored_viewpoints(), project.board_view_count()
    sizes = [camera.width_px * camera.height_px for camera in rig.cameras]
    points = round(len(views) * max(sizes) * _lit_share(project, views))
    held = PROGRAM_BYTES + min(CLOUD_BYTES * points, LARGE_BYTES * len(views))
    return Need(
        calibration=PROGRAM_BYTES + boards * sum(sizes) + DETECTION_BYTES * max(sizes),
        detection=DETECTION_BYTES * max(sizes),
        clouds=held + VIEW_BYTES * sum(sizes),
        stitching=held + STITCHING_BYTES * points + SURFACE_BYTES,
        words=f"{len(views)} views by {len(sizes)} cameras, up to {max(sizes) / 1e6:.1f} megapixels, about {points / 1e6:.1f} million points",
    )


def _lit_share(project: ProjectFolder, views: Sequence[str]) -> float:
    """Return the largest share of pixels that are lit in some of the views; 1 where no images can be read."""
    chosen = [views[index] for index in sorted({round(at) for at in np.linspace(0, len(views) - 1, SAMPLED_VIEWS)})] if views else []
    shares = []
    for viewpoint_id in chosen:
        try:
            stack = project.frames.load(viewpoint_id, checked=False)
        except StorageError:  # said where the images are used
            continue
        for images in stack.images.values():
            some = np.asarray(images[:, :, ::ROWS, ::COLUMNS])  # (exposures, patterns, rows, columns)
            change = some.max(axis=1).astype(np.int64) - some.min(axis=1)
            shares.append(float((change.max(axis=0) > LIT * stack.saturation).mean()))
    return max(shares, default=1.0)


def _gib(size: int) -> str:
    return f"{size / GIB:.1f} GiB"
