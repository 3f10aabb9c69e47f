"""The nominal of the part for which a scan is planned, prepared for drawing, clicking and prediction."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.mesh import Mesh
    from measureapp.data.part_pose import PartPose
    from measureapp.data.rig import RigDescription
    from measureapp.planning.collision.build import PartSolid
    from measureapp.planning.coverage.samples import SurfaceSamples
    from measureapp.planning.coverage.scene import PartScene
    from ui.workers.job import Job

DRAWN_TRIANGLES = 120_000
SAME_SIDE = 0.5  # cosine of normals


@dataclass(frozen=True, eq=False)
class PreparedPart:
    """A nominal in the frame `part`: origin in the middle of the table's top."""

    path: Path
    mesh: Mesh
    solid: PartSolid
    scene: PartScene
    samples: SurfaceSamples
    corners_mm: np.ndarray  # (T, 3, 3) float32, triangles that are drawn
    normals: np.ndarray  # (T, 3) float32
    sample_of: np.ndarray  # (T,) the sample that stands for a triangle


class PlanPart(QObject):
    """Reads the nominal: the project's, the sample part's, or a file that was chosen."""

    changed = Signal()

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self.prepared: PreparedPart | None = None
        self._chosen: Path | None = None  # by a person; None: that of the project
        self._wanted: tuple[Path, RigDescription, PartPose | None] | None = None
        self._is_watched = False
        session.projectChanged.connect(self._follow_project)
        session.rigChanged.connect(self._follow)
        session.planChanged.connect(self._follow)  # it states how the part stands

    @property
    def path(self) -> Path | None:
        """The nominal for which is planned; None if there is none."""
        return self._chosen or nominal_of(self._session)

    @Slot(object)
    def choose(self, path: Path) -> None:
        """Read a nominal from a file, also once more."""
        self._chosen, self._wanted = path, None
        self._read(path)

    def set_watched(self, watched: bool) -> None:
        """Read the nominal of a project only when somebody looks at the plan."""
        self._is_watched = watched
        self._follow()

    @Slot()
    def _follow_project(self) -> None:
        if nominal_of(self._session) is not None:  # a project without one is scanned with the nominal that was chosen
            self._chosen = None
        self._follow()

    @Slot()
    def _follow(self) -> None:
        path = self.path
        if path is not None and self._is_watched:
            self._read(path)

    def _read(self, path: Path) -> None:
        rig, plan = self._session.rig, self._session.plan
        pose = None if plan is None else plan.part_pose
        if rig is not None and self._wanted != (path, rig, pose):
            self._wanted = (path, rig, pose)
            self._runner.run(tr("Reading {name}", name=path.name), lambda job: prepare(path, rig, pose, job), self._show, quiet=True)

    @Slot(object)
    def _show(self, prepared: PreparedPart) -> None:
        self.prepared = prepared
        self.changed.emit()


def nominal_of(session: Session) -> Path | None:
    """Return the nominal of the open project, or of the sample part; None if there is none."""
    from measureapp.resources import resource

    if session.folder is not None:
        found = sorted(path for path in (session.folder / "inspection").glob("nominal.*") if path.is_file())
        if found:
            return found[0]
    if not session.part:
        return None
    sample = Path(session.part) if Path(session.part).suffix else Path(str(resource("parts"))) / session.part / "nominal.stl"
    return sample if sample.is_file() else None


def prepare(path: Path, rig: RigDescription, pose: PartPose | None, job: Job) -> PreparedPart:
    """Read and sample a nominal as it stands on the table, upright without a pose; runs on a job's thread."""
    from measureapp.pipeline.plan_coverage import SAMPLES, place_on_table
    from measureapp.planning.collision.build import PartSolid
    from measureapp.planning.coverage.samples import sample_surface
    from measureapp.planning.coverage.scene import PartScene
    from measureapp.project.geometry.files import read_mesh

    job.report(0, 3, path.name)
    mesh = place_on_table(read_mesh(path), pose)
    job.report(1, 3, path.name)
    scene = PartScene.of(mesh, rig)
    samples = sample_surface(scene, SAMPLES)
    job.report(2, 3, path.name)
    corners = _drawn(mesh)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    nearest = _nearest_sample(corners, normals, samples)
    return PreparedPart(path, mesh, PartSolid.of_points(mesh.vertices_mm), scene, samples, corners, normals.astype(np.float32), nearest)


def _drawn(mesh: Mesh) -> np.ndarray:
    """Return the triangles (T, 3, 3) that are drawn, fewer for a dense mesh."""
    vertices, triangles = np.asarray(mesh.vertices_mm), np.asarray(mesh.triangles)
    if len(triangles) > DRAWN_TRIANGLES:
        import open3d

        dense = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(vertices), open3d.utility.Vector3iVector(triangles))
        cell_mm = float(np.sqrt(dense.get_surface_area() * 2.0 / DRAWN_TRIANGLES))
        coarse = dense.simplify_vertex_clustering(cell_mm)
        vertices, triangles = np.asarray(coarse.vertices), np.asarray(coarse.triangles)
    return vertices[triangles].astype(np.float32)


def _nearest_sample(corners: np.ndarray, normals: np.ndarray, samples: SurfaceSamples) -> np.ndarray:
    """Return the nearest sample on the same side of the surface for every triangle."""
    from scipy.spatial import cKDTree

    _, near = cKDTree(samples.points_mm).query(corners.mean(axis=1), k=min(8, len(samples)))
    near = near.reshape(len(corners), -1)
    facing = np.einsum("nki,ni->nk", samples.normals[near], normals) > SAME_SIDE
    return np.take_along_axis(near, facing.argmax(axis=1)[:, None], axis=1)[:, 0]
