"""What a calibration of the rig says against itself: residuals and error motions beyond what the axes are stated to have."""

from __future__ import annotations

from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.data.axis_motions import ARCSEC, AxisMotions

LARGEST_RATIO = 2.0  # of the residuals over what was expected
IMPROBABLE = 9.0  # times a stated motion: two standard deviations of its logarithm, by `MOTION_SPREAD`
OF_TABLE = "its bearing has play, the robot warmed up during the calibration, or the board moved on the table"
OF_GUIDE = "its carriage has play, or the robot warmed up during the calibration"


def doubts(ratio: float, motions: AxisMotions | None, noise: AxisNoise) -> tuple[str, ...]:
    """Return sentences for what is improbable by the stated ``noise`` of the axes, with likely causes.

    Parameters
    ----------
    ratio : of the residuals to what was expected
    motions : as found; None where none are estimated
    """
    return (*_large_residuals(ratio), *(() if motions is None else _large_motions(motions, noise)))


def _large_residuals(ratio: float) -> tuple[str, ...]:
    if ratio <= LARGEST_RATIO:
        return ()
    return (
        f"The residuals are {ratio:.1f} times as large as expected: the robot is less accurate than stated, the board moved, or tables and images "
        "do not belong together.",
    )


def _large_motions(motions: AxisMotions, noise: AxisNoise) -> tuple[str, ...]:
    found = motions.amplitudes
    lengths = (
        ("The table's radial error motion", found["radial"], noise.table_radial_mm, OF_TABLE),
        ("The table's axial error motion", found["axial"], noise.table_axial_mm, OF_TABLE),
        ("The guide's straightness error", found["straightness"], noise.slide_mm, OF_GUIDE),
    )
    angles = (
        ("The table's tilt error motion", found["tilt"] / ARCSEC, noise.table_tilt_rad / ARCSEC, OF_TABLE),
        ("Pitch, yaw or roll of the guide", found["angles"] / ARCSEC, noise.slide_rad / ARCSEC, OF_GUIDE),
    )
    return tuple(
        f"{name} is ± {size:.{digits}f} {unit}, {size / stated:.0f} times what is stated or usual (± {stated:.{digits}f} {unit}): {causes}."
        for kinds, digits, unit in ((lengths, 3, "mm"), (angles, 1, "″"))
        for name, size, stated, causes in kinds
        if stated > 0 and size > IMPROBABLE * stated
    )
