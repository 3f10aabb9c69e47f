"""Predicted standard deviations of the planner against those of measured clouds, and against how their points truly scatter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.closed_loop.coverage import MeasuredCoverage, measure_coverage
from measureapp.pipeline.prediction.fringe_noise import fringe_noise
from measureapp.pipeline.prediction.measured_light import light_of_views
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.visibility import seen_by
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh

NEAR_MM, NEIGHBOURS = 1.0, 40
PARAMETERS = 3  # of the plane that neighbours have in common


@dataclass(frozen=True)
class SigmaRatios:
    """Medians over all samples of all views."""

    assumed_over_stated: float  # predicted for a part that just saturates
    predicted_over_stated: float  # predicted for its brightness
    predicted_over_scatter: float


def sigma_ratios(project: ProjectFolder, nominal: Mesh, samples: int = 2000) -> SigmaRatios:
    """Compare the prediction for a measured project of the virtual rig."""
    measurement, plan, rig = project.measurement(), project.plan(), project.rig()
    assert measurement is not None and plan is not None
    coverage = measure_coverage(measurement, plan, nominal, rig, NoProgress(), samples=samples)
    light = light_of_views(measurement.views, measurement.calibration, rig)
    assumed, known = (
        seen_by(
            coverage.viewpoints,
            coverage.samples,
            rig,
            coverage.scene,
            VisibilityLimits(fringes=fringe_noise(plan.patterns, plan.bracket.exposures_us, rig, project.noise(), one)),
        ).sigma_mm
        for one in (None, light)
    )
    truth = NominalSurface(read_mesh(project.results / "truth_mesh.ply"))
    stated, scatter = np.full(assumed.shape, np.nan), np.full(assumed.shape, np.nan)
    clouds = {view.viewpoint_id: view.cloud for view in measurement.views}
    placed = {one.viewpoint_id: one.part_from_camera for one in measurement.stitched.placements}
    for row, viewpoint in enumerate(coverage.viewpoints):
        cloud, pose = clouds[viewpoint.id], placed[viewpoint.id]
        distance, index = cKDTree(coverage.poses[row].apply(cloud.points_mm)).query(coverage.samples.points_mm)
        seen = np.flatnonzero((distance < NEAR_MM) & np.isfinite(assumed[row]) & _facing(coverage, row, cloud.normals[index]))
        stated[row, seen] = cloud.sigma_mm[index[seen]]
        scatter[row, seen] = _scatter(pose.apply(cloud.points_mm), index[seen], np.asarray(pose.translation_mm), truth)
    return SigmaRatios(*(float(np.nanmedian(ratio)) for ratio in (assumed / stated, known / stated, known / scatter)))


def _facing(coverage: MeasuredCoverage, row: int, normals: np.ndarray) -> np.ndarray:
    turned = coverage.poses[row].rotate(np.asarray(normals, float))
    return np.asarray(np.einsum("ni,ni->n", turned, coverage.samples.normals) > 0.5)


def _scatter(points: np.ndarray, chosen: np.ndarray, eye: np.ndarray, truth: NominalSurface) -> np.ndarray:
    """Robust scatter along the viewing rays of the neighbours of chosen points, without what they have in common: calibration, pose."""
    _, near = cKDTree(points).query(points[chosen], NEIGHBOURS)
    away = signed_distances(points[near.reshape(-1)], truth).reshape(near.shape)
    ray = points[chosen] - eye
    ray /= np.linalg.norm(ray, axis=1, keepdims=True)
    right = np.cross(ray, np.eye(3)[np.abs(ray).argmin(axis=1)])
    right /= np.linalg.norm(right, axis=1, keepdims=True)
    beside = points[near] - points[chosen][:, None]
    found = np.empty(len(chosen))
    for number, (offsets, distances) in enumerate(zip(beside, away, strict=True)):
        # across the ray only: along it lies the noise itself
        across = np.column_stack([offsets @ right[number], offsets @ np.cross(ray[number], right[number]), np.ones(NEIGHBOURS)])
        fitted = np.linalg.lstsq(across, distances, rcond=None)[0]
        rest = distances - across @ fitted
        found[number] = 1.4826 * np.median(np.abs(rest)) * np.sqrt(NEIGHBOURS / (NEIGHBOURS - PARAMETERS))
    return found / np.maximum(_cosines(points, near, ray), 0.2)


def _cosines(points: np.ndarray, near: np.ndarray, ray: np.ndarray) -> np.ndarray:
    """Cosines between rays and the normals of the neighbours' planes."""
    centred = points[near] - points[near].mean(axis=1, keepdims=True)
    normals = np.linalg.svd(centred, full_matrices=False)[2][:, 2]
    return np.asarray(np.abs(np.einsum("ni,ni->n", normals, ray)))
