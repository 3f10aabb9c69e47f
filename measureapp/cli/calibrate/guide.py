"""`calibrate guide`: direction and scale of the linear guide in the robot's base."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.limits import RequiredLimits, limit_lines, limits_answer
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import Answer, BoardPosesOption, BoardSource, RobotPosesOption
from measureapp.cli.calibrate.pose_options import GuidePositionsOption, RobotNoise
from measureapp.cli.reply import TerminalProgress, triple
from measureapp.errors import InputError, MeasureError

if TYPE_CHECKING:
    from measureapp.calibrate.motions.linear_guide import GuideSolution
    from measureapp.data.calibration import HandEye


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def guide(
        ctx: typer.Context,
        source: BoardSource,
        noise_of_robot: RobotNoise,
        asked: RequiredLimits,
        answer: Answer,
        robot_poses: RobotPosesOption,
        guide_positions: GuidePositionsOption,
        hand_eye: Annotated[Path, typer.Option(help="Saved by `calibrate hand-eye --out`, or a pose table of one pose.")],
        board_poses: BoardPosesOption = None,
    ) -> None:
        """Find the guide's direction and scale from a fixed board."""
        from measureapp.calibrate.draft.draft import Setup
        from measureapp.calibrate.draft.solve import solve
        from measureapp.calibrate.kinds.guide import problem_of, solve_inliers
        from measureapp.calibrate.kinds.table import KINDS
        from measureapp.calibrate.motions.outlier_rejection import REPRESENTATIVE_MARKS_MM
        from measureapp.calibrate.rig.limits import guide_limits
        from measureapp.cli.calibrate.observed_files import (
            observed_at_robot_poses,
            read_board_poses,
            read_robot_poses,
            require_same_names,
        )
        from measureapp.data.fringe import Readback
        from measureapp.project.tables import read_guide

        wanted, noise = asked.values(("guide direction", "guide scale")), noise_of_robot.axis_noise()
        flanges, slide = read_robot_poses(robot_poses), read_guide(guide_positions)
        require_same_names(guide_positions, tuple(flanges), tuple(slide))
        known = read_hand_eye(hand_eye)
        robot = {name: Readback(pose, slide[name]) for name, pose in flanges.items()}
        seen = observed_at_robot_poses(robot, board_poses, source, TerminalProgress())
        if seen is not None:
            setup = Setup(KINDS["guide"], seen.board, seen.camera_names, seen.cameras, known, noise)
            with seen.explain_failure():
                solved = solve(seen.draft(setup))
            solution, used, (rejected, moved) = solved.solution, list(solved.used), seen.outcome(solved)
        else:
            assert board_poses is not None  # one of both was given
            found = solve_inliers(problem_of(read_board_poses(board_poses, robot, 1.0, 1.0), known), REPRESENTATIVE_MARKS_MM, noise)
            names, rejected = list(robot), []
            solution, used = found.solution, [names[index] for index in found.kept]
            moved = {names[index]: reason for index, reason in found.rejected.items()}
        limits = guide_limits(solution, wanted)
        document = (
            guide_answer(solution, used)
            | limits_answer(limits)
            | {
                "camera_uncertainty_carried_on": seen is not None and seen.cameras.covariance is not None,
                "rejected": rejected,
                "moved": moved,
            }
        )
        answer.give(ctx, document, [*_lines(document), *limit_lines(limits)])
        asked.exit_unless_met(limits)


def read_hand_eye(path: Path) -> HandEye:
    """Read flange_from_camera from the answer of `calibrate hand-eye`, or from a pose table with one pose.

    Raises
    ------
    InputError
        The file holds no such transform.
    """
    from measureapp.data.calibration import HandEye
    from measureapp.geometry.transform import RigidTransform
    from measureapp.project.documents import hand_eye_from
    from measureapp.project.tables import read_poses

    if path.suffix.lower() == ".csv":
        poses = list(read_poses(path, "flange", "camera").values())
        if len(poses) != 1:
            raise InputError(f"{path} has {len(poses)} poses.", "Give exactly one, flange_from_camera.")
        return HandEye(poses[0])
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        if "hand_eye" in document:
            return hand_eye_from(document["hand_eye"])
        matrix = document["flange_from_camera"] if "flange_from_camera" in document else document["refined"]["flange_from_camera"]
        return HandEye(RigidTransform(matrix, "flange", "camera"))
    except (OSError, ValueError, KeyError, TypeError, MeasureError, RecursionError) as error:
        from measureapp.project.text_document import reason_of

        raise InputError(
            f"{path} holds no flange_from_camera: {reason_of(error)}.", "Give the file that `calibrate hand-eye --out` wrote."
        ) from error


def guide_answer(solution: GuideSolution, names: list[str]) -> dict[str, Any]:
    """Return the JSON answer of a solution."""
    fitted = solution.guide
    return {
        "direction": fitted.direction,
        "scale": fitted.scale,
        "standard_deviations": {"direction_deg": math.degrees(fitted.direction_sigma_rad), "scale": fitted.scale_sigma},
        "straightness_mm": {"rms": fitted.straightness_mm, "max": float(solution.straightness_mm.max())},
        "positions": [
            {
                "name": name,
                "straightness_mm": float(aside),
                "along_mm": float(along),
                "turn_deg": math.degrees(turn),
                "paper_error_mm": float(paper),
            }
            for name, aside, along, turn, paper in zip(
                names, solution.straightness_mm, solution.along_mm, solution.turn_rad, solution.paper_mm, strict=True
            )
        ],
        "turn_deg": math.degrees(float(solution.turn_rad.max())),
        "stroke_mm": solution.stroke_mm,
        "paper_cost_mm": solution.paper_cost_mm,
        "warnings": list(solution.warnings),
    }


def _lines(document: dict[str, Any]) -> list[str]:
    deviations = document["standard_deviations"]
    return [
        f"Guide direction {triple(document['direction'], 6)} ± {deviations['direction_deg']:.4f}°, scale {document['scale']:.6f} ± {deviations['scale']:.6f}",
        f"  straightness {document['straightness_mm']['rms']:.4f} mm rms over {document['stroke_mm']:.0f} mm; "
        f"pure +Y would have cost {document['paper_cost_mm']:.3f} mm",
        *(f"  rejected: {name}: {reason}" for name, reason in document["moved"].items()),
        *(f"  rejected: {one['image']} ({one['camera']}): {one['reason']}" for one in document["rejected"]),
        *(f"  {warning}" for warning in document["warnings"]),
    ]
