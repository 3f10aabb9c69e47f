"""The measuring head: cameras and projector as one instrument that takes all images of a sequence."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from measureapp.devices.camera import Camera, Frame, Trigger
from measureapp.devices.frame_checks import find_difference
from measureapp.devices.head_timing import check_timing, frame_timeout_s, period_us
from measureapp.devices.projector import Projector, TriggeringProjector
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
        """Take the sequence, exposure by exposure; a damaged image is taken again, at most three times, and then comes last.

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

    def _set(self, exposure_us: int) -> None:
        for name, camera in self._cameras.items():
            camera.set_exposure_us(exposure_us)
            found = camera.exposure_us()
            if abs(found - exposure_us) > camera.exposure_step_us:
                raise DeviceError(
                    f"Camera {name} set {found} µs instead of the requested {exposure_us} µs.",
                    "Choose an exposure that the camera supports, and switch its automatic exposure off.",
                )

    def _arm(self, frames: int, trigger: Trigger) -> None:
        for camera in self._cameras.values():
            camera.arm(frames, trigger)

    def _disarm(self) -> None:
        for camera in self._cameras.values():
            camera.disarm()

    def _collect(self, pattern: int, exposure_us: int, number: int) -> Shot:
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
    """Counts how often each pattern had to be taken again."""

    def __init__(self) -> None:
        self._counts: Counter[int] = Counter()

    def note(self, pattern: int, error: FrameError) -> None:
        """Accept one more failure of a pattern, or raise it."""
        self._counts[pattern] += 1
        if self._counts[pattern] > RETAKES:
            raise FrameError(f"{error.message} It was taken again {RETAKES} times in vain.", error.hint) from error


class SoftwareHead(_Sequence):
    """Shows a pattern, triggers all cameras together, holds the pattern until every row is read out; transfers overlap the next exposure."""

    def prepare(self, patterns: Sequence[int], exposures_us: Sequence[int]) -> None:
        """As `Head.prepare`."""
        for exposure_us in exposures_us:
            check_timing(self._cameras, self._projector, exposure_us)
            self._set(exposure_us)
        self._patterns, self._exposures_us = tuple(patterns), tuple(exposures_us)

    def acquire(self) -> Generator[Shot]:
        """As `Head.acquire`."""
        for exposure_us in self._exposures_us:
            self._set(exposure_us)
            self._arm(len(self._patterns) * (1 + RETAKES), "software")
            try:
                yield from self._take_all(exposure_us)
            finally:
                self._disarm()

    def _take_all(self, exposure_us: int) -> Iterator[Shot]:
        waiting, retakes = deque(self._patterns), _Retakes()
        number, before = 0, None  # `before`: the pattern whose images are being transferred
        while waiting or before is not None:
            now = waiting.popleft() if waiting else None
            if now is not None:
                self._expose(now)
            if before is not None:
                try:
                    shot = self._collect(before, exposure_us, number - 1)
                except SequenceError:
                    raise
                except FrameError as error:
                    retakes.note(before, error)
                    waiting.append(before)
                else:
                    yield shot
            if now is not None:
                for camera in self._cameras.values():
                    camera.wait_ready(timeout_s=frame_timeout_s(camera, exposure_us))
                number += 1
            before = now

    def _expose(self, pattern: int) -> None:
        self._projector.show(pattern, timeout_s=SHOW_TIMEOUT_S)
        for camera in self._cameras.values():
            camera.trigger()


class HardwareHead(_Sequence):
    """The projector plays the patterns and triggers all cameras; patterns, triggers and images are counted."""

    _projector: TriggeringProjector

    def prepare(self, patterns: Sequence[int], exposures_us: Sequence[int]) -> None:
        """As `Head.prepare`."""
        for exposure_us in exposures_us:
            check_timing(self._cameras, self._projector, exposure_us, gated=self._projector.gated)
            self._set(exposure_us)
        self._patterns, self._exposures_us = tuple(patterns), tuple(exposures_us)

    def acquire(self) -> Generator[Shot]:
        """As `Head.acquire`."""
        for exposure_us in self._exposures_us:
            self._set(exposure_us)
            retakes = _Retakes()
            waiting = list(self._patterns)
            while waiting:
                damaged: list[int] = []
                for run in _consecutive(waiting):
                    yield from self._play(run, exposure_us, retakes, damaged)
                waiting = damaged

    def _play(self, run: range, exposure_us: int, retakes: _Retakes, damaged: list[int]) -> Iterator[Shot]:
        self._arm(len(run), "hardware")
        try:
            self._projector.play(run.start, len(run), exposure_us=exposure_us, period_us=period_us(self._cameras, exposure_us))
            for number, pattern in enumerate(run):
                try:
                    shot = self._collect(pattern, exposure_us, number)
                except SequenceError:
                    raise
                except FrameError as error:
                    retakes.note(pattern, error)
                    damaged.append(pattern)
                else:
                    yield shot
            sent = self._projector.triggers_sent()
            if sent != len(run):
                raise SequenceError(
                    f"The projector sent {sent} trigger pulses for {len(run)} patterns: the images cannot be assigned to patterns.",
                    "Check the trigger line; lengthen the period if the cameras were still busy.",
                )
        finally:
            self._disarm()


def _consecutive(patterns: Sequence[int]) -> Iterator[range]:
    """Divide patterns into runs of consecutive indices."""
    start = 0
    for end in range(1, len(patterns) + 1):
        if end == len(patterns) or patterns[end] != patterns[end - 1] + 1:
            yield range(patterns[start], patterns[end - 1] + 1)
            start = end
