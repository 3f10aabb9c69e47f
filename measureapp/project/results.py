"""Files of results: clouds, mesh and one document; `process` can recompute them at any time."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import CloudQuality, PointCloud
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.errors import FrameMismatch, InputError, MeasureError, StorageError
from measureapp.project.atomic import replacing_together, write_json
from measureapp.project.documents import (
    consistency_document,
    consistency_from,
    inspection_document,
    inspection_from,
    loop_closure_document,
    loop_closure_from,
    placement_document,
    placement_from,
    readback_document,
    readback_from,
    setup_document,
    setup_from,
    shift_document,
    shift_from,
    transform_document,
    transform_from,
    validity_document,
    validity_from,
)
from measureapp.project.geometry.files import read_mesh, read_point_cloud, read_stitched, write_cloud, write_mesh
from measureapp.project.journal.entries import Entry
from measureapp.project.journal.state import RESULTS, Compared
from measureapp.project.large_clouds import map_large
from measureapp.project.text_document import check_version

DOCUMENT, STITCHED, MESH, CLOUDS = "measurement.json", "stitched_cloud.ply", "mesh.ply", "clouds"
KEPT = DEVIATION, PICTURES = "deviation.npz", "report_pictures.npz"  # compared with the journal where they are used, see `kept_arrays`
FORMAT = 1


def cloud_path(folder: Path, viewpoint_id: str) -> Path:
    """Return the file of the cloud of one view."""
    return folder / CLOUDS / f"{viewpoint_id}.ply"


def save(
    folder: Path, measurement: Measurement, inputs: Mapping[str, Any] | None = None, compared: Mapping[str, Compared] | None = None
) -> None:
    """Write a measurement; an earlier one is replaced when all files of the new one are written.

    Parameters
    ----------
    inputs : what it was computed from, see `inputs.current_inputs`
    compared : the files of it that were found equal to the journal, so that they are not read to compare them again
    """
    with replacing_together(folder, Entry(RESULTS, {}, "", {"inputs": dict(inputs or {})}), stale=(MESH, f"{CLOUDS}/*.ply")) as staging:
        for view in measurement.views:
            write_cloud(cloud_path(staging, view.viewpoint_id), view.cloud)
            view.cloud.give_up_pages()
        write_cloud(staging / STITCHED, measurement.stitched)
        if measurement.mesh is not None:
            write_mesh(staging / MESH, measurement.mesh)
        write_json(staging / DOCUMENT, _document(measurement, inputs, compared))


def save_document(
    folder: Path, measurement: Measurement, inputs: Mapping[str, Any] | None = None, compared: Mapping[str, Compared] | None = None
) -> None:
    """Write a measurement without its clouds and mesh."""
    with replacing_together(folder, Entry(RESULTS, {}, "", {"inputs": dict(inputs or {})})) as staging:
        write_json(staging / DOCUMENT, _document(measurement, inputs, compared))


def read_compared(folder: Path) -> dict[str, Compared]:
    """Return the files that were found equal to the journal when the results were computed; none where that cannot be read."""
    try:
        document = json.loads((folder / DOCUMENT).read_text(encoding="utf-8"))
        return {str(name): (int(size), int(time), str(sha)) for name, (size, time, sha) in document.get("compared", {}).items()}
    except (OSError, ValueError, TypeError, AttributeError, RecursionError):
        return {}


def _document(measurement: Measurement, inputs: Mapping[str, Any] | None, compared: Mapping[str, Compared] | None) -> dict[str, Any]:
    return {
        "schema_version": FORMAT,
        "inputs": dict(inputs or {}),
        "compared": dict(compared or {}),
        "stitched_from": measurement.stitched_from,
        **{name: getattr(measurement, name) for name in ("project", "part", "rig", "measured_at", "settings", "timings_s")},
        "views": [_view_document(view) for view in measurement.views],
        "placements": [placement_document(placement) for placement in measurement.stitched.placements],
        "notes": dict(measurement.stitched.notes),
        **({"setups": [setup_document(setup) for setup in measurement.setups]} if measurement.setups else {}),
        "ring": loop_closure_document(measurement.stitched.loop_closure),
        "validity": validity_document(measurement.validity),
        "consistency": consistency_document(measurement.consistency),
        "inspection": None if measurement.inspection is None else inspection_document(measurement.inspection),
    }


def load(folder: Path, calibration: RigCalibration, *, clouds: bool = True) -> Measurement | None:
    """Load the stored measurement; None if there is none.

    Parameters
    ----------
    clouds : whether to read the clouds of the single views, too; without they are empty, for what needs the stitched one alone

    Raises
    ------
    StorageError
        It is damaged.
    """
    path = folder / DOCUMENT
    if not path.exists():
        return None
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        check_version(path, document, FORMAT)
        validity = validity_from(document.get("validity", {}))
        stitched = replace(
            read_stitched(folder / STITCHED),
            axis_doubt=validity.axes,
            placements=tuple(placement_from(placement) for placement in document["placements"]),
            notes=document["notes"],
            loop_closure=loop_closure_from(document.get("ring")),
        )
        return Measurement(
            **{name: document[name] for name in ("project", "part", "rig", "measured_at", "settings", "timings_s")},
            calibration=calibration,
            views=tuple(_view_from(folder, view, clouds) for view in document["views"]),
            stitched=stitched,
            mesh=read_mesh(folder / MESH, "part") if (folder / MESH).exists() else None,
            inspection=None if document["inspection"] is None else inspection_from(document["inspection"]),
            validity=validity,
            consistency=consistency_from(document.get("consistency", {})),
            setups=tuple(setup_from(setup) for setup in document.get("setups", ())),
            stitched_from=document.get("stitched_from", ""),
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError, InputError, FrameMismatch) as error:
        reason = error.message if isinstance(error, MeasureError) else f"{error}."
        raise StorageError(f"The results in {folder} cannot be read: {reason}", "Recompute them: measureapp process PROJECT.") from error


def _view_document(view: ViewResult) -> dict[str, Any]:
    return {
        "viewpoint_id": view.viewpoint_id,
        "quality": asdict(view.quality),
        "part_from_camera": transform_document(view.part_from_camera),
        "decode": {camera: dict(figures) for camera, figures in view.decode.items()},
        "pairs": [dict(pair) for pair in view.pairs],
        "rejected": dict(view.rejected),
        "readback": readback_document(view.readback),
        "timings_s": dict(view.timings_s),
        "findings": list(view.findings),
        "shift": None if view.shift is None else shift_document(view.shift),
        "made_from": view.made_from,
    }


def _view_from(folder: Path, document: Mapping[str, Any], clouds: bool) -> ViewResult:
    name = _known_id(document["viewpoint_id"])
    return ViewResult(
        viewpoint_id=name,
        cloud=map_large(read_point_cloud(cloud_path(folder, name)), folder) if clouds else PointCloud.empty("camera", name),
        quality=CloudQuality(**document["quality"]),
        part_from_camera=transform_from(document["part_from_camera"]),
        decode=document["decode"],
        pairs=tuple(document["pairs"]),
        rejected=document["rejected"],
        readback=readback_from(document["readback"]),
        timings_s=document.get("timings_s", {}),
        findings=tuple(document.get("findings", ())),
        shift=None if document.get("shift") is None else shift_from(document["shift"]),
        made_from=document.get("made_from", ""),
    )


def _known_id(name: str) -> str:
    """Return an id that names a file below the folder. Raises ValueError for any other."""
    if not re.fullmatch(r"\w[\w .@+-]*", name):
        raise ValueError(f"{name!r} is not the id of a viewpoint")
    return name
