"""Running the jobs of a campaign, one after the other in this process or as tasks on a cluster."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from measureapp.campaign.cluster import check_cluster, connected_cluster
from measureapp.campaign.jobs import DemoJob, Finished, Job, ProcessJob
from measureapp.campaign.tasks import complete, compute_view, do_alone, prepare, views_to_compute
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.data.scan_cost import stack_bytes
from measureapp.errors import InputError, MeasureError, StorageError
from measureapp.pipeline.recording.stages import is_recording
from measureapp.pipeline.sample import sample_request
from measureapp.pipeline.setups import is_joined
from measureapp.progress import Progress
from measureapp.project.folder import ProjectFolder

if TYPE_CHECKING:
    from distributed import Client, Future

OnFinished = Callable[[Finished], None]
RETRIES = 2  # of a task whose worker was lost or whose storage failed
POLL_S = 0.2
PROGRAM_BYTES = 700_000_000  # of a worker without images
STACKS_IN_MEMORY = 3.0  # images, phases and clouds of a view over its images


def run_here(jobs: Sequence[Job], on_finished: OnFinished, progress: Progress) -> list[Finished]:
    """Do the jobs one after the other in this process. Raises Cancelled between two of them."""
    found = []
    for number, job in enumerate(jobs):
        progress.report(number, len(jobs), job.name)
        found.append(do_alone(job))
        on_finished(found[-1])
    progress.report(1, 1, "done")
    return found


def run_on_cluster(jobs: Sequence[Job], address: str, on_finished: OnFinished, progress: Progress) -> list[Finished]:
    """Do the jobs as tasks on a cluster; the numbers are those of one computer, to the last bit.

    A project is calibrated in one task, each of its views is one, and stitching, inspection and report are one. Images and clouds stay on
    the storage that all share; only calibrations and references travel. A worker that is lost costs its tasks, which another one repeats.

    Parameters
    ----------
    address : of a scheduler of Dask, or "local"
    on_finished : receives each job when it has ended

    Raises
    ------
    InputError, StorageError
        Before anything starts: see `connected_cluster`, `check_cluster`; a project is of a kind that is processed as a whole.
    Cancelled
        From ``progress``; tasks under way end by themselves, nothing else is begun.
    """
    needed = max(PROGRAM_BYTES + round(STACKS_IN_MEMORY * _largest_stack(job)) for job in jobs)
    with connected_cluster(address, needed, progress) as client:
        check_cluster(client, [job.folder if isinstance(job, ProcessJob) else job.folder.parent for job in jobs], needed)
        submitted = {job.name: (job, *_submit(client, job)) for job in jobs}
        tasks = [task for _, _, all_tasks in submitted.values() for task in all_tasks]
        answers: dict[str, Finished] = {}
        try:
            while len(answers) < len(jobs):
                done = sum(task.done() for task in tasks)
                progress.report(done, len(tasks), f"{len(answers)} of {len(jobs)} jobs, {done} of {len(tasks)} tasks")
                time.sleep(POLL_S)
                for name, (job, end, _) in submitted.items():
                    if name not in answers and end.done():
                        answers[name] = _answer_of(job, end)
                        on_finished(answers[name])
        except BaseException:
            client.cancel(tasks, force=True)
            raise
        progress.report(1, 1, "done")
        return [answers[job.name] for job in jobs]


def _largest_stack(job: Job) -> int:
    """Return the size of the images of the largest view, bytes. Raises InputError, StorageError where there is no project."""
    if isinstance(job, DemoJob):
        scan = sample_request(job.request.sample, job.folder)
        return _of_plan(scan.rig, scan.plan)
    project = ProjectFolder.open(job.folder)
    if is_joined(project) or is_recording(project):
        kind = "joined from several set-ups" if is_joined(project) else "an imported recording"
        raise InputError(f"{job.folder} is {kind}.", "Process it without --cluster.")
    plan = project.plan()
    return 0 if plan is None else _of_plan(project.rig(), plan)


def _of_plan(rig: RigDescription, plan: ScanPlan) -> int:
    return max((stack_bytes(plan, viewpoint, rig) for viewpoint in plan), default=0)


def _submit(client: Client, job: Job) -> tuple[Future[Any], list[Future[Any]]]:
    """Submit the tasks of a job; return the last one, whose result is the answer, and all of them."""
    if isinstance(job, DemoJob):
        whole = client.submit(do_alone, job, pure=False, retries=RETRIES)
        return whole, [whole]
    viewpoints, started = views_to_compute(job.folder), time.time()
    calibration = client.submit(prepare, job.folder, pure=False, retries=RETRIES)
    views = [client.submit(compute_view, job.folder, one, calibration, pure=False, retries=RETRIES) for one in viewpoints]
    end = client.submit(complete, job, calibration, dict(zip(viewpoints, views, strict=True)), started, pure=False, retries=RETRIES)
    return end, [calibration, *views, end]


def _answer_of(job: Job, end: Future[Any]) -> Finished:
    """Return the answer of a job whose last task has ended, well or not."""
    error = end.exception()
    if error is None:
        found: Finished = end.result()
        return found
    if isinstance(error, MeasureError):
        return Finished.failed(job, error)
    return Finished.failed(
        job, StorageError(f"The cluster gave it up: {error}.", "Read the logs of the workers, then start the job again.")
    )
