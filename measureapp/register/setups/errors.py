"""Error model of joined set-ups: the errors of each, how the joint follows them, and the errors of the joint itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate, pairwise

import numpy as np
from scipy.linalg import block_diag

from measureapp.arrays import FloatArray
from measureapp.data.view_errors import (
    DIRECTION_REACH_RAD,
    POSE,
    POWERS,
    CloudDistortion,
    FormErrors,
    SystematicErrors,
    ViewErrors,
    factor_covariance,
    smooth_basis,
)
from measureapp.geometry.transform import RigidTransform
from measureapp.register.setups.joint import Joint, JointEdge, SurfacePoints, rigid_gain, shift_origin

MOST_POINTS = 3000  # of an edge; errors of views vary slowly over the surface


def join_errors(members: Sequence[ViewErrors], calibrations: Sequence[str], joint: Joint) -> ViewErrors:
    """Combine the errors of all set-ups in the part frame.

    Errors of registration and form are independent between set-ups. Those of one calibration, and systematic errors by light and blur, are
    common. The joint is determined by surfaces that have these errors, and follows them; noise and form errors of these surfaces, which
    their residuals show, are the contribution of the joint itself.

    Parameters
    ----------
    members : in the frame of each set-up
    calibrations : id of each set-up's calibration; the same id means the same errors
    """
    placed = [
        errors.seen_from(RigidTransform(pose.matrix, pose.to_frame, errors.poses[0].to_frame))
        for errors, pose in zip(members, joint.part_from_setup, strict=False)  # the nominal may follow
    ]
    counts = [len(errors.poses) for errors in placed]
    starts = [0, *accumulate(counts)]
    distortion, calibration_motions = _join_calibrations(placed, calibrations)
    together = ViewErrors(
        poses=tuple(pose for errors in placed for pose in errors.poses),
        centres_mm=np.vstack([errors.centres_mm for errors in placed]),
        stitching_motions=block_diag(*[errors.stitching_motions for errors in placed]),
        calibration_motions=calibration_motions,
        distortion=distortion,
        form=_join_form([errors.form for errors in placed], counts),
        systematic=_join_systematic([errors.systematic for errors in placed]),
        unexplained_mm=max(errors.unexplained_mm for errors in placed),
    )
    followed = _follow(together, joint, starts)
    return replace(followed, setup_motions=_spread(factor_covariance(joint.covariance), together.centres_mm, starts))


def _spread(motions: FloatArray, centres_mm: FloatArray, starts: Sequence[int]) -> FloatArray:
    """Return the motions (6V, K) of all views by motions (6S, K) of the set-ups about the origin."""
    rows = []
    for number, (first, last) in enumerate(pairwise(starts)):
        own = motions[POSE * number : POSE * (number + 1)]
        rows += [shift_origin(centre) @ own for centre in centres_mm[first:last]]
    return np.vstack(rows)


def _follow(together: ViewErrors, joint: Joint, starts: Sequence[int]) -> ViewErrors:
    """Add the motions of the set-ups by which the joint follows errors of the surfaces that determine it."""
    changes: dict[str, list[FloatArray]] = {}
    for edge in joint.edges:
        for name, change in _edge_changes(together, edge, starts).items():
            changes.setdefault(name, []).append(change)
    gains = joint.gains()  # also of the nominal, if it takes part
    moved = {name: _spread(gains @ np.vstack(edges), together.centres_mm, starts) for name, edges in changes.items()}
    systematic = together.systematic
    return replace(
        together,
        stitching_motions=together.stitching_motions + moved["stitching"],
        calibration_motions=together.calibration_motions + moved.get("calibration", 0.0),
        systematic=None if systematic is None else replace(systematic, motions=systematic.motions + moved["common"]),
    )


def _edge_changes(together: ViewErrors, edge: JointEdge, starts: Sequence[int]) -> dict[str, FloatArray]:
    """Return the change (6, K) of an edge by each error, by contribution: target's errors less the source's."""
    total: dict[str, FloatArray] = {}
    for sign, number, surface in ((1.0, edge.target, edge.target_points), (-1.0, edge.source, edge.source_points)):
        if number + 1 >= len(starts):  # the nominal has no errors
            continue
        few = _thin(surface)
        displaced = together.along(few.points_mm, few.normals, few.view + starts[number])
        gain = sign * rigid_gain(few)
        for name in ("stitching", "calibration", "common"):
            if name in displaced:
                total[name] = total.get(name, 0.0) + gain @ displaced[name]
    return total


def _thin(surface: SurfacePoints) -> SurfacePoints:
    step = max(1, -(-len(surface.points_mm) // MOST_POINTS))
    return SurfacePoints(surface.points_mm[::step], surface.normals[::step], surface.view[::step])


def _join_calibrations(members: Sequence[ViewErrors], calibrations: Sequence[str]) -> tuple[CloudDistortion | None, FloatArray]:
    """Return distortion and motions by the errors of all calibrations; one block of columns per calibration."""
    blocks: dict[tuple[str, int], list[int]] = {}
    for number, (errors, name) in enumerate(zip(members, calibrations, strict=True)):
        blocks.setdefault((name, errors.calibration_motions.shape[1]), []).append(number)
    known = [errors.distortion for errors in members if errors.distortion is not None]
    if len(known) < len(members):
        return None, np.zeros((POSE * sum(len(errors.poses) for errors in members), 0))
    first = known[0]
    coefficients, columns, views = [], [], []
    for own in blocks.values():
        size = members[own[0]].calibration_motions.shape[1]
        coefficients.append(_in_box(known[own[0]], first))
        columns.append(
            np.vstack([one.calibration_motions if n in own else np.zeros((POSE * len(one.poses), size)) for n, one in enumerate(members)])
        )
        views.append(np.vstack([np.full((len(one.poses), size), n in own) for n, one in enumerate(members)]))
    several = np.hstack(views) if len(blocks) > 1 else None
    return CloudDistortion(first.middle_mm, first.reach_mm, np.concatenate(coefficients, axis=2), several), np.hstack(columns)


def _in_box(one: CloudDistortion, box: CloudDistortion) -> FloatArray:
    """Return the coefficients of the same polynomials in the coordinates of another box; exact, as their degree is the same."""
    grid = np.stack(np.meshgrid(*[np.linspace(-1, 1, 5)] * 3, indexing="ij"), -1).reshape(-1, 3)
    points = box.middle_mm + box.reach_mm * grid
    values = (one.products(points) @ one.coefficients_mm.reshape(len(POWERS), -1)).reshape(len(points), -1)
    solved = np.linalg.lstsq(box.products(points), values, rcond=None)[0]
    return np.asarray(solved.reshape(len(POWERS), 3, -1))


def _join_form(forms: Sequence[FormErrors | None], counts: Sequence[int]) -> FormErrors | None:
    """Return the form errors of all views, independent between set-ups; None unless all are known."""
    known = [form for form in forms if form is not None]
    if len(known) < len(forms):
        return None
    starts = [0, *accumulate(counts)]
    return FormErrors(
        np.vstack([form.nodes_mm for form in known]),
        np.concatenate([form.view + start for form, start in zip(known, starts[:-1], strict=True)]),
        np.concatenate([form.sizes_mm for form in known]),
        np.concatenate([form.reaches_mm for form in known]),
        block_diag(*[form.motions for form in known]),
    )


def _join_systematic(errors: Sequence[SystematicErrors | None]) -> SystematicErrors | None:
    """Return the systematic errors as one field common to all set-ups, of the largest size; None unless all are known.

    The motions of the other set-ups are converted to the nodes of the first: their own errors follow from the field's values at their nodes.
    """
    known = [one for one in errors if one is not None]
    if len(known) < len(errors):
        return None
    first, size = known[0], max(one.size_mm for one in known)
    motions = []
    for one in known:
        change = np.linalg.pinv(smooth_basis(one.nodes, one.nodes, DIRECTION_REACH_RAD), rcond=1e-6) @ smooth_basis(
            one.nodes, first.nodes, DIRECTION_REACH_RAD
        )
        motions.append(size / max(one.size_mm, 1e-12) * (one.motions @ change))
    return SystematicErrors(first.nodes, size, np.vstack(motions))
