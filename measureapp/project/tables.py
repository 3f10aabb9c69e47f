"""CSV tables of poses, guide positions, corners and table angles."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.atomic import write_text

POSE_COLUMNS = ("name", "x_mm", "y_mm", "z_mm", "qw", "qx", "qy", "qz")
GUIDE_COLUMNS = ("name", "position_mm")
CORNER_COLUMNS = ("position", "corner", "x_mm", "y_mm", "z_mm")
ANGLE_COLUMNS = ("position", "angle_deg")
DECIMAL_COMMA = re.compile(r"^([+-]?\d*),(\d+(?:[eE][+-]?\d+)?)$")
UNIT_TOLERANCE = 1e-3
METRES_BELOW = 5.0  # positions that are all below 5 mm are in metres
Value = TypeVar("Value")


@dataclass(frozen=True, slots=True, eq=False)
class CornerTable:
    """Corners at several table positions."""

    corners_mm: FloatArray  # (n, m, 3)
    angles_rad: FloatArray | None  # (n,), if the file has them


@dataclass(frozen=True, slots=True)
class _Row:
    path: Path
    line: int
    cells: Mapping[str, str]

    def error(self, what: str, hint: str = "Correct this line.") -> InputError:
        return InputError(f"{self.path}, line {self.line}: {what}.", hint)

    def number(self, column: str) -> float:
        text = self.cells[column].strip()
        try:
            value = float(text)
        except ValueError:
            raise self.error(f"{column} is {text!r}, not a number", "Write numbers with a decimal point.") from None
        if not math.isfinite(value):
            raise self.error(f"{column} is {text!r}, not a finite number")
        return value

    def index(self, column: str) -> int:
        value = self.number(column)
        if value != int(value) or value < 0:
            raise self.error(f"{column} is {self.cells[column].strip()!r}, not a whole number of at least 0")
        return int(value)


def natural_order(name: str) -> tuple[tuple[int, int, str], ...]:
    """Return a sorting key in which ``pose2`` comes before ``pose10``."""
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part) for part in re.split(r"(\d+)", name) if part)


def read_poses(path: Path, to_frame: str, from_frame: str) -> dict[str, RigidTransform]:
    """Read ``name,x_mm,y_mm,z_mm,qw,qx,qy,qz``, sorted by name.

    Raises
    ------
    InputError
        The file cannot be read, a column is missing or unknown, a value is not a number, a quaternion is not normalised, or a
        name occurs twice; the message names file and line.
    """

    def pose(row: _Row) -> RigidTransform:
        quaternion = np.array([row.number(column) for column in ("qw", "qx", "qy", "qz")])
        length = float(np.linalg.norm(quaternion))
        if abs(length - 1.0) > UNIT_TOLERANCE:
            raise row.error(
                f"the quaternion (qw, qx, qy, qz) has length {length:.4g}, not 1",
                "Give a unit quaternion, scalar first; not angles in degrees.",
            )
        shift = [row.number(column) for column in ("x_mm", "y_mm", "z_mm")]
        return RigidTransform.from_quaternion(quaternion / length, shift, to_frame, from_frame)

    named = _by_name(_read_rows(path, POSE_COLUMNS), pose)
    return {name: named[name] for name in sorted(named, key=natural_order)}


def write_poses(path: Path, poses: Mapping[str, RigidTransform]) -> None:
    """Write poses in the format of `read_poses`, atomically."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(POSE_COLUMNS)
    for name, pose in poses.items():
        writer.writerow([name, *(repr(float(value)) for value in (*pose.translation_mm, *pose.quaternion_wxyz))])
    write_text(Path(path), text.getvalue())


def require_millimetres(path: Path, poses: Mapping[str, RigidTransform]) -> None:
    """Refuse poses whose positions are all within 5 mm of the origin: they are in metres. Raises InputError."""
    distances = [float(np.linalg.norm(pose.translation_mm)) for pose in poses.values()]
    if distances and 0 < max(distances) < METRES_BELOW:
        raise InputError(
            f"{path}: no position is further than {max(distances):.3g} mm from the origin.", "Convert the positions from metres to mm."
        )


def read_guide(path: Path) -> dict[str, float]:
    """Read ``name,position_mm``. Raises InputError naming file and line."""
    return _by_name(_read_rows(path, GUIDE_COLUMNS), lambda row: row.number("position_mm"))


def read_angles(path: Path) -> dict[int, float]:
    """Read ``position,angle_deg`` as position → radians, sorted by position. Raises InputError naming file and line."""
    angles: dict[int, float] = {}
    for row in _read_rows(path, ANGLE_COLUMNS):
        position = row.index("position")
        if position in angles:
            raise row.error(f"position {position} occurs twice")
        angles[position] = math.radians(row.number("angle_deg"))
    return dict(sorted(angles.items()))


def read_corners(path: Path) -> CornerTable:
    """Read ``position,corner,x_mm,y_mm,z_mm[,angle_deg]``; corners missing at some position are dropped.

    Raises
    ------
    InputError
        As for the other tables; or no corner is common to all positions, or a position has two angles.
    """
    points: dict[int, dict[int, list[float]]] = {}
    angles: dict[int, float] = {}
    for row in _read_rows(path, CORNER_COLUMNS, ("angle_deg",)):
        position, corner = row.index("position"), row.index("corner")
        if corner in points.setdefault(position, {}):
            raise row.error(f"corner {corner} occurs twice at position {position}")
        points[position][corner] = [row.number(column) for column in ("x_mm", "y_mm", "z_mm")]
        if row.cells.get("angle_deg", "").strip():
            angle = math.radians(row.number("angle_deg"))
            if abs(angles.setdefault(position, angle) - angle) > 1e-9:
                raise row.error(f"position {position} has two different angles")
    order = sorted(points)
    shared = sorted(set.intersection(*(set(points[position]) for position in order)))
    if not shared:
        raise InputError(f"{path}: no corner is common to all positions.", "Number the corners the same way at all positions.")
    if angles and len(angles) != len(order):
        raise InputError(
            f"{path}: only {len(angles)} of {len(order)} positions have an angle.", "Give the angles of all positions, or none."
        )
    corners = np.array([[points[position][corner] for corner in shared] for position in order])
    return CornerTable(corners, np.array([angles[position] for position in order]) if angles else None)


def _read_rows(path: Path, columns: Sequence[str], optional: Sequence[str] = ()) -> list[_Row]:
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", "Check the path.") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path} is not a text file.", "Give comma-separated values in UTF-8.") from error
    semicolons = ";" in text.partition("\n")[0]  # as spreadsheets write where the comma is the decimal point
    reader = csv.reader(io.StringIO(text), delimiter=";" if semicolons else ",")
    header: list[str] | None = None
    rows = []
    for written in reader:
        cells = [DECIMAL_COMMA.sub(r"\1.\2", cell.strip()) for cell in written] if semicolons else written
        if not any(cell.strip() for cell in cells):
            continue
        if header is None:
            header = [cell.strip() for cell in cells]
            _check_header(path, header, columns, optional)
            continue
        if len(cells) != len(header):
            raise InputError(f"{path}, line {reader.line_num}: {len(cells)} values under {len(header)} columns.", "Correct this line.")
        rows.append(_Row(path, reader.line_num, dict(zip(header, cells, strict=True))))
    if not rows:
        raise InputError(f"{path} has no rows of values.", "Add rows below the header " + ",".join(columns) + ".")
    return rows


def _check_header(path: Path, header: Sequence[str], columns: Sequence[str], optional: Sequence[str]) -> None:
    wanted = "Write the header " + ",".join(columns) + "".join(f"[,{name}]" for name in optional) + "."
    missing = [name for name in columns if name not in header]
    if missing:
        raise InputError(f"{path}, line 1: the column {missing[0]!r} is missing.", wanted)
    foreign = [name for name in header if name not in (*columns, *optional)]
    if foreign or len(set(header)) != len(header):
        raise InputError(f"{path}, line 1: the column {(foreign or header)[0]!r} is unknown or occurs twice.", wanted)


def _by_name(rows: Sequence[_Row], value: Callable[[_Row], Value]) -> dict[str, Value]:
    named: dict[str, Value] = {}
    for row in rows:
        name = row.cells["name"].strip()
        if not name or name in named:
            raise row.error(f"the name {name!r} is empty or occurs twice")
        named[name] = value(row)
    return named
