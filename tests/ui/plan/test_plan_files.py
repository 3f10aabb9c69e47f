"""Plans come from files, projects and the generator, and go there."""

from __future__ import annotations

from functools import partial

from PySide6.QtWidgets import QFileDialog

from measureapp.planning import generate as generator
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.plan_file import read_plan, write_plan
from measureapp.resources import resource
from tests.ui.plan.page_steps import SAMPLE, end, names, said


def test_a_plan_is_saved_and_opened_by_the_buttons(page, tmp_path, monkeypatch, qtbot):
    target = tmp_path / "ünï plan"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *args: (str(target), ""))
    page.save_file.click()
    saved = target.with_suffix(".toml")
    qtbot.waitUntil(saved.exists, timeout=10_000)
    assert read_plan(saved) == page.planning.plan
    write_plan(tmp_path / "other.json", SAMPLE)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *args: (str(tmp_path / "other.json"), ""))
    page.open_file.click()
    qtbot.waitUntil(lambda: page.planning.plan == SAMPLE, timeout=10_000)
    page.planning.undo()
    assert names(page)[0] == "hub-01"


def test_a_file_that_is_no_plan_is_refused_and_the_plan_stays(page, tmp_path, qtbot):
    before = page.planning.plan
    texts = ("", "rubbish", '{"schema_version": 3, "name": "x"}', '{"name": "<img src=x>", "viewpoints": []}')
    for number, text in enumerate(texts):
        bad = tmp_path / f"bad{number}.json"
        bad.write_text(text)
        page.planning.open(bad)
        qtbot.waitUntil(lambda bad=bad: bad.name in said(page), timeout=10_000)
        assert page.session.messages[-1].level == "error" and page.planning.plan is before


def test_a_plan_is_used_for_the_scan_and_stored_in_the_project(page, tmp_path, qtbot, rig):
    project = ProjectFolder.create(tmp_path / "project", ProjectSettings(name="project", part="", rig=rig))
    plan = page.planning.plan
    page.session.open_project("project", "", project.path)
    assert page.planning.plan is plan and page.use.isEnabled()
    page.use.click()
    qtbot.waitUntil(lambda: page.session.plan == plan, timeout=10_000)
    assert project.plan() == plan and list(page.session.viewpoints) == names(page)
    assert not page.use.isEnabled()


def test_the_plan_of_an_opened_project_is_shown_and_the_former_comes_back_by_undo(page, plan):
    before = page.planning.plan
    page.session.open_project("other", "", None)
    page.session.set_plan(plan)
    assert page.planning.plan == plan
    page.planning.undo()
    assert page.planning.plan == before


def test_an_empty_page_begins_with_one_viewpoint(application, window, rig, qtbot):
    application.session.set_rig(rig)
    window.show_page("plan")
    shown = window.pages["plan"]
    assert shown.is_empty
    shown.begin.click()
    assert not shown.is_empty and names(shown) == ["view01"]
    shown.planning.undo()
    assert shown.is_empty
    end(application, qtbot)


def test_a_plan_is_generated_after_its_part_is_chosen(page, monkeypatch, qtbot):
    coarse = partial(generator.GeneratorSettings, samples=300, candidates=60)  # quick, and good enough for three viewpoints
    monkeypatch.setattr(generator, "GeneratorSettings", coarse)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *args: (str(resource("parts/gypsum/nominal.stl")), ""))
    page.generate.click()
    dialog = page.dialog
    assert not dialog.start.isEnabled()
    dialog.partAsked.emit()
    qtbot.waitUntil(dialog.start.isEnabled, timeout=20_000)
    dialog.by.setValue("count")
    dialog.count.setValue(3)
    former = page.planning.plan
    dialog.start.click()
    qtbot.waitUntil(lambda: page.planning.plan is not former, timeout=90_000)
    made = page.planning.plan
    assert len(made) == 3 and (made.name, made.bracket) == (former.name, former.bracket)
    assert "3 viewpoints measure" in said(page)


def test_a_part_that_was_chosen_stays_while_other_pages_are_shown_and_a_nominal_that_is_none_is_refused(
    on_impeller, window, tmp_path, qtbot
):
    page, prepared = on_impeller, on_impeller.planning.part.prepared
    page.session.part = "gypsum"
    window.show_page("rig")
    window.show_page("plan")
    (tmp_path / "none.stl").write_text("solid")
    page.planning.part.choose(tmp_path / "none.stl")
    qtbot.waitUntil(lambda: "none.stl" in said(page), timeout=10_000)
    assert page.planning.part.prepared is prepared


def test_while_a_job_runs_plans_are_read_and_saved_and_what_would_wait_is_refused(page, application, working, on_impeller, tmp_path, qtbot):
    planning, queue = page.planning, application.controllers.jobs.queue
    write_plan(tmp_path / "other.json", SAMPLE)
    working()
    for act in (lambda: planning.generate(4, 0.9), planning.shorten, planning.use):
        page.session.tell("Something else.", "")
        before = planning.plan
        act()
        assert said(page) == "Recomputing is still running." and not queue._waiting
        assert planning.plan is before and page.session.plan is None
    planning.open(tmp_path / "other.json")
    qtbot.waitUntil(lambda: planning.plan == SAMPLE, timeout=10_000)
    planning.save(tmp_path / "saved.toml")
    qtbot.waitUntil((tmp_path / "saved.toml").exists, timeout=10_000)
    assert page.session.busy_with == "Recomputing"
