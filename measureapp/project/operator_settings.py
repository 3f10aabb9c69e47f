"""Settings of operator mode, in a small file below the user's home: folders, shifts, and what was last in use."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime, time, timedelta
from pathlib import Path
from typing import Literal

from pydantic import Field, ValidationError, field_validator

from measureapp.data.model import Model, first_problem
from measureapp.data.rig import Resolution
from measureapp.errors import StorageError
from measureapp.project.atomic import write_text

KEPT_TIMES = 5  # durations of the last runs of a program, from which the next one is estimated


class OperatorSettings(Model):
    """What operator mode needs to know besides the part programs."""

    schema_version: Literal[1] = 1
    programs: str = Field(default="", description="folder of the part programs; empty: MeasureApp/programs in the user's home")
    parts: str = Field(default="", description="folder of the measured parts; empty: MeasureApp/parts in the user's home")
    calibrated: str = Field(default="", description="project whose calibration is used")
    shift_starts: tuple[str, ...] = Field(default=("06:00", "14:00", "22:00"), min_length=1)
    idle_minutes: float = Field(default=10.0, gt=0, le=1440, description="without input, after which the engineer's role ends")
    virtual_resolution: Resolution = Field(default="quarter", description="of the cameras of the virtual rig")
    seconds: Mapping[str, tuple[float, ...]] = Field(default={}, description="duration of the last runs of each program")
    operator: str = Field(default="", max_length=200, description="name that was stated last")

    @field_validator("shift_starts")
    @classmethod
    def _are_times(cls, starts: tuple[str, ...]) -> tuple[str, ...]:
        for start in starts:
            try:
                time.fromisoformat(start)
            except ValueError as error:
                raise ValueError(f"{start!r} is not a time such as 06:00") from error
        return starts

    @property
    def programs_folder(self) -> Path:
        """Folder of the part programs."""
        return Path(self.programs) if self.programs else Path.home() / "MeasureApp" / "programs"

    @property
    def parts_folder(self) -> Path:
        """Folder of the measured parts."""
        return Path(self.parts) if self.parts else Path.home() / "MeasureApp" / "parts"

    def shift_start(self, now: datetime) -> datetime:
        """Return when the shift of the moment ``now`` (with a zone) began."""
        starts = sorted(time.fromisoformat(start) for start in self.shift_starts)
        today = [now.replace(hour=one.hour, minute=one.minute, second=0, microsecond=0) for one in starts]
        begun = [one for one in today if one <= now]
        return begun[-1] if begun else today[-1] - timedelta(days=1)

    def with_duration(self, program: str, seconds: float) -> OperatorSettings:
        """Return the settings with the duration of one more run of a program."""
        kept = (*self.seconds.get(program, ()), round(seconds, 1))[-KEPT_TIMES:]
        return self.model_copy(update={"seconds": {**self.seconds, program: kept}})

    def usual_seconds(self, program: str) -> float | None:
        """Return the median duration of the last runs of a program; None before the first one."""
        kept = sorted(self.seconds.get(program, ()))
        return kept[len(kept) // 2] if kept else None


def operator_file() -> Path:
    """Return the file of the settings."""
    return Path.home() / "MeasureApp" / "operator.json"


def read_operator_settings(file: Path) -> OperatorSettings:
    """Return the settings; the defaults if there are none. Raises StorageError where the file is damaged."""
    if not file.exists():
        return OperatorSettings()
    try:
        return OperatorSettings.model_validate_json(file.read_bytes())
    except OSError as error:
        raise StorageError(f"{file} cannot be read: {error.strerror or error}.", "Check the permissions.") from error
    except ValidationError as error:
        raise StorageError(
            f"{file} is damaged: {first_problem(error, 'the settings')}.", "Correct it, or delete it and set operator mode up again."
        ) from error


def write_operator_settings(file: Path, settings: OperatorSettings) -> None:
    """Store the settings. Raises StorageError."""
    write_text(file, settings.model_dump_json(indent=2))
