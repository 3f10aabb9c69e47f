"""Exceptions for errors that users can act on: each has a message and a hint."""

from __future__ import annotations


class MeasureError(Exception):
    """Base class of errors reported to the user.

    Parameters
    ----------
    message : what happened, naming the file, device or value
    hint : what the user can do
    """

    def __init__(self, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.hint = hint

    def __str__(self) -> str:
        return f"{self.message} {self.hint}".strip()


class InputError(MeasureError):
    """A file or value given by the user cannot be used."""


class FrameMismatch(MeasureError):
    """Transforms or clouds were combined whose frames do not match."""


class PlanError(MeasureError):
    """A scan plan exceeds the capabilities of the rig."""


class DecodeError(MeasureError):
    """Fringe images do not determine the phase."""


class ReconstructError(MeasureError):
    """Phase maps and calibration do not yield points."""


class CalibrationError(MeasureError):
    """A calibration cannot be solved, or does not match the rig it is used with."""


class RegistrationError(MeasureError):
    """Clouds cannot be registered."""


class InspectionError(MeasureError):
    """A feature or dimension cannot be evaluated."""


class UnitQuestion(InspectionError):
    """Lengths are probably in another unit than assumed; the user has to decide.

    Parameters
    ----------
    what : "points" or "nominal"
    unit : the likely unit, as `measureapp.data.length_unit.LengthUnit` names it
    finding : evidence, a sentence without its full stop
    """

    def __init__(self, message: str, hint: str, what: str, unit: str, finding: str) -> None:
        super().__init__(message, hint)
        self.what, self.unit, self.finding = what, unit, finding


class FitError(MeasureError):
    """Points do not determine the requested shape."""


class StorageError(MeasureError):
    """A project cannot be read or written (disk full, damaged, not a project)."""


class DiskFull(StorageError):
    """There is no room, or the quota is exhausted; writing can be repeated when there is room again."""


class DiskFailed(StorageError):
    """The disk reported an error, or the folder vanished; writing can be repeated when it is back."""


class Damaged(StorageError):
    """A stored file is missing or is not what was stored; it must not be used."""


class DeviceError(MeasureError):
    """A device failed, refused or did not answer."""


class LimitError(DeviceError):
    """A move was refused because its goal lies outside an axis's limits."""


class DeviceTimeout(DeviceError):
    """A device did not finish in time."""


class MotionError(DeviceError):
    """An axis did not reach its goal, or left it; nothing may move or be measured before the cause is found."""


class FrameError(DeviceError):
    """One image is damaged, incomplete or not the one requested; it can be taken again."""


class SequenceError(FrameError):
    """Images cannot be assigned to triggers and patterns any more; the whole sequence has to be taken again."""


class DeviceLost(DeviceError):
    """A device does not answer any more; it has to be connected again, and its state is unknown."""


class PluginError(DeviceError):
    """A driver plugin cannot be loaded."""
