"""The measuring head: cameras and projector as one instrument that takes all images of a sequence."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Generator, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from measureapp.devices.camera import Camera, Frame, Trigger
from measureapp.devices.frame_checks import find_difference
from measureapp.devices.head_timing import check_timing, frame_timeout_s, period_us
from measureapp.devices.projector import DARK, Projector, TriggeringProjector
from measureapp.errors import DeviceError, FrameError, SequenceError

RETAKES = 3  # of one pattern whose image a camera delivers damaged
SHOW_TIMEOUT_S = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class Shot:
    """The images of all cameras of one pattern at one exposure."""

    pattern: int
    exposure_us: int
    frames: Mapping[str, Frame]


class Head(Protocol):
    """Takes sequences: `prepare` once, then `acquire`."""

    def prepare(self, patterns: Sequence[int], exposures_us: Sequence[int]) -> None:
        """Set what is to be taken: indices of the loaded images (or PLAIN_LIGHT, DARK) at every exposure.

        Every exposure is set in every camera and read back before anything is taken.

        Raises
        ------
        LimitError
            A camera or the projector cannot take one of the exposures.
        DeviceError
            A camera reads another exposure back, or the shutter does not fit the sequence.
        """

    def acquire(self) -> Generator[Shot]:
        """Take the sequence, exposure by exposure; a damaged image is taken again at the end, at most three times.

        Raises
        ------
        FrameError
            The images cannot be assigned to the patterns, or one stayed damaged.
        DeviceTimeout, DeviceLost
            From the devices.
        """


class _Sequence:
    """What both ways of synchronisation have in common."""

    def __init__(self, cameras: Mapping[str, Camera], projector: Projector) -> None:
        self._cameras, self._projector = cameras, projector
        self._patterns: tuple[int, ...] = ()
        self._exposures_us: tuple[int, ...] = ()
        self._set_us: int | None = None  # of all cameras, as read back

    def _prepare(self, patterns: Sequence[int], exposures_us: Sequence[int], *, gated: bool) -> None:
        for exposure_us in exposures_us:
            check_timing(self._cameras, self._projector, exposure_us, gated=gated)
            self._set(exposure_us)
        self._patterns, self._exposures_us = tuple(patterns), tuple(exposures_us)

    def _set(self, exposure_us: int) -> None:
        """Set the exposure of every camera that has another one, and read it back."""
        if exposure_us == self._set_us:
            return
        self._set_us = None
        for name, camera in self._cameras.items():
            camera.set_exposure_us(exposure_us)
            found = camera.exposure_us()
            if abs(found - exposure_us) > camera.exposure_step_us:
                raise DeviceError(
                    f"Camera {name} set {found} µs instead of the requested {exposure_us} µs.",
                    "Choose an exposure that the camera supports, and switch its automatic exposure off.",
                )
        self._set_us = exposure_us

    def _arm(self, frames: int, trigger: Trigger) -> None:
        for camera in self._cameras.values():
            camera.arm(frames, trigger)

    def _disarm(self) -> None:
        for camera in self._cameras.values():
            camera.disarm()

    def _wait_ready(self, exposure_us: int) -> None:
        for camera in self._cameras.values():
            camera.wait_ready(timeout_s=frame_timeout_s(camera, exposure_us))

    def _collect(self, exposure_us: int, pattern: int, number: int) -> Shot:
        """Fetch the image of every camera for one trigger. Raises FrameError after all were fetched, so that the sequence can go on."""
        frames, faults = {}, []
        for name, camera in self._cameras.items():
            try:
                frame = camera.next_frame(timeout_s=frame_timeout_s(camera, exposure_us))
            except FrameError as error:
                faults.append(error)
                continue
            difference = find_difference(frame, camera, exposure_us)
            if frame.number != number:
                raise SequenceError(
                    f"Camera {name} delivered image {frame.number} where image {number} was due: its images cannot be assigned to patterns.",
                    "Check its trigger line, its cable and the load of its link.",
                )
            if difference:
                faults.append(FrameError(f"Camera {name}: {difference}.", "Check its settings, trigger line and cable."))
            frames[name] = frame
        if faults:
            raise faults[0]
        return Shot(pattern, exposure_us, frames)


class _Retakes:
    """Counts how often each image had to be taken again."""

    def __init__(self) -> None:
        self._counts: Counter[Hashable] = Counter()

    def note(self, image: Hashable, error: FrameError) -> None:
        """Accept one more failure of an image, or raise it; an image that cannot be assigned is never accepted."""
        if isinstance(error, SequenceError):
            raise error
        self._counts[image] += 1
        if self._counts[image] > RETAKES:
            raise FrameError(f"{error.message} It was taken again {RETAKES} times in vain.", error.hint) from error


class SoftwareHead(_Sequence):
    """Shows a pattern, triggers all cameras together, holds the pattern until every row is read out; transfers overlap the next exposure."""

    def prepare(self, patterns: Sequence[int], exposures_us: Sequence[int]) -> None:
        """As `Head.prepare`."""
        self._prepare(patterns, exposures_us, gated=False)

    def acquire(self) -> Generator[Shot]:
        """As `Head.acquire`."""
        waiting = deque((exposure_us, pattern) for exposure_us in self._exposures_us for pattern in self._patterns)
        if min(self._patterns) >= 0:  # a projector late by one image gives itself away by a dark one, instead of turning every sequence
            self._projector.show(DARK, timeout_s=SHOW_TIMEOUT_S)
        self._arm(len(waiting) * (1 + RETAKES), "software")
        try:
            yield from self._take_all(waiting)
        finally:
            self._disarm()

    def _take_all(self, waiting: deque[tuple[int, int]]) -> Iterator[Shot]:
        retakes, number = _Retakes(), 0
        before = None  # exposure and pattern of the images that are being transferred
        while waiting or before is not None:
            now = waiting.popleft() if waiting else None
            if now is not None:
                self._expose(*now)
            if before is not None:
                try:
                    shot = self._collect(*before, number - 1)
                except FrameError as error:
                    retakes.note(before, error)
                    waiting.append(before)
                else:
                    yield shot
            if now is not None:
                self._wait_ready(now[0])
                number += 1
            before = now

    def _expose(self, exposure_us: int, pattern: int) -> None:
        self._set(exposure_us)
        self._projector.show(pattern, timeout_s=SHOW_TIMEOUT_S)
        for camera in self._cameras.values():
            camera.trigger()


class HardwareHead(_Sequence):
    """The projector plays the patterns and triggers all cameras; patterns, triggers and images are counted."""

    _projector: TriggeringProjector

    def prepare(self, patterns: Sequence[int], exposures_us: Sequence[int]) -> None:
        """As `Head.prepare`."""
        self._prepare(patterns, exposures_us, gated=self._projector.gated)

    def acquire(self) -> Generator[Shot]:
        """As `Head.acquire`."""
        runs = deque((exposure_us, run) for exposure_us in self._exposures_us for run in _consecutive(self._patterns))
        self._arm(len(self._patterns) * len(self._exposures_us) * (1 + RETAKES), "hardware")
        try:
            yield from self._play_all(runs)
        finally:
            self._disarm()

    def _play_all(self, runs: deque[tuple[int, range]]) -> Iterator[Shot]:
        retakes, number = _Retakes(), 0
        transferring: list[tuple[int, int, int]] = []  # exposure, pattern and number of the last image of the run before
        while runs or transferring:
            under_way = transferring
            if runs:
                exposure_us, run = runs.popleft()
                self._play(exposure_us, run)
                under_way = [*transferring, *((exposure_us, pattern, number + step) for step, pattern in enumerate(run))]
                number += len(run)
            transferring = under_way[-1:] if under_way is not transferring else []
            for image in under_way[: len(under_way) - len(transferring)]:
                try:
                    shot = self._collect(*image)
                except FrameError as error:
                    retakes.note(image[:2], error)
                    runs.append((image[0], range(image[1], image[1] + 1)))
                else:
                    yield shot
            if transferring:
                self._wait_ready(transferring[0][0])
                self._confirm_pulses(len(run))

    def _play(self, exposure_us: int, run: range) -> None:
        self._set(exposure_us)
        self._projector.play(run.start, len(run), exposure_us=exposure_us, period_us=period_us(self._cameras, exposure_us))

    def _confirm_pulses(self, patterns: int) -> None:
        sent = self._projector.triggers_sent()
        if sent != patterns:
            raise SequenceError(
                f"The projector sent {sent} trigger pulses for {patterns} patterns: the images cannot be assigned to patterns.",
                "Check the trigger line; lengthen the period if the cameras were still busy.",
            )


def _consecutive(patterns: Sequence[int]) -> Iterator[range]:
    """Divide patterns into runs of consecutive indices."""
    start = 0
    for end in range(1, len(patterns) + 1):
        if end == len(patterns) or patterns[end] != patterns[end - 1] + 1:
            yield range(patterns[start], patterns[end - 1] + 1)
            start = end
