"""Number of points that can be drawn in the time of one frame, estimated from the frames drawn so far."""

from __future__ import annotations

FRAME_S = 0.075  # of 0.1 s; the rest is for everything else
LEARNING = 0.4  # weight of the newest frame
LEAST_POINTS = 10_000
FINER = 1.25  # expected time of a finer subsample, which has four times the points but covers the same pixels, over that of the present one
SOFTWARE_S_PER_POINT, HARDWARE_S_PER_POINT = 1.2e-6, 5e-9  # until the first frame is measured
SOFTWARE_NAMES = ("llvmpipe", "softpipe", "swr", "software", "swiftshader", "gdi generic", "basic render")


class FrameBudget:
    """Points per frame; the initial value depends on the renderer."""

    def __init__(self, capabilities: str = "") -> None:
        self.software = is_software(capabilities)
        self._s_per_point = SOFTWARE_S_PER_POINT if self.software else HARDWARE_S_PER_POINT

    @property
    def points(self) -> int:
        """Number of points allowed in one frame."""
        return max(LEAST_POINTS, int(FRAME_S / self._s_per_point))

    def observe(self, points: int, seconds: float) -> None:
        """Update the estimate from a frame that used up its points or its time.

        The fixed cost of a frame is distributed over its points, which converges to the right budget; frames with few points, such as
        the last one of a picture, are ignored because they would overestimate the cost per point.
        """
        used_up = points >= self.points / 2 or seconds > FRAME_S
        if used_up and points >= LEAST_POINTS / 2:
            self._s_per_point += LEARNING * (seconds / points - self._s_per_point)


class LevelChoice:
    """Chooses the finest subsample that is drawn in time while the camera moves; the subsamples are counted from the finest one."""

    def __init__(self) -> None:
        self._seconds: dict[int, float] = {}
        self._handed: set[int] = set()
        self._place: int | None = None

    def place(self, count: int) -> int:
        """Return the subsample for the next frame, of so many."""
        if self._place is None or self._place >= count:
            self._place = max(0, count - 2)  # the coarsest one is for the slowest computers
        here = self._seconds.get(self._place)
        if here is not None and here > FRAME_S and self._place < count - 1:
            self._place += 1
        elif here is not None and self._place > 0 and self._expected(self._place - 1, here) < FRAME_S:
            self._place -= 1
        return self._place

    def observe(self, seconds: float) -> None:
        """Take note of the time of a frame; the first one of a subsample also hands it to the graphics, so it does not count."""
        if self._place is not None and self._place not in self._handed:
            self._handed.add(self._place)
        elif self._place is not None:
            former = self._seconds.get(self._place)
            self._seconds[self._place] = seconds if former is None else former + LEARNING * (seconds - former)

    def _expected(self, place: int, coarser_s: float) -> float:
        """Return the time of a finer subsample: as it was when it was drawn, else by experience."""
        return self._seconds.get(place, FINER * coarser_s)


def is_software(capabilities: str) -> bool:
    """Whether VTK's capability report of a render window names a software renderer; True if it names none."""
    lines = [line.lower() for line in capabilities.splitlines() if "renderer string" in line.lower()]
    return not lines or any(name in line for line in lines for name in SOFTWARE_NAMES)
