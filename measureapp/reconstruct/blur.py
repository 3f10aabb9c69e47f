"""Correction of the phase for the blur of the cameras.

A pixel receives the light of its surroundings. Where that grows to one side, as on a wall oblique to the projector or at a printed edge,
the brighter side counts more and the pixel has the phase of a place beside it: for a blur of variance s², small against the distance over
which things change, of the place s² ∇ ln I further on. Uncorrected, oblique walls are measured some micrometres in front of their place, all
to the same side. Where the phase is curved, its mean over the blur is off by s² ∇²φ / 2, which makes holes narrower and round bodies thinner.
Linear interpolation of a phase between pixels does the same, like a blur of a sixth of a px² (decision 15).

Where a hole or an edge hides how the phase is curved, its shift by the light alone is corrected and the standard deviation grows: such pixels,
steep near the horizons of round bodies, would have the largest weights otherwise. What stays of the shift has one sign all over a view, and is
not averaged away by the number of points.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import cv2
import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels
from measureapp.reconstruct.kernels.blur import Blur

INTERPOLATION_PX2 = 1 / 6  # variance of linear interpolation, (1 - f) f, over all places f between two pixels
MAX_BLUR_PX = 1.5  # beyond, neither the first order nor slopes over four pixels hold
AMBIENT_SAMPLES = 20_000  # pixels determine a hundredth of the light
SLOPE_PX = 2  # distance over which the slope of the phase is taken
MAX_SLOPE = 1.5  # rad/px: beyond, blur leaves less than half of the modulation
MIN_AMBIENT_SAMPLES = 500
DARKEST_PERCENT = 1.0  # of the pixels: the least of thousands is one of noise
MIN_SPREAD = 0.05  # of the modulation: an evenly bright image does not determine the line
ITERATIONS = 5
CAUCHY = 1.5  # in units of the median residual: pixels at edges mix fringes out of phase
TINY = 1e-9


def correct_blur(
    phase_maps: Mapping[str, PhaseMap],
    cameras: CameraArrayCalibration,
    step_rad: float,
    memory: BufferPool | None = None,
    interpolated: Collection[str] = (),
) -> dict[str, PhaseMap]:
    """Correct phase maps for blur; the uncertainty of the correction goes into ``sigma_rad``.

    Those of cameras whose blur is unknown stay as they are.

    Parameters
    ----------
    step_rad : largest phase step between neighbouring pixels of one surface
    interpolated : cameras whose phases will be interpolated between pixels; this blur is corrected too
    """
    memory = memory or BufferPool()
    return {
        name: _correct(phase_map, cameras.cameras[name].blur_px, step_rad, memory, name in interpolated)
        if name in cameras.cameras
        else phase_map
        for name, phase_map in phase_maps.items()
    }


def _correct(phase_map: PhaseMap, blur_px: float, step_rad: float, memory: BufferPool, interpolated: bool) -> PhaseMap:
    if blur_px <= 0:
        return phase_map
    shape = phase_map.phase_rad.shape
    variance = min(blur_px, MAX_BLUR_PX) ** 2
    blur = Blur(
        read_only(phase_map.phase_rad, np.float32).reshape(-1),
        read_only(phase_map.sigma_rad, np.float32).reshape(-1),
        read_only(projected_light(phase_map, variance), np.uint16).reshape(-1),
        read_only(phase_map.state, np.uint8).reshape(-1),
        np.float32(variance),
        np.float32(INTERPOLATION_PX2 / variance if interpolated else 0.0),
        np.float32(step_rad),
        np.float32(0.0),
        *shape,
    )
    phase, sigma = memory.empty(phase_map.state.size, np.float32), memory.empty(phase_map.state.size, np.float32)
    in_bands(lambda start, stop: kernels.correct_blur(blur, start, stop, phase, sigma), shape[0])
    orthogonal = None if phase_map.orthogonal is None else _correct(phase_map.orthogonal, blur_px, step_rad, memory, interpolated)
    return replace(phase_map, phase_rad=read_only(phase.reshape(shape)), sigma_rad=read_only(sigma.reshape(shape)), orthogonal=orthogonal)


def projected_light(phase_map, variance_px2):
    ambient, ratio = estimate_ambient_light(phase_map, variance_px2), 1.1
    step=2
    h,w=phase_map.state.shape
    sl=np.s_[::step,::step]
    ph=np.asarray(phase_map.phase_rad[sl],np.float32)
    scale = np.array([phase_map.exposures_us[0] / exposure for exposure in phase_map.exposures_us] or [1.0])
    ex=np.clip(phase_map.exposure_index[sl].astype(int),0,len(scale)-1)
    m=phase_map.modulation[sl]*scale[ex].astype(np.float32)
    g=phase_map.grey[sl].astype(np.float32)
    ok=phase_map.state[sl]==0
    dx=np.zeros_like(ph); dy=np.zeros_like(ph)
    dx[:,1:-1]=(ph[:,2:]-ph[:,:-2])/4; dy[1:-1]=(ph[2:]-ph[:-2])/4
    inside=np.zeros_like(ok); inside[1:-1,1:-1]=ok[1:-1,1:-1]&ok[1:-1,2:]&ok[1:-1,:-2]&ok[2:,1:-1]&ok[:-2,1:-1]
    s2=dx*dx+dy*dy
    inside&=s2<MAX_SLOPE**2
    A=g-ratio_of(phase_map,variance_px2)*m*np.exp(np.minimum(variance_px2*s2/2,3))
    known=inside.astype(np.float32)
    A=np.where(inside,np.clip(A,0,None),0).astype(np.float32)
    num=cv2.blur(A,(5,5)); den=cv2.blur(known,(5,5))
    num2=cv2.blur(A,(15,15)); den2=cv2.blur(known,(15,15))
    fill=np.where(den>0.05,num/np.maximum(den,1e-6),np.where(den2>0.01,num2/np.maximum(den2,1e-6),ambient)).astype(np.float32)
    A=np.where(inside,A,fill).astype(np.float32)
    A=cv2.medianBlur(A,5)
    A=np.minimum(cv2.resize(A,(w,h),interpolation=cv2.INTER_LINEAR),0.9*phase_map.grey)
    return np.maximum(phase_map.grey-A,0).astype(np.uint16)

def ratio_of(phase_map,v):
    return LINE[0]
LINE=[1.1,0]

def estimate_ambient_light(phase_map: PhaseMap, variance_px2: float) -> float:
    """Estimate the grey level without the projector's light: ambient light and the camera's black level; 0 where it is undetermined.

    Over all pixels the mean grey level grows linearly with the modulation; the intercept of a robust line is the level without any. Blur
    takes exp(-s² |∇φ|² / 2) of the modulation, but nothing of the mean: steep fringes, as of dim oblique walls, would bend the line.
    Scaled as `PhaseMap.grey` is.
    """
    grey, modulation = _sample_light(phase_map, variance_px2)
    if len(grey) < MIN_AMBIENT_SAMPLES or modulation.std() < MIN_SPREAD * modulation.mean():
        return 0.0
    columns = np.column_stack([modulation, np.ones(len(grey))])
    weight: FloatArray = np.ones(len(grey))
    line: FloatArray = np.zeros(2)
    for _ in range(ITERATIONS):
        line = np.linalg.solve((columns * weight[:, None]).T @ columns, (columns * weight[:, None]).T @ grey)
        residual = grey - columns @ line
        weight = 1 / (1 + (residual / (CAUCHY * np.median(np.abs(residual)) + TINY)) ** 2)
    LINE[:]=list(line)
    return float(np.clip(line[1], 0.0, np.percentile(grey, DARKEST_PERCENT)))


def _sample_light(phase_map: PhaseMap, variance_px2: float) -> tuple[FloatArray, FloatArray]:
    """Return grey levels and modulation without blur (N,), both at the longest exposure, of pixels all over the image inside surfaces."""
    height, width = phase_map.state.shape
    step = max(1, int(np.sqrt(phase_map.state.size / AMBIENT_SAMPLES)))

    def moved(image: FloatArray | IntArray, down: int, right: int) -> FloatArray:
        return np.asarray(
            image[SLOPE_PX + down : height - SLOPE_PX + down : step, SLOPE_PX + right : width - SLOPE_PX + right : step], np.float64
        )

    aside = ((0, SLOPE_PX), (0, -SLOPE_PX), (SLOPE_PX, 0), (-SLOPE_PX, 0))
    right, left, below, above = (moved(phase_map.phase_rad, *each) for each in aside)
    slope2 = ((right - left) ** 2 + (below - above) ** 2) / (2 * SLOPE_PX) ** 2
    inside = np.all([moved(phase_map.state, *each) == 0 for each in ((0, 0), *aside)], axis=0)
    chosen = inside & (slope2 < MAX_SLOPE**2)
    scale = np.array([phase_map.exposures_us[0] / exposure for exposure in phase_map.exposures_us] or [1.0])
    exposure = np.clip(moved(phase_map.exposure_index, 0, 0)[chosen].astype(int), 0, len(scale) - 1)
    sharp = moved(phase_map.modulation, 0, 0)[chosen] * np.exp(variance_px2 * slope2[chosen] / 2)
    return moved(phase_map.grey, 0, 0)[chosen], sharp * scale[exposure]
