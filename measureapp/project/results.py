"""Files of results: clouds, mesh and one document; `process` can recompute them at any time."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import CloudQuality
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.errors import InputError, StorageError
from measureapp.project.atomic import write_json
from measureapp.project.documents import (
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
    transform_document,
    transform_from,
    validity_document,
    validity_from,
)
from measureapp.project.geometry.files import read_mesh, read_point_cloud, read_stitched, write_cloud, write_mesh

DOCUMENT, STITCHED, MESH = "measurement.json", "stitched_cloud.ply", "mesh.ply"


def cloud_path(folder: Path, viewpoint_id: str) -> Path:
    """Return the file of the cloud of one view."""
    return folder / "clouds" / f"{viewpoint_id}.ply"


def save(folder: Path, measurement: Measurement) -> None:
    """Write a measurement; the document last, so that its absence marks incomplete results."""
    (folder / DOCUMENT).unlink(missing_ok=True)
    for view in measurement.views:
        write_cloud(cloud_path(folder, view.viewpoint_id), view.cloud)
    write_cloud(folder / STITCHED, measurement.stitched)
    if measurement.mesh is None:
        (folder / MESH).unlink(missing_ok=True)
    else:
        write_mesh(folder / MESH, measurement.mesh)
    save_document(folder, measurement)


def save_document(folder: Path, measurement: Measurement) -> None:
    """Write a measurement without its clouds and mesh."""
    document = {
        "schema_version": 1,
        **{name: getattr(measurement, name) for name in ("project", "part", "rig", "measured_at", "settings", "timings_s")},
        "views": [_view_document(view) for view in measurement.views],
        "placements": [placement_document(placement) for placement in measurement.stitched.placements],
        "notes": dict(measurement.stitched.notes),
        **({"setups": [setup_document(setup) for setup in measurement.setups]} if measurement.setups else {}),
        "ring": loop_closure_document(measurement.stitched.loop_closure),
        "validity": validity_document(measurement.validity),
        "inspection": None if measurement.inspection is None else inspection_document(measurement.inspection),
    }
    write_json(folder / DOCUMENT, document)


def load(folder: Path, calibration: RigCalibration) -> Measurement | None:
    """Load the stored measurement; None if there is none. Raises StorageError when it is damaged."""
    path = folder / DOCUMENT
    if not path.exists():
        return None
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        stitched = replace(
            read_stitched(folder / STITCHED),
            placements=tuple(placement_from(placement) for placement in document["placements"]),
            notes=document["notes"],
            loop_closure=loop_closure_from(document.get("ring")),
        )
        return Measurement(
            **{name: document[name] for name in ("project", "part", "rig", "measured_at", "settings", "timings_s")},
            calibration=calibration,
            views=tuple(_view_from(folder, view) for view in document["views"]),
            stitched=stitched,
            mesh=read_mesh(folder / MESH, "part") if (folder / MESH).exists() else None,
            inspection=None if document["inspection"] is None else inspection_from(document["inspection"]),
            validity=validity_from(document.get("validity", {})),
            setups=tuple(setup_from(setup) for setup in document.get("setups", ())),
        )
    except (OSError, ValueError, KeyError, TypeError, InputError) as error:
        reason = error.message if isinstance(error, InputError) else f"{error}."
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
    }


def _view_from(folder: Path, document: Mapping[str, Any]) -> ViewResult:
    return ViewResult(
        viewpoint_id=document["viewpoint_id"],
        cloud=read_point_cloud(cloud_path(folder, document["viewpoint_id"])),
        quality=CloudQuality(**document["quality"]),
        part_from_camera=transform_from(document["part_from_camera"]),
        decode=document["decode"],
        pairs=tuple(document["pairs"]),
        rejected=document["rejected"],
        readback=readback_from(document["readback"]),
        timings_s=document.get("timings_s", {}),
        findings=tuple(document.get("findings", ())),
    )
