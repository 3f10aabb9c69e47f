"""Jobs, the queue and the mailbox."""

from __future__ import annotations

import threading

import pytest

from measureapp.errors import InputError, MeasureError
from ui.workers.job import Job
from ui.workers.mailbox import Mailboxes
from ui.workers.rig_queue import RigQueue


def outcomes(job: Job) -> list[str]:
    heard: list[str] = []
    job.succeeded.connect(lambda _result: heard.append("succeeded"))
    job.failed.connect(lambda _error: heard.append("failed"))
    job.cancelled.connect(lambda: heard.append("cancelled"))
    return heard


def run(qtbot, job: Job) -> None:
    with qtbot.waitSignal(job.finished, timeout=5000):
        job.start()
    job.wait()


def test_a_job_that_returns_succeeds_once_with_its_result(qtbot):
    job = Job("Adding", lambda _job: 1 + 1)
    heard, results = outcomes(job), []
    job.succeeded.connect(results.append)
    run(qtbot, job)
    assert heard == ["succeeded"]
    assert results == [2]


def test_a_job_works_on_a_thread_of_its_own(qtbot):
    threads = []
    run(qtbot, Job("Looking", lambda _job: threads.append(threading.get_ident())))
    assert threads[0] != threading.get_ident()


def test_a_measure_error_fails_once_with_message_and_hint(qtbot):
    def work(_job):
        raise InputError("The file a.png is missing.", "Copy it back.")

    job, errors = Job("Reading", work), []
    heard = outcomes(job)
    job.failed.connect(errors.append)
    run(qtbot, job)
    assert heard == ["failed"]
    assert (errors[0].message, errors[0].hint) == ("The file a.png is missing.", "Copy it back.")


def test_an_error_of_the_program_becomes_a_sentence(qtbot):
    job, errors = Job("Dividing", lambda _job: 1 / 0), []
    job.failed.connect(errors.append)
    run(qtbot, job)
    assert isinstance(errors[0], MeasureError)
    assert "ZeroDivisionError" in errors[0].message
    assert errors[0].hint


def test_an_error_of_the_disk_names_the_file(qtbot):
    def work(_job):
        raise FileNotFoundError(2, "No such file", "plan.json")

    job, errors = Job("Reading", work), []
    job.failed.connect(errors.append)
    run(qtbot, job)
    assert "plan.json" in errors[0].message


def test_cancel_raises_at_the_next_report(qtbot):
    reached = threading.Event()
    stopped = threading.Event()

    def work(job):
        reached.set()
        stopped.wait(5)
        job.report(1, 2, "half")
        raise AssertionError("the report did not stop the work")

    job = Job("Waiting", work)
    heard = outcomes(job)
    with qtbot.waitSignal(job.finished, timeout=5000):
        job.start()
        assert reached.wait(5)
        job.cancel()
        stopped.set()
    assert heard == ["cancelled"]


def test_progress_is_a_share_between_zero_and_one(qtbot):
    shares = []
    job = Job("Counting", lambda job: [job.report(done, 4, "n") for done in (0, 4, 5)])
    job.progressed.connect(lambda share, _note: shares.append(share))
    run(qtbot, job)
    qtbot.waitUntil(lambda: len(shares) == 3)
    assert shares == [0.0, 1.0, 1.0]


def test_the_queue_runs_jobs_one_after_the_other(qtbot):
    queue, trace = RigQueue(), []

    def work(name):
        return lambda _job: trace.extend([f"{name} in", f"{name} out"])

    with qtbot.waitSignal(queue.emptied, timeout=5000):
        queue.submit(Job("First", work("first")))
        queue.submit(Job("Second", work("second")))
    assert trace == ["first in", "first out", "second in", "second out"]
    assert not queue.busy


def test_cancelling_the_queue_ends_what_waits_too(qtbot):
    queue, gate, heard = RigQueue(), threading.Event(), []

    def wait(job):
        gate.wait(5)
        job.check()

    jobs = [Job("First", wait), Job("Second", wait)]
    for job in jobs:
        job.cancelled.connect(lambda: heard.append("cancelled"))
    with qtbot.waitSignal(queue.emptied, timeout=5000):
        for job in jobs:
            queue.submit(job)
        queue.cancel_all()
        gate.set()
    assert heard == ["cancelled", "cancelled"]


@pytest.mark.parametrize("count", [1, 5])
def test_each_mailbox_keeps_only_the_newest_and_no_camera_waits_for_another(count):
    boxes: Mailboxes[int] = Mailboxes()
    for item in range(count):
        boxes.put("left", item)
    boxes.put("right", 70)
    assert boxes.take_all() == {"left": count - 1, "right": 70}
    assert boxes.take_all() == {}
