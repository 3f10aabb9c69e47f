"""`campaign`: many jobs, on this computer or on a cluster."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.reply import JsonOption, TerminalProgress, reply, say

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from measureapp.campaign.jobs import Finished, Job

ClusterOption = Annotated[
    str | None,
    typer.Option(
        "--cluster", help='"local" for a process per processor of this computer, or the address of a scheduler of Dask distributed.'
    ),
]


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def campaign(
        file: Annotated[
            Path, typer.Argument(help="Campaign: parts × rigs × seeds on the virtual rig, and projects to be processed; TOML.")
        ],
        cluster: ClusterOption = None,
        again: Annotated[bool, typer.Option("--again", help="Do jobs again whose answers are stored.")] = False,
        as_json: JsonOption = False,
    ) -> None:
        """Do many jobs and summarise them: verdicts, and on the virtual rig how often the uncertainty contains the true value.

        Answers are stored one by one in the campaign's folder. A campaign that was ended early goes on where it stopped.
        """
        from measureapp.campaign.answers import Answers
        from measureapp.campaign.campaign_file import read_campaign

        folder, jobs = read_campaign(file)
        answers = Answers(folder)
        known = {} if again else answers.of(jobs)
        waiting = [job for job in jobs if job.name not in known]
        if known:
            say(f"{len(known)} of {len(jobs)} jobs were done before.")

        def keep(finished: Finished) -> None:
            answers.keep(finished)
            _tell(finished)

        done = {one.name: one for one in run_jobs(waiting, cluster, keep)} if waiting else {}
        finished = [done.get(job.name) or known[job.name] for job in jobs]
        answer_jobs(finished, as_json)


def run_jobs(jobs: Sequence[Job], cluster: str | None, keep: Callable[[Finished], None] | None = None) -> list[Finished]:
    """Do jobs in this process or on a cluster, and tell each that has ended on standard error."""
    from measureapp.campaign.run import run_here, run_on_cluster

    on_finished = keep or _tell
    return (
        run_here(jobs, on_finished, TerminalProgress())
        if cluster is None
        else run_on_cluster(jobs, cluster, on_finished, TerminalProgress())
    )


def answer_jobs(finished: Sequence[Finished], as_json: bool) -> None:
    """Reply what became of all jobs; exit code 1 where one has no result or did not pass."""
    from measureapp.campaign.summary import summary_document, summary_lines

    jobs = [
        {"name": one.name, "folder": one.folder, "passed": one.passed, "problem": one.problem or None, **one.document} for one in finished
    ]
    reply({"jobs": jobs, "summary": summary_document(finished)}, "\n".join(summary_lines(finished)), as_json)
    if not all(one.passed for one in finished):
        raise typer.Exit(OUT_OF_TOLERANCE)


def _tell(finished: Finished) -> None:
    outcome = finished.problem or ("passed" if finished.passed else "not passed")
    say(f"{finished.name}: {outcome} ({finished.seconds:.0f} s)")
