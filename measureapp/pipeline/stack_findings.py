"""What the images of a viewpoint say against a part at rest in steady light, in words, with what it costs in mm."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.cloud import PointCloud
from measureapp.data.phase import PhaseMap

CLEARLY = 0.85  # of the stated phase noise that motion or light must make up: then it is more than all other noise
LEAST_STEP = 0.1  # share by which light must change from one group of images to the next
SCATTER = 1.5  # times the predicted phase noise
BLURRED = 1.15  # times the blur of the board


def stack_findings(maps: Mapping[str, PhaseMap], cloud: PointCloud) -> tuple[str, ...]:
    """Return sentences about vibration, light that changed, and noise that the images' own noise does not explain; the worst camera of each.

    The cost in mm is the phase error times what a radian is worth in this view: the ratio of the standard deviations of points and phases.
    """
    known = {name: each for name, each in maps.items() if each.evidence is not None and each.valid.any()}
    if not known or not len(cloud):
        return ()
    noise = {name: float(np.median(each.sigma_rad[each.valid])) for name, each in known.items()}
    mm_per_rad = float(np.median(cloud.sigma_mm)) / max(min(noise.values()), 1e-9)
    evidence = {name: each.evidence for name, each in known.items() if each.evidence is not None}
    sentences = []
    moved = max(evidence, key=lambda name: evidence[name].vibration_rad / noise[name])
    if evidence[moved].vibration_rad > CLEARLY * noise[moved]:
        sentences.append(
            f"The fringes moved between the images of camera {moved}: vibration, or a part or axis that had not settled. "
            f"It costs about {evidence[moved].vibration_rad * mm_per_rad:.3f} mm at a point, which the stated σ contains. "
            "Wait longer before the images, and take the viewpoint again."
        )
    changed = max(
        evidence, key=lambda name: max(evidence[name].light_rad / noise[name] / CLEARLY, abs(evidence[name].light_step) / LEAST_STEP)
    )
    light = evidence[changed]
    if light.light_rad > CLEARLY * noise[changed] or abs(light.light_step) > LEAST_STEP:
        step = f" by {light.light_step:+.0%}" if abs(light.light_step) > LEAST_STEP else ""
        sentences.append(
            f"The light changed{step} during the images of camera {changed}, at {light.light_exposure_us / 1000:g} ms: a lamp was switched, "
            f"or flickers. It costs up to {light.light_rad * mm_per_rad:.3f} mm at a point, which the stated σ contains. "
            "Keep the light of the room steady, and take the viewpoint again."
        )
    rough = max(evidence, key=lambda name: evidence[name].scatter)
    if evidence[rough].scatter > SCATTER:
        sentences.append(
            f"The phases of camera {rough} scatter {evidence[rough].scatter:.1f} times as much as the noise of its images: a projector or camera "
            "whose response is not linear, images that are not raw, or a rough surface. The stated σ contains it, about "
            f"{noise[rough] * mm_per_rad:.3f} mm at a point. `measureapp response` corrects the projector."
        )
    return tuple(sentences)


def blur_findings(blur_px: Mapping[str, float], cameras: CameraArrayCalibration) -> tuple[str, ...]:
    """Return a sentence about the camera in which the part is least sharp beside the board, if it is clearly less sharp."""
    known = {name: blur / cameras.cameras[name].blur_px for name, blur in blur_px.items() if cameras.cameras[name].blur_px > 0.0}
    if not known or max(known.values()) < BLURRED:
        return ()
    worst = max(known, key=lambda name: known[name])
    return (
        f"The part is less sharp in camera {worst} than the board was: its edges are blurred by {blur_px[worst]:.2f} px instead of "
        f"{cameras.cameras[worst].blur_px:.2f} px. Points are corrected for it. Check focus and lens, and calibrate at the distance of the part.",
    )
