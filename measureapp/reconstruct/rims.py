"""The phase without the rims of surfaces.

At the border of a surface a pixel shows light from beyond it as well, or none where there should be some, so that its phase is that of a
place further in: by several micrometres, always to the same side, and by a tenth of a millimetre where a camera looks along a wall, of which two
pixels see millimetres. No correction knows what lies beyond (decision 15). How far this reaches follows the blur of the camera.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import cv2
import numpy as np

from measureapp.arrays import in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap
from measureapp.data.point_state import PointState
from measureapp.reconstruct import kernels

NARROWEST_PX = 2  # what the kernel marks
PX_PER_BLUR = 2.6  # beyond this the blur brings in less than a hundredth of what lies across the border
BESIDE = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))


def without_rims(
    phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration, memory: BufferPool | None = None
) -> dict[str, PhaseMap]:
    """Return the phase maps without the pixels next to holes, whose state is then `PointState.RIM`, which is no `PixelState`.

    They are two pixels wide up to a blur of 0.96 px, and 2.6 times as wide as a greater one. Those of cameras whose blur is not known stay
    as they are, as in `without_blur`.
    """
    memory = memory or BufferPool()
    return {
        name: _inner(phase_map, _width_px(cameras.cameras[name].blur_px), memory)
        if name in cameras.cameras and cameras.cameras[name].blur_px > 0
        else phase_map
        for name, phase_map in phase_maps.items()
    }


def _width_px(blur_px: float) -> int:
    return max(NARROWEST_PX, round(PX_PER_BLUR * blur_px))


def _inner(phase_map: PhaseMap, width_px: int, memory: BufferPool) -> PhaseMap:
    state = read_only(phase_map.state, np.uint8)
    marked = memory.empty(state.shape, np.uint8)
    in_bands(lambda start, stop: kernels.mark_rims(state, start, stop, marked), len(state))
    if width_px > NARROWEST_PX:
        near = cv2.dilate(np.equal(marked, PointState.RIM).astype(np.uint8), BESIDE, iterations=width_px - NARROWEST_PX)
        marked[(near != 0) & (state == 0)] = PointState.RIM
    across = None if phase_map.orthogonal is None else _inner(phase_map.orthogonal, width_px, memory)
    return replace(phase_map, state=read_only(marked), orthogonal=across)
