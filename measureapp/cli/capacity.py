"""`capacity`: how many computers a day's projects need."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, reply

if TYPE_CHECKING:
    from measureapp.campaign.capacity import Cluster, Day, ProjectWork

SEED = 1  # of the arrivals
SHARE_IN_TIME = 95  # percent


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def capacity(
        profile: Annotated[Path, typer.Argument(help="Answer of `process PROJECT --profile --json` for a typical project.")],
        per_day: Annotated[int, typer.Option(min=1, max=1_000_000, help="Projects a day.")] = 10_000,
        hours: Annotated[float, typer.Option(min=0.1, max=24.0, help="Within how many hours they arrive.")] = 24.0,
        machines: Annotated[int | None, typer.Option(min=1, max=100_000, help="Computers; default: as few as keep `--within`.")] = None,
        within: Annotated[
            float | None, typer.Option(min=0.01, help="Minutes in which 95 % should be done; default: twice as long as one alone.")
        ] = None,
        cores: Annotated[int, typer.Option(min=1, max=1024, help="Processor cores of a computer.")] = 8,
        memory_gib: Annotated[float, typer.Option(min=0.5, help="Memory of a computer.")] = 32.0,
        storage_mb_s: Annotated[
            float, typer.Option(min=1.0, help="What the shared storage reads and writes, all computers together.")
        ] = 2000.0,
        connection_mb_s: Annotated[float, typer.Option(min=1.0, help="What one task gets of it at most.")] = 500.0,
        scheduler_ms: Annotated[float, typer.Option(min=0.0, help="Time of the scheduler for one task.")] = 1.0,
        core_hour: Annotated[float | None, typer.Option(min=0.0, help="Price of one core for one hour, in any currency.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """State how many computers a day's projects need, and what becomes scarce first: by arithmetic and a simulated day.

        Nothing is computed on any project: the times are those of the profile, on the processor that made it.
        """
        from measureapp.campaign.capacity import PROFILE, Cluster, arrivals, fewest_machines, most_per_day, simulate, work_of
        from measureapp.project.text_document import read_toml_or_json

        work = work_of(read_toml_or_json(profile, "the profile of a project", PROFILE), str(profile))
        cluster = Cluster(machines or 1, cores, memory_gib * 2**30, 1e6 * storage_mb_s, 1e6 * connection_mb_s, 1e-3 * scheduler_ms)
        arrive_s, alone_s = arrivals(per_day, hours, SEED), float(simulate(work, cluster, arrivals(1, 1.0, SEED)).latency_s[0])
        limit_s = 60.0 * within if within is not None else 2.0 * alone_s
        if machines is None:
            cluster = replace(cluster, machines=fewest_machines(work, cluster, arrive_s, limit_s, SHARE_IN_TIME))
        day = simulate(work, cluster, arrive_s)
        most = most_per_day(work, cluster)
        document = _document(work, cluster, day, alone_s, most, core_hour)
        reply(document, "\n".join(_lines(document)), as_json)


def _document(
    work: ProjectWork, cluster: Cluster, day: Day, alone_s: float, most: dict[str, float], core_hour: float | None
) -> dict[str, Any]:
    import numpy as np

    middle, late, last = np.percentile(day.latency_s, (50, SHARE_IN_TIME, 100))
    read, written = work.traffic_bytes - work.written_bytes, work.written_bytes
    rent = None if core_hour is None else cluster.machines * cluster.cores * 24 * core_hour
    return {
        "project": {"tasks": work.tasks, "processor_s": work.processor_s, "read_mb": read / 1e6, "written_mb": written / 1e6},
        "day": {
            "projects": day.projects,
            "processor_h": day.projects * work.processor_s / 3600,
            "read_tb": day.projects * read / 1e12,
            "written_tb": day.projects * written / 1e12,
        },
        "cluster": {"machines": cluster.machines, "cores": cluster.cores, "tasks_at_once": cluster.places(work)},
        "latency_s": {"alone": alone_s, "median": float(middle), "late": float(late), "largest": float(last)},
        "ended_h": day.ended_s / 3600,
        "busy": dict(day.busy),
        "most_per_day": dict(sorted(most.items(), key=lambda item: item[1])),
        "cost_per_day": rent,
        "cost_per_project": None if rent is None else rent / day.projects,
    }


def _lines(found: dict[str, Any]) -> list[str]:
    one, day, cluster, time, busy = (found[name] for name in ("project", "day", "cluster", "latency_s", "busy"))
    scarce = [f"{name} ({most:,.0f} projects a day)" for name, most in found["most_per_day"].items()]
    lines = [
        f"A project: {one['tasks']} tasks, {one['processor_s']:.1f} s of processor time, {one['read_mb']:.0f} MB read, {one['written_mb']:.0f} MB written.",
        f"{day['projects']} projects: {day['processor_h']:.0f} core hours, {day['read_tb']:.2f} TB read, {day['written_tb']:.2f} TB written.",
        f"{cluster['machines']} machines, {cluster['tasks_at_once']} tasks at a time: a project takes {time['alone']:.0f} s alone; half of them "
        f"{time['median']:.0f} s, {SHARE_IN_TIME} % at most {time['late']:.0f} s, the slowest {time['largest']:.0f} s; the last is done after {found['ended_h']:.1f} h.",
        "Busy: " + ", ".join(f"{name} {share:.1%}" for name, share in busy.items()) + ".",
        f"Scarce first: {scarce[0]}, then {', '.join(scarce[1:])}.",
    ]
    if found["cost_per_day"] is not None:
        lines.append(f"Rent of the machines: {found['cost_per_day']:.2f} a day, {found['cost_per_project']:.4f} a project.")
    return lines
