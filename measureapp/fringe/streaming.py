"""Decoding while images arrive: every exposure is summed as soon as it is complete, the phase is computed after the last."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.fringe import PatternSet
from measureapp.data.phase import PhaseMap
from measureapp.errors import DecodeError
from measureapp.fringe.decode_plan import DecodePlan
from measureapp.fringe.direction import DirectionDecoder
from measureapp.fringe.patterns.draw import check_determines_phase
from measureapp.fringe.settings import DecodeSettings


class StreamingDecoder:
    """Decodes one viewpoint exposure by exposure; the result equals that of `decode` bit for bit.

    Parameters
    ----------
    patterns : the whole set
    exposures_us : from long to short
    saturation : grey level from which a pixel counts as saturated
    settings : None for the defaults
    viewpoint_id : named in the phase maps
    memory : pool of the maps of earlier viewpoints; None: a new one

    Raises
    ------
    DecodeError
        The set does not determine the phase.
    """

    def __init__(
        self,
        patterns: PatternSet,
        exposures_us: tuple[int, ...],
        saturation: float,
        settings: DecodeSettings | None = None,
        viewpoint_id: str = "",
        memory: BufferPool | None = None,
    ) -> None:
        check_determines_phase(patterns)
        self._patterns, self._exposures_us, self._saturation = patterns, exposures_us, saturation
        self._settings, self._viewpoint_id = settings or DecodeSettings(), viewpoint_id
        self._memory = memory or BufferPool()
        self._decoders: dict[str, list[DirectionDecoder]] = {}
        self._shapes: dict[str, tuple[tuple[int, ...], str]] = {}
        self._added: dict[str, int] = {}

    def add(self, camera: str, exposure_index: int, images: ImageArray) -> None:
        """Sum the images (P, H, W) of one exposure of one camera; exposures must come in order.

        Raises
        ------
        DecodeError
            Another exposure is due, or the images do not fit those before.
        """
        due = self._added.get(camera, 0)
        if exposure_index != due:
            wanted = f"exposure {due + 1} of {len(self._exposures_us)} is due" if due < len(self._exposures_us) else "all are there"
            raise DecodeError(
                f"Camera {camera!r} gave exposure {exposure_index + 1}, but {wanted}.", "Add the exposures from long to short, each once."
            )
        self._check_images(camera, images)
        if camera not in self._decoders:
            self._decoders[camera] = make_decoders(
                self._patterns, (self._exposures_us, self._saturation), self._settings, camera, self._viewpoint_id, images, self._memory
            )
        for decoder in self._decoders[camera]:
            decoder.add(exposure_index, images)
        self._added[camera] = due + 1

    def _check_images(self, camera: str, images: ImageArray) -> None:
        if images.ndim != 3 or len(images) != self._patterns.count or images.dtype not in (np.uint8, np.uint16):
            raise DecodeError(
                f"Camera {camera!r} gave {images.dtype} images of shape {images.shape}; one exposure has {self._patterns.count} images.",
                "Add all images of one exposure together, 8 or 16 bits without sign.",
            )
        known = self._shapes.setdefault(camera, (images.shape, str(images.dtype)))
        if known != (images.shape, str(images.dtype)):
            raise DecodeError(f"Camera {camera!r} changed size or bit depth between exposures.", "Record a viewpoint in one go.")

    def finish(self) -> dict[str, PhaseMap]:
        """Return the phase map of every camera.

        Raises
        ------
        DecodeError
            An exposure is missing, or the phases contradict the pattern set.
        """
        missing = [camera for camera, added in self._added.items() if added < len(self._exposures_us)]
        if missing or not self._added:
            raise DecodeError(f"Exposures of camera {', '.join(missing) or 'any'} are missing.", "Add every exposure of every camera.")
        return {camera: join_directions([decoder.finish() for decoder in decoders]) for camera, decoders in self._decoders.items()}


def make_decoders(
    patterns: PatternSet,
    bracket: tuple[tuple[int, ...], float],
    settings: DecodeSettings,
    camera: str,
    viewpoint_id: str,
    images: ImageArray,
    memory: BufferPool,
) -> list[DirectionDecoder]:
    """Return one decoder for each direction of a set, vertical first; ``bracket`` is the exposures and the saturation."""
    made, corrected = [], 0
    for direction in patterns.directions:
        plan = DecodePlan.of(patterns, direction, bracket, settings, camera)
        if settings.phase_correction:
            own = settings.phase_correction[corrected : corrected + len(plan.groups)]
            corrected += len(plan.groups)
            plan = replace(plan, settings=settings.model_copy(update={"phase_correction": own}))
        made.append(DirectionDecoder(plan, (camera, viewpoint_id), (images.shape[-2], images.shape[-1]), images.dtype, memory))
    return made


def join_directions(maps: list[PhaseMap]) -> PhaseMap:
    """Return the map of the first direction, with that of the second as `PhaseMap.orthogonal`."""
    return replace(maps[0], orthogonal=maps[1]) if len(maps) > 1 else maps[0]
