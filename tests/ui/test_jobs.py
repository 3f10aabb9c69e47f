"""How jobs end is told to who asked for them, however soon they end."""

from __future__ import annotations

from measureapp.errors import MeasureError
from measureapp.progress import Cancelled
from ui.controllers.jobs import JobRunner
from ui.session import Session
from ui.workers.job import Job

PATIENCE_MS = 10_000


def test_a_job_that_fails_before_the_window_checks_again_is_reported_once(qtbot) -> None:
    def refuse(_job: object) -> None:
        raise MeasureError("It cannot be done.", "Do something else.")

    runner, told = JobRunner(Session()), []
    job = runner.run("Refusing", refuse, told.append, on_failed=told.append)
    assert job.wait(PATIENCE_MS)
    qtbot.waitUntil(lambda: not runner.queue.busy, timeout=PATIENCE_MS)
    assert [str(one) for one in told] == ["It cannot be done. Do something else."]


def test_a_job_whose_thread_is_over_before_it_is_returned_still_tells_that_it_has_ended(qtbot) -> None:
    runner, told = JobRunner(Session()), []
    job = runner.run("Quick", lambda _job: 7, told.append)
    assert job.wait(PATIENCE_MS)
    job.ended.connect(lambda: told.append((job.title, runner.queue.busy)))
    qtbot.waitUntil(lambda: len(told) == 2, timeout=PATIENCE_MS)
    assert told == [7, ("Quick", False)]


def test_a_job_that_is_cancelled_reports_so_and_nothing_else(qtbot) -> None:
    def stop(_job: object) -> None:
        raise Cancelled

    runner, told = JobRunner(Session()), []
    runner.run("Stopping", stop, told.append, on_failed=told.append, on_stopped=lambda: told.append("cancelled"))
    qtbot.waitUntil(lambda: not runner.queue.busy, timeout=PATIENCE_MS)
    assert told == ["cancelled"]


def test_a_package_that_another_thread_is_importing_is_waited_for(qtbot) -> None:
    trials = []

    def work(_job: Job) -> str:
        trials.append("")
        if len(trials) == 1:
            raise ImportError("cannot import name 'b' from partially initialized module 'a' (most likely due to a circular import)")
        return "read"

    job = Job("Opening project", work)
    with qtbot.waitSignal(job.succeeded, timeout=5000) as done:
        job.start()
    assert done.args == ["read"] and len(trials) == 2
    assert job.wait(5000)


def test_a_job_that_has_told_something_is_not_done_twice(qtbot) -> None:
    def work(job: Job) -> None:
        job.emit_event("the first image")
        raise ImportError("cannot import name 'b' from partially initialized module 'a'")

    job = Job("Scan", work)
    with qtbot.waitSignal(job.failed, timeout=5000):
        job.start()
    assert job.wait(5000)
