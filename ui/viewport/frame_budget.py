"""How many points can be drawn in the time of one frame, learned from the frames drawn so far."""

from __future__ import annotations

FRAME_S = 0.075  # leaves a fourth of a tenth of a second for everything else
LEARNING = 0.4  # weight of the newest frame
LEAST_POINTS = 10_000
SOFTWARE_S_PER_POINT, HARDWARE_S_PER_POINT = 4e-7, 5e-9  # until the first frame is measured
SOFTWARE_NAMES = ("llvmpipe", "softpipe", "swr", "software", "swiftshader", "gdi generic", "basic render")


class FrameBudget:
    """Points per frame; begins with what the renderer lets expect."""

    def __init__(self, capabilities: str = "") -> None:
        self.software = is_software(capabilities)
        self._s_per_point = SOFTWARE_S_PER_POINT if self.software else HARDWARE_S_PER_POINT

    @property
    def points(self) -> int:
        """Return how many points one frame may have."""
        return max(LEAST_POINTS, int(FRAME_S / self._s_per_point))

    def observe(self, points: int, seconds: float) -> None:
        """Learn from a frame that used its budget up, or its time.

        What a frame costs without points is shared out among its points, which settles at the right budget; a frame with
        few points, the last one of a picture, would make points look dear.
        """
        used_up = points >= self.points / 2 or seconds > FRAME_S
        if used_up and points >= LEAST_POINTS / 2:
            self._s_per_point += LEARNING * (seconds / points - self._s_per_point)


def is_software(capabilities: str) -> bool:
    """Tell from what VTK reports of an initialised render window whether the processor draws; where it reports nothing, be careful."""
    told = [line.lower() for line in capabilities.splitlines() if "renderer string" in line.lower()]
    return not told or any(name in line for line in told for name in SOFTWARE_NAMES)
