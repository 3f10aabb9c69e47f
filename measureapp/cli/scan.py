"""`scan`: run a plan on a rig and process what it gave."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from measureapp.acquire.events import Event, RunEnded, ViewpointFailed, ViewpointStored
from measureapp.cli.main import DEVICE_FAILED, OUT_OF_TOLERANCE
from measureapp.cli.outcome import measurement_lines, passed
from measureapp.cli.reply import JsonOption, TerminalProgress, reply, say


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def scan(
        plan: Annotated[Path, typer.Argument(help="Scan plan (JSON or TOML).")],
        rig: Annotated[str, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")],
        project: Annotated[Path, typer.Option("--project", help="Project folder; it must hold the calibration of this rig.")],
        resume: Annotated[bool, typer.Option("--resume", help="Keep the viewpoints that are stored already.")] = False,
        as_json: JsonOption = False,
    ) -> None:
        """Move, project, capture and store every viewpoint of a plan, then process the images."""
        from measureapp.pipeline import scan_into_project
        from measureapp.project.plan_file import read_plan
        from measureapp.project.rig_file import read_rig

        states: dict[str, dict[str, Any]] = {}
        ended: dict[str, str] = {}

        def on_event(event: Event) -> None:
            if isinstance(event, ViewpointStored):
                states[event.viewpoint_id] = {"state": "stored", "seconds": event.seconds}
                say(f"{event.viewpoint_id}: stored")
            elif isinstance(event, ViewpointFailed):
                states[event.viewpoint_id] = {"state": "failed", "reason": event.reason}
                say(f"{event.viewpoint_id}: {event.reason}")
            elif isinstance(event, RunEnded):
                ended.update(reason=event.reason, message=event.message)

        outcome = scan_into_project(read_plan(plan), read_rig(rig), project, resume, on_event, TerminalProgress())
        views = [{"viewpoint": viewpoint_id, **state} for viewpoint_id, state in states.items()]
        document = {"views": views, "ended": ended["reason"], "message": ended["message"], **outcome.document}
        reply(document, "\n".join(measurement_lines(outcome.measurement)), as_json)
        if any(view["state"] == "failed" for view in views):
            raise typer.Exit(DEVICE_FAILED)
        if not passed(outcome.measurement):
            raise typer.Exit(OUT_OF_TOLERANCE)
