"""Images of an earlier viewpoint that a camera or a driver delivers again."""

from __future__ import annotations

from hashlib import blake2b

from measureapp.data.fringe import FringeStack
from measureapp.errors import FrameError

ROWS = 8  # compared of each image; noise never repeats in so many pixels


class StaleImages:
    """Remembers a digest of every image of the stack before, and finds those that return."""

    def __init__(self) -> None:
        self._before: dict[bytes, str] = {}

    def check(self, stack: FringeStack) -> None:
        """Raise FrameError where an image that varies is identical to one of another viewpoint; otherwise remember this stack."""
        own: dict[bytes, str] = {}
        for camera, images in stack.images.items():
            rows = images[:, :, :: max(1, images.shape[2] // ROWS), :]
            for level, exposure_us in enumerate(stack.exposures_us):
                for pattern in range(images.shape[1]):
                    sample = rows[level, pattern]
                    if sample.min() == sample.max():
                        continue  # all dark or all saturated: says nothing
                    digest = blake2b(sample.tobytes(), digest_size=16).digest()
                    if digest in self._before:
                        raise FrameError(
                            f"{stack.viewpoint_id}: image {pattern + 1} of camera {camera} at {exposure_us} µs is an image of {self._before[digest]}.",
                            "The camera delivers stale images: check its trigger line and its driver.",
                        )
                    own[digest] = stack.viewpoint_id
        self._before = own
