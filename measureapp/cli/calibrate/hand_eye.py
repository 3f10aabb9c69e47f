"""`calibrate hand-eye`: where the reference camera sits on the flange."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.limits import RequiredLimits, limit_lines, limits_answer
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import Answer, BoardPosesOption, BoardSource, RobotPosesOption
from measureapp.cli.calibrate.pose_options import RobotNoise
from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.reply import TerminalProgress

if TYPE_CHECKING:
    from measureapp.calibrate.motions.hand_eye import HandEyeEstimate, HandEyeSolution


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command("hand-eye")
    @with_groups
    def hand_eye(
        ctx: typer.Context,
        source: BoardSource,
        noise_of_robot: RobotNoise,
        asked: RequiredLimits,
        answer: Answer,
        robot_poses: RobotPosesOption,
        board_poses: BoardPosesOption = None,
        board_sigma_mm: Annotated[float, typer.Option(min=1e-6, help="The same of the board poses of a table, mm.")] = 0.05,
        board_sigma_deg: Annotated[float, typer.Option(min=1e-6, help="The same of the board poses of a table, degrees.")] = 0.01,
    ) -> None:
        """Find flange_from_camera by seven methods, then refine it jointly."""
        from measureapp.calibrate.draft.draft import Setup
        from measureapp.calibrate.draft.solve import solve
        from measureapp.calibrate.kinds.hand_eye import problem_of
        from measureapp.calibrate.kinds.table import KINDS
        from measureapp.calibrate.motions.inlier_solutions import solve_hand_eye
        from measureapp.calibrate.motions.outlier_rejection import REPRESENTATIVE_MARKS_MM
        from measureapp.calibrate.rig.limits import hand_eye_limits
        from measureapp.cli.calibrate.observed_files import observed_at_robot_poses, read_board_poses, read_robot_poses
        from measureapp.data.fringe import Readback
        from measureapp.project.documents import link_document

        wanted, noise = asked.values(("hand-eye position", "hand-eye rotation")), noise_of_robot.axis_noise()
        robot = {name: Readback(pose) for name, pose in read_robot_poses(robot_poses).items()}
        seen = observed_at_robot_poses(robot, board_poses, source, TerminalProgress())
        if seen is not None:
            with seen.explain_failure():
                solved = solve(seen.draft(Setup(KINDS["hand-eye"], seen.board, seen.camera_names, seen.cameras, noise=noise)))
            solution, used, (rejected, moved) = solved.solution, list(solved.used), seen.outcome(solved)
        else:
            assert board_poses is not None  # one of both was given
            found = solve_hand_eye(
                problem_of(read_board_poses(board_poses, robot, board_sigma_mm, board_sigma_deg), noise), REPRESENTATIVE_MARKS_MM
            )
            names, rejected = list(robot), []
            solution, used = found.solution, [names[index] for index in found.kept]
            moved = {names[index]: reason for index, reason in found.rejected.items()}
        limits = hand_eye_limits(solution, wanted)
        document = (
            hand_eye_answer(solution, used)
            | limits_answer(limits)
            | {
                "camera_uncertainty_carried_on": seen is not None and seen.cameras.covariance is not None,
                "rejected": rejected,
                "moved": moved,
                "warnings": list(solution.warnings),
            }
        )
        link = {"flange_from_camera": solution.refined.flange_from_camera.matrix, "hand_eye": link_document(solution.hand_eye)}
        answer.give(ctx, document, [*_lines(document), *limit_lines(limits)], link)
        if solution.degeneracy.verdict != "good":
            raise typer.Exit(OUT_OF_TOLERANCE)
        asked.exit_unless_met(limits)


def hand_eye_answer(solution: HandEyeSolution, names: list[str]) -> dict[str, Any]:
    """Return the JSON answer of a solution."""
    degeneracy = solution.degeneracy
    refined = solution.refined
    return {
        "methods": {name: _estimate(estimate) for name, estimate in solution.methods.items()},
        "refused": dict(solution.refused),
        "refined": _estimate(refined) | {"standard_deviations": dict(solution.standard_deviations)},
        "base_from_board": solution.base_from_board.matrix,
        "poses": [
            {"name": name, "residual_mm": float(length), "residual_deg": math.degrees(angle), "influence_mm": float(influence)}
            for name, length, angle, influence in zip(names, refined.residual_mm, refined.residual_rad, solution.influence_mm, strict=True)
        ],
        "spread_of_methods_mm": solution.spread_mm,
        "spread_at_part_mm": solution.spread_at_part_mm,
        "part_in_camera_mm": solution.part_in_camera_mm,
        "degeneracy": {
            "axis_spread_deg": degeneracy.axis_spread_deg,
            "largest_angle_deg": degeneracy.largest_angle_deg,
            "pairs": degeneracy.pairs,
            "pairs_left_out": degeneracy.left_out,
            "verdict": degeneracy.verdict,
        },
    }


def _estimate(estimate: HandEyeEstimate) -> dict[str, Any]:
    length, angle = estimate.residual_mm, estimate.residual_rad
    return {
        "flange_from_camera": estimate.flange_from_camera.matrix,
        "residual_mm": {"mean": float(length.mean()), "max": float(length.max())},
        "residual_deg": {"mean": math.degrees(angle.mean()), "max": math.degrees(angle.max())},
    }


def _lines(document: dict[str, Any]) -> list[str]:
    lines = [f"Hand-eye transform from {len(document['poses'])} poses; translation of flange_from_camera in mm:"]
    for name, entry in (*document["methods"].items(), ("refined", document["refined"])):
        place = " ".join(f"{value:9.3f}" for value in entry["flange_from_camera"][:3, 3])
        lines.append(
            f"  {name:<13} {place}   residual {entry['residual_mm']['mean']:.3f} mm (max {entry['residual_mm']['max']:.3f}), "
            f"{entry['residual_deg']['mean']:.4f}° (max {entry['residual_deg']['max']:.4f})"
        )
    deviations = document["refined"]["standard_deviations"]
    lines.append("  ± " + " ".join(f"{deviations[f'{axis}_mm']:.3f}" for axis in "xyz") + " mm (refined)")
    strongest = max(document["poses"], key=lambda pose: pose["influence_mm"])
    lines.append(
        f"  methods differ by {document['spread_at_part_mm']:.3f} mm at the part; without {strongest['name']} "
        f"it would move by {strongest['influence_mm']:.3f} mm, every other pose less"
    )
    lines += [f"  {name}: {reason}" for name, reason in document["refused"].items()]
    lines += [f"  rejected: {name}: {reason}" for name, reason in document["moved"].items()]
    lines += [f"  {warning}" for warning in document["warnings"]]
    lines += [f"  rejected: {one['image']} ({one['camera']}): {one['reason']}" for one in document["rejected"]]
    return [*lines, f"  motions: {document['degeneracy']['verdict']}, {document['degeneracy']['axis_spread_deg']:.1f}° from parallel"]
