"""The one tree of errors. Each says what happened and what the user can do about it."""

from __future__ import annotations


class MeasureError(Exception):
    """Something the user can be told about in one sentence, with a remedy.

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
    """Two transforms or clouds were chained whose frames do not meet."""


class PlanError(MeasureError):
    """A scan plan asks for something the rig cannot do."""


class DecodeError(MeasureError):
    """Fringe images do not determine the phase."""


class ReconstructError(MeasureError):
    """Phase maps and cameras do not give points."""


class CalibrationError(MeasureError):
    """A calibration has no answer, or does not fit the rig it is used with."""


class RegistrationError(MeasureError):
    """Clouds cannot be brought together."""


class InspectionError(MeasureError):
    """A feature or dimension has no answer."""


class UnitQuestion(InspectionError):
    """Lengths look like another unit than they were taken in; only the user can say which it is.

    Parameters
    ----------
    what : "points" or "nominal"
    unit : the likely unit, as `measureapp.data.length_unit.LengthUnit` names it
    finding : why it looks so, a sentence without its stop
    """

    def __init__(self, message: str, hint: str, what: str, unit: str, finding: str) -> None:
        super().__init__(message, hint)
        self.what, self.unit, self.finding = what, unit, finding


class FitError(MeasureError):
    """Points do not determine the shape asked for."""


class StorageError(MeasureError):
    """A project cannot be read or written (disk full, damaged, not a project)."""


class DeviceError(MeasureError):
    """A device failed, refused or did not answer."""


class LimitError(DeviceError):
    """A move was refused because its goal lies outside an axis's limits."""


class DeviceTimeout(DeviceError):
    """A device did not finish in time."""


class PluginError(DeviceError):
    """A driver plugin cannot be loaded."""
