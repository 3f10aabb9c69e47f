"""`process`: recompute a project from its stored images."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.campaign import ClusterOption, answer_jobs, run_jobs
from measureapp.cli.decode import ModulationOption, PhaseSigmaOption, with_limits
from measureapp.cli.import_recording import process_imported
from measureapp.cli.main import DONE, OUT_OF_TOLERANCE
from measureapp.cli.outcome import measurement_lines, report_event
from measureapp.cli.part_options import PartState
from measureapp.cli.reply import JsonOption, LanguageOption, TerminalProgress, reply
from measureapp.data.verdicts import has_passed
from measureapp.errors import InputError
from measureapp.language.languages import ENGLISH

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from measureapp.pipeline.events import Event
    from measureapp.pipeline.run import Outcome
    from measureapp.pipeline.watch import Profile
    from measureapp.project.folder import ProjectFolder


CURRENT = "The results are those of the stored images, calibration and program, by the sizes of the files and the journal; `verify` reads every byte."
SurroundingsOption = Annotated[
    Literal["keep", "exclude"] | None,
    typer.Option(help="Keep the points of table, fixtures and background, or exclude them, now and later.", show_default="exclude"),
]


def register(app: typer.Typer) -> None:
    """Add the commands."""

    @app.command()
    @with_groups
    def process(
        projects: Annotated[
            list[Path], typer.Argument(metavar="PROJECT...", help="Project folder; several are processed one after the other.")
        ],
        part: PartState,
        accept: Annotated[
            list[str] | None, typer.Option(help="Use this view regardless of its quality, now and later; may be given several times.")
        ] = None,
        refuse: Annotated[list[str] | None, typer.Option(help="Do not use this view, now and later; may be given several times.")] = None,
        surroundings: SurroundingsOption = None,
        check: Annotated[
            bool,
            typer.Option(
                "--check",
                help="Only report whether the results belong to the present images, calibration and program, and whether files are missing or cut off.",
            ),
        ] = False,
        min_modulation: ModulationOption = None,
        max_phase_sigma: PhaseSigmaOption = None,
        profile: Annotated[
            bool,
            typer.Option("--profile", help="State time, processor time, peak memory and bytes read and written of every stage."),
        ] = False,
        cluster: ClusterOption = None,
        language: LanguageOption = ENGLISH,
        as_json: JsonOption = False,
    ) -> None:
        """Recompute everything, calibration included, from the stored images.

        A viewpoint whose images are damaged is reported and not used. Of an imported recording, everything that its images suffice for is computed, and what is missing for the rest is stated. Limits of pixels (--min-modulation, --max-phase-sigma) are stored with the project and hold from now on.
        """
        from measureapp.pipeline.recording.stages import is_recording
        from measureapp.project.folder import ProjectFolder

        if len(projects) > 1 or cluster is not None:
            chosen = [one for one in (min_modulation, max_phase_sigma) if one is not None] or language != ENGLISH
            _process_many(
                projects, cluster, as_json, accept or refuse or surroundings or check or profile or part.identification() or chosen
            )
            return
        folder = ProjectFolder.open(projects[0])
        if check:
            raise typer.Exit(_check(folder, as_json))
        _choose(folder, accept or [], refuse or [], surroundings)
        _state(folder, part)
        _limit(folder, min_modulation, max_phase_sigma)
        if is_recording(folder):
            process_imported(folder, language, as_json)
            return
        damaged: dict[str, str] = {}
        outcome, watch = _recompute(folder, damaged, language, profile=profile)
        used: dict[str, Any] = {} if watch is None else {"profile": watch.document()}
        lines = [*measurement_lines(outcome.measurement), *(() if watch is None else watch.lines())]
        reply({**outcome.document, **used, **({"damaged": damaged} if damaged else {})}, "\n".join(lines), as_json)
        if damaged or not has_passed(outcome.measurement):
            raise typer.Exit(OUT_OF_TOLERANCE)


def _recompute(folder: ProjectFolder, damaged: dict[str, str], language: str, *, profile: bool) -> tuple[Outcome, Profile | None]:
    """Process a project; with its profile, where that is wanted."""
    from measureapp.pipeline.run import process_project
    from measureapp.pipeline.watch import Profile

    if not profile:
        return process_project(folder, _reporting(damaged), TerminalProgress(), language=language), None
    with Profile() as watch:
        return process_project(folder, _reporting(damaged), TerminalProgress(), watch, language), watch


def _process_many(projects: Sequence[Path], cluster: str | None, as_json: bool, with_options: object) -> None:
    """Process several projects, or one on a cluster."""
    from measureapp.campaign.campaign_file import process_jobs

    if with_options:
        raise InputError(
            "Several projects, and --cluster, take no other option than --json.", "Process the project alone to give it options."
        )
    answer_jobs(run_jobs(process_jobs(projects), cluster), as_json)


def _state(folder: ProjectFolder, part: PartState) -> None:
    """Store temperature and material of the part in the header, where they are stated. Raises InputError."""
    from measureapp.project.identification_file import read_identification, save_identification

    stated = part.identification()
    if stated is not None:
        save_identification(folder.path, stated.with_defaults(read_identification(folder.path)))


def _limit(folder: ProjectFolder, min_modulation: float | None, max_phase_sigma: float | None) -> None:
    """Store limits of the pixels with the project, where they are stated. Raises InputError."""
    from measureapp.fringe.settings import DecodeSettings
    from measureapp.project.fringes.decode_limits_file import read_decode_limits, save_decode_limits

    stated = {"min_modulation": min_modulation, "max_phase_sigma_rad": max_phase_sigma}
    if stated := {name: value for name, value in stated.items() if value is not None}:
        with_limits(DecodeSettings(), min_modulation, max_phase_sigma)  # refuses what is no limit
        save_decode_limits(folder.path, read_decode_limits(folder.path).model_copy(update=stated))


def _reporting(damaged: dict[str, str]) -> Callable[[Event], None]:
    """Return what reports events, and collects viewpoints whose images are damaged, with the reason."""
    from measureapp.pipeline.events import ViewFailed

    def receive(event: Event) -> None:
        report_event(event)
        if isinstance(event, ViewFailed) and event.damaged:
            damaged[event.viewpoint_id] = event.reason

    return receive


def _check(project: ProjectFolder, as_json: bool) -> int:
    """Reply whether the stored results are current; return the exit code."""
    there = (project.results / "measurement.json").is_file()
    damaged = project.journal.size_problems()
    stale = (*damaged, *project.stale_results()) if there else (*damaged, "There are no results yet.")
    reply(
        {"current": not stale, "stale": stale},
        "\n".join(stale) or CURRENT,
        as_json,
    )
    return OUT_OF_TOLERANCE if stale else DONE


def _choose(project: ProjectFolder, accepted: list[str], refused: list[str], surroundings: str | None) -> None:
    """Store the views accepted or refused by hand in the project, and whether surroundings are kept."""
    from measureapp.errors import InputError
    from measureapp.pipeline.chosen_views import check_choices

    if both := sorted(set(accepted) & set(refused)):
        raise InputError(f"The view {both[0]!r} is both accepted and refused.", "Name it once.")
    choices = project.view_choices()
    for name in accepted:
        choices = choices.with_choice(name, "use")
    for name in refused:
        choices = choices.with_choice(name, "refuse")
    if surroundings is not None:
        choices = choices.model_copy(update={"keep_surroundings": surroundings == "keep"})
    if accepted or refused or surroundings is not None:
        check_choices(choices, project.stored_viewpoints())
        project.save_view_choices(choices)
