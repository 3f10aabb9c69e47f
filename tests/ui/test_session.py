"""The session tells what changed."""

from __future__ import annotations

from ui.session import Session


def test_opening_a_project_forgets_the_last_one(qtbot, measurement, plan):
    session = Session()
    session.set_plan(plan)
    session.set_measurement(measurement, {})
    session.open_project("next", "gear", None)
    assert (session.project_name, session.part) == ("next", "gear")
    assert session.measurement is None
    assert session.plan is None
    assert session.viewpoints == {}
    assert session.views == ()


def test_a_plan_makes_its_viewpoints_wait(qtbot, plan):
    session = Session()
    with qtbot.waitSignals([session.planChanged, session.viewpointsChanged]):
        session.set_plan(plan)
    assert [state.status for state in session.viewpoints.values()] == ["waiting"] * len(plan)


def test_a_view_whose_cloud_is_refused_is_a_failed_viewpoint_with_its_reason(qtbot, measurement):
    session = Session()
    with qtbot.waitSignals([session.viewpointsChanged, session.cloudsChanged]):
        session.add_view(measurement.views[4])
    assert session.viewpoints["view-05"].status == "failed"
    assert "noise" in session.viewpoints["view-05"].note


def test_the_same_view_is_replaced_not_doubled(qtbot, measurement):
    session = Session()
    session.add_view(measurement.views[0])
    session.add_view(measurement.views[0])
    assert len(session.views) == 1


def test_a_measurement_signals_everything_at_once(qtbot, measurement):
    session = Session()
    with qtbot.waitSignals([session.calibrationChanged, session.cloudsChanged, session.inspectionChanged, session.reportChanged]):
        session.set_measurement(measurement, {})
    assert session.inspection is measurement.inspection


def test_messages_are_kept_in_order(qtbot):
    session = Session()
    session.tell("first")
    session.tell("second", "do this", "error")
    assert [(message.text, message.hint, message.level) for message in session.messages] == [
        ("first", "", "info"),
        ("second", "do this", "error"),
    ]
