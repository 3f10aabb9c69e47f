"""`scan`: run a plan on a rig and process the images."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.main import BAD_INPUT, DEVICE_FAILED, DONE, OUT_OF_TOLERANCE
from measureapp.cli.outcome import measurement_lines
from measureapp.cli.part_options import PartState
from measureapp.cli.reply import JsonOption, LanguageOption, TerminalProgress, reply, say
from measureapp.data.raw_policy import RawPolicy
from measureapp.data.verdicts import has_passed
from measureapp.errors import DeviceError, InputError
from measureapp.language.languages import ENGLISH

if TYPE_CHECKING:
    from measureapp.acquire.control import RunControl
    from measureapp.data.part_program import PartProgram
    from measureapp.data.plan import ScanPlan
    from measureapp.pipeline.run import ScanRequest

NOT_PROCESSED = (
    "The images are stored but not processed: the project has no calibration. Calibrate the rig, then run `measureapp process PROJECT`."
)


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    @with_groups
    def scan(
        plan: Annotated[Path, typer.Argument(help="Scan plan (JSON or TOML), or a part program (.mpart).")],
        rig: Annotated[str, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")],
        project: Annotated[Path, typer.Option("--project", help="Project folder, new or with a calibration of this rig.")],
        part: PartState,
        calibration: Annotated[
            Path | None, typer.Option("--calibration", help="Another project of this rig whose calibration is copied into a new project.")
        ] = None,
        resume: Annotated[bool, typer.Option("--resume", help="Keep stored viewpoints and take only the missing ones.")] = False,
        retake: Annotated[
            list[str] | None,
            typer.Option(
                "--retake", help="Take this stored viewpoint again; may be repeated. Its images are replaced when the new ones are stored."
            ),
        ] = None,
        auto_bracket: Annotated[
            float | None,
            typer.Option("--auto-bracket", min=0.1, help="Choose the exposures by a probe, for this many seconds per viewpoint."),
        ] = None,
        per_viewpoint: Annotated[
            bool, typer.Option("--per-viewpoint", help="Probe at every viewpoint, instead of once at the first (with --auto-bracket).")
        ] = False,
        raw: Annotated[
            RawPolicy | None,
            typer.Option(
                "--raw",
                help="What becomes of raw images after the scan: kept, compressed without loss, or dropped once their clouds are stored. The "
                "project keeps it. Default: as it states, else kept.",
            ),
        ] = None,
        dry_run: Annotated[
            bool, typer.Option("--dry-run", help="Connect the rig and list everything that would prevent the scan; nothing moves.")
        ] = False,
        language: LanguageOption = ENGLISH,
        as_json: JsonOption = False,
    ) -> None:
        """Move, project, capture and store every viewpoint of a plan, then process the images."""
        from measureapp.devices.recorded_rig import require_devices
        from measureapp.pipeline.run import ScanRequest
        from measureapp.project.rig_file import read_rig

        if per_viewpoint and auto_bracket is None:
            raise InputError("--per-viewpoint chooses no exposures by itself.", "Add --auto-bracket SECONDS.")
        wanted, program = _plan_and_program(plan)
        request = ScanRequest(wanted, read_rig(rig), project, resume, calibration, auto_bracket, per_viewpoint, tuple(retake or ()))
        request = replace(request, part_program=program, raw=raw, stated=part.identification(), language=language)
        require_devices(request.rig)
        raise typer.Exit(_rehearse(request, as_json) if dry_run else _scan(request, as_json))


def _plan_and_program(path: Path) -> tuple[ScanPlan, PartProgram | None]:
    """Read a scan plan, or a part program and its plan."""
    from measureapp.project.part_program_file import is_part_program, read_part_program
    from measureapp.project.plan_file import read_plan

    if not is_part_program(path):
        return read_plan(path), None
    program = read_part_program(path)
    return program.plan, program


def _scan(request: ScanRequest, as_json: bool) -> int:
    """Scan, and reply with what became of every viewpoint; return the exit code."""
    from measureapp.acquire.control import RunControl
    from measureapp.cli.scan_log import ScanLog
    from measureapp.cli.stop_signals import ended_by_signals
    from measureapp.pipeline.run import scan_into_project

    control = RunControl(attended=sys.stdin is not None and sys.stdin.isatty())
    log = ScanLog(request.plan, request.rig, lambda: _wait_for_enter(control))
    with ended_by_signals():
        outcome = scan_into_project(request, log.note, TerminalProgress(), control)
    document = {} if outcome is None else outcome.document
    figures = {view["name"]: view for view in document.get("views", [])}
    views = [{"name": name, **figures.get(name, {}), **state} for name, state in log.states.items()]
    run = {"ended": log.ended.reason, "message": log.ended.message, "processed": outcome is not None, "views": views}
    lines = [NOT_PROCESSED] if outcome is None else measurement_lines(outcome.measurement)
    reply({**document, **run}, "\n".join(lines), as_json)
    if outcome is not None:
        _care_for_raw_images(request.folder)
    if any(state["state"] != "stored" for state in log.states.values()):
        return DEVICE_FAILED
    passed = outcome is None or has_passed(outcome.measurement)
    return DONE if passed and not any("reason" in state for state in log.states.values()) else OUT_OF_TOLERANCE


def _care_for_raw_images(folder: Path) -> None:
    """Compress or drop raw images as the project states, after the result was told; Ctrl-C leaves the rest to `measureapp raw --apply`."""
    from measureapp.pipeline.raw_keeping import apply_raw_policy
    from measureapp.project.folder import ProjectFolder

    done = apply_raw_policy(ProjectFolder.open(folder), TerminalProgress())
    if done.sentence:
        say(done.sentence)


def _wait_for_enter(control: RunControl) -> None:
    """Let a paused run go on when Enter is pressed. Raises KeyboardInterrupt at the end of the input."""
    say("Press Enter to go on, or Ctrl-C to stop.")
    if not sys.stdin.readline():
        raise KeyboardInterrupt
    control.resume()


def _rehearse(request: ScanRequest, as_json: bool) -> int:
    """Reply with what would prevent the scan; return the exit code."""
    from measureapp.pipeline.preflight import preflight_lines
    from measureapp.pipeline.run import rehearse

    found = rehearse(request)
    document = {
        "viewpoints": len(request.plan),
        "bytes": found.bytes,
        "images_s": found.images_s,
        "warnings": list(found.warnings),
        "problems": [{"type": type(problem).__name__, "message": problem.message, "hint": problem.hint} for problem in found.problems],
    }
    reply(document, "\n".join(preflight_lines(found, request.plan)), as_json)
    if any(isinstance(problem, DeviceError) for problem in found.problems):
        return DEVICE_FAILED
    return BAD_INPUT if found.problems else DONE
