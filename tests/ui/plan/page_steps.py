"""What a person does on the Plan page, and what is read from it."""

from __future__ import annotations

from measureapp.data.plan import Viewpoint
from measureapp.project.plan_file import read_plan
from measureapp.resources import resource

SAMPLE = read_plan(resource("plans/paper_impeller.toml"))


def end(application, qtbot) -> None:
    """End the checks in the background."""
    application.controllers.planning.prediction.stop()
    for runner in (application.controllers.predicting, application.controllers.drawing):
        runner.queue.cancel_all()
    qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=30_000)


def check_at_once(page) -> None:
    page.planning.prediction._timer.setInterval(0)
    page.planning.prediction.predict(page.planning.plan)


def names(page) -> list[str]:
    return [] if page.planning.plan is None else [viewpoint.id for viewpoint in page.planning.plan]


def enter(fields, *numbers) -> None:
    for line, number in zip(fields.lines, numbers, strict=True):
        line.setText(str(number))
    fields.lines[-1].editingFinished.emit()


def viewpoint(page, name: str) -> Viewpoint:
    return next(one for one in page.planning.plan if one.id == name)


def said(page) -> str:
    return page.session.messages[-1].text if page.session.messages else ""
