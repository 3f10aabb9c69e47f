"""The virtual controller against a client that was not written for it (abb-robot-client), and what another one (abb_librws) demands."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import requests
from robot_requests import until

from measureapp.peers.rws import VirtualController, virtual_controller
from measureapp.peers.rws.arm import flange_pose

DIGEST = requests.auth.HTTPDigestAuth("Default User", "robotics")
ORDER = "[1,[[{:g},0,0,0,30,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]],[150,30,150,30]]"
BOOL, NS = re.compile("TRUE|FALSE"), "{http://www.w3.org/1999/xhtml}"


@pytest.fixture
def controller() -> Iterator[VirtualController]:
    with virtual_controller() as running:
        yield running


@pytest.fixture
def client(controller: VirtualController) -> Iterator[Any]:
    rws = pytest.importorskip("abb_robot_client.rws", reason="needs the package abb-robot-client (pip install abb-robot-client)")
    made = rws.RWS(controller.url)
    yield made
    made.close()


def test_a_foreign_client_reads_the_state(client: Any) -> None:
    assert client.get_controller_state() == "motoron"
    assert client.get_operation_mode() == "AUTO"
    assert client.get_execution_state().ctrlexecstate == "stopped"
    assert client.get_speedratio() == 100.0
    task = client.get_tasks()["T_ROB1"]
    assert task.active
    assert task.motiontask
    assert client.get_ramdisk_path()


def test_a_foreign_client_reads_joints_and_a_pose_that_fit_each_other(client: Any) -> None:
    joints = client.get_jointtarget()
    np.testing.assert_allclose(joints.robax, [0, 0, 0, 0, 30, 0])
    target = client.get_robtarget()
    pose = flange_pose(joints.robax)
    np.testing.assert_allclose(target.trans, pose.translation_mm, atol=1e-3)
    assert abs(float(target.rot @ pose.quaternion_wxyz)) == pytest.approx(1.0, abs=1e-9)


def test_a_foreign_client_moves_the_robot_through_the_mailbox(client: Any, controller: VirtualController) -> None:
    client.resetpp()
    client.start()
    client.set_rapid_variable("MeasureApp/mm_order", ORDER.format(12.5))
    client.set_rapid_variable_num("mm_cmd", 1)
    run, done, state, error, _beat = client.get_rapid_variable_num_array("mm_answer")
    assert (run, done, state, error) == (1, 1, 1, 0)
    assert client.get_jointtarget().robax[0] == pytest.approx(12.5)
    time.sleep(0.25)
    assert client.get_rapid_variable_num_array("mm_answer")[4] >= 1
    client.stop()
    assert client.get_execution_state().ctrlexecstate == "stopped"


def test_a_foreign_client_switches_motors_and_speed(client: Any) -> None:
    client.set_controller_state("motoroff")
    assert client.get_controller_state() == "motoroff"
    client.set_controller_state("motoron")
    assert client.get_controller_state() == "motoron"
    client.set_speedratio(25)
    assert client.get_speedratio() == 25


def test_a_foreign_client_is_told_codes_and_the_event_log(client: Any, controller: VirtualController) -> None:
    abb = pytest.importorskip("abb_robot_client.rws")
    controller.machine.press_emergency_stop()
    with pytest.raises(abb.ABBException, match="emergencystop") as refused:
        client.start()
    assert refused.value.code < 0
    last = client.read_event_log()[-1]
    assert (last.msgtype, last.code, last.title) == (3, 10013, "Emergency stop state")


def test_a_foreign_client_lists_the_persistent_data(client: Any) -> None:
    names = {row["name"] for row in client.get_rapid_variables()}
    assert {"mm_version", "mm_order", "mm_cmd", "mm_answer", "mm_abort"} <= names


def test_a_foreign_client_uses_one_session_and_logs_out(client: Any, controller: VirtualController) -> None:
    for _ in range(20):
        client.get_jointtarget()
    assert len(controller.sessions.active) == 1
    client.close()
    assert controller.sessions.active == {}


def test_a_foreign_client_is_told_when_no_session_is_left(client: Any, controller: VirtualController) -> None:
    controller.sessions.limit = 0
    with pytest.raises(Exception, match="Robot returning"):
        client.get_controller_state()


def test_a_foreign_client_is_sent_events_of_what_it_subscribed(client: Any, controller: VirtualController) -> None:
    abb = pytest.importorskip("abb_robot_client.rws")
    kinds, normal = abb.SubscriptionResourceType, abb.SubscriptionResourcePriority.Medium
    received: list[Any] = []
    watched = [
        abb.SubscriptionResourceRequest(kind, normal)
        for kind in (kinds.ControllerState, kinds.OperationalMode, kinds.ExecutionState, kinds.Elog)
    ]
    watched.append(abb.SubscriptionResourceRequest(kinds.PersVar, abb.SubscriptionResourcePriority.High, "mm_settle"))
    subscription = client.subscribe(watched, received.append)
    try:
        until(lambda: any(path.startswith("/poll/") for _, path in controller.server.requests))
        time.sleep(0.1)
        client.set_rapid_variable("mm_settle", "0.75")
        client.start()
        until(lambda: abb.RAPIDExecutionState("running", "") in received)
        controller.machine.turn_key("MANR")
        until(lambda: len(received) >= 6)
    finally:
        while subscription.thread.is_alive():  # this client opens its websocket again when it is closed while an event arrives
            subscription.close()
            subscription.thread.join(0.3)
    assert abb.OperationalMode("MANR") in received
    assert abb.ControllerState("motoroff") in received
    assert abb.RAPIDExecutionState("stopped", "") in received
    assert abb.EventLogEntryEvent("1") in received
    assert abb.VariableValue("T_ROB1", "0.75", "mm_settle") in received
    assert len(controller.sessions.active) == 1


@pytest.fixture
def http(controller: VirtualController) -> Iterator[requests.Session]:
    with requests.Session() as session:
        session.trust_env = False
        session.auth = DIGEST
        yield session


def items(answer: requests.Response) -> list[dict[str, str]]:
    page = ElementTree.fromstring(answer.content)
    return [{span.get("class", ""): span.text or "" for span in item.iter(f"{NS}span")} for item in page.iter(f"{NS}li")]


def test_without_json_every_answer_is_xhtml(http: requests.Session, controller: VirtualController) -> None:
    for path, field in (("system", "sysid"), ("panel/ctrlstate", "ctrlstate"), ("rapid/execution", "ctrlexecstate"), ("elog/0", None)):
        answer = http.get(f"{controller.url}/rw/{path}")
        assert answer.status_code == 200
        assert answer.content.startswith(b"<?xml")
        assert field is None or field in items(answer)[0]
    joints = items(http.get(f"{controller.url}/rw/motionsystem/mechunits/ROB_1/jointtarget?ignore=1"))[0]
    assert float(joints["rax_5"]) == 30.0
    world = items(http.get(f"{controller.url}/rw/motionsystem/mechunits/ROB_1/robtarget?tool=tool0&wobj=wobj0&coordinate=Word"))[0]
    assert set(world) >= {"x", "y", "z", "q1", "q2", "q3", "q4", "cf1", "cf4", "cf6", "cfx", "eaxa"}


def test_writes_are_answered_with_204_and_no_body(http: requests.Session, controller: VirtualController) -> None:
    for path, form in (
        ("rw/mastership/rapid?action=request", {}),
        ("rw/rapid/symbol/data/RAPID/T_ROB1/MeasureApp/mm_settle?action=set", {"value": "0.5"}),
        ("rw/mastership/rapid?action=release", {}),
        ("rw/rapid/execution?action=resetpp", {}),
        ("rw/rapid/execution?action=stop", {"stopmode": "stop"}),
    ):
        answer = http.post(f"{controller.url}/{path}", data=form)
        assert (answer.status_code, answer.content) == (204, b""), path


def test_errors_are_told_in_both_envelopes(http: requests.Session, controller: VirtualController) -> None:
    controller.cell.implicit_mastership = False
    url = f"{controller.url}/rw/rapid/symbol/data/RAPID/T_ROB1/MeasureApp/mm_cmd?action=set"
    told = http.post(f"{url}&json=1", data={"value": "1"})
    assert told.status_code == 400
    assert told.headers["Content-Type"] == "application/json"
    assert told.json()["_embedded"]["status"]["code"] == -1073414146
    page = ElementTree.fromstring(http.post(url, data={"value": "1"}).content)
    assert [span.text for span in page.iter(f"{NS}span") if span.get("class") == "code"] == ["-1073414146"]


@pytest.mark.parametrize(
    ("path", "form", "status"),
    [
        ("rw/rapid/execution?action=start", {"regain": "continue"}, 400),
        ("rw/rapid/execution?action=stop", {"stopmode": "later"}, 400),
        ("rw/panel/ctrlstate?action=setctrlstate", {"ctrl-state": "on"}, 400),
        ("rw/panel/speedratio?action=setspeedratio", {"speed-ratio": "0"}, 400),
        ("rw/mastership/rapid?action=release", {}, 403),
        ("rw/rapid/symbol/data/RAPID/T_ROB1/mm_nothing?action=set", {"value": "1"}, 400),
        ("rw/rapid/symbol/data/RAPID/T_ROB1/mm_cmd?action=set", {"value": "TRUE"}, 400),
        ("rw/rapid/symbol/data/RAPID/T_ROB1/mm_cmd?action=set", {"value": "[1"}, 400),
        ("rw/rapid/symbol/data/RAPID/T_ROB1/mm_order?action=set", {"value": "[1,2]"}, 400),
        ("rw/rapid/symbol/data/RAPID/T_ROB1/mm_idle?action=set", {"value": "2"}, 400),
        ("rw/nothing", {}, 404),
    ],
)
def test_wrong_calls_are_refused(
    http: requests.Session, controller: VirtualController, path: str, form: dict[str, str], status: int
) -> None:
    assert http.post(f"{controller.url}/{path}", data=form).status_code == status


def test_the_program_cannot_be_started_twice_or_reset_while_it_runs(http: requests.Session, controller: VirtualController) -> None:
    start = {
        "regain": "continue",
        "execmode": "continue",
        "cycle": "asis",
        "condition": "none",
        "stopatbp": "disabled",
        "alltaskbytsp": "true",
    }
    assert http.post(f"{controller.url}/rw/rapid/execution?action=start", data=start).status_code == 204
    assert http.post(f"{controller.url}/rw/rapid/execution?action=start", data=start).status_code == 409
    assert http.post(f"{controller.url}/rw/rapid/execution?action=resetpp").status_code == 409


def test_mastership_names_its_holder(http: requests.Session, controller: VirtualController) -> None:
    http.post(f"{controller.url}/rw/mastership/rapid?action=request")
    mine = items(http.get(f"{controller.url}/rw/mastership/rapid"))[0]
    assert (mine["mastership"], mine["mastershipheldbyme"]) == ("remote", "TRUE")
    with requests.Session() as other:
        other.trust_env = False
        other.auth = requests.auth.HTTPDigestAuth("Default User", "robotics")
        seen = items(other.get(f"{controller.url}/rw/mastership/rapid"))[0]
        assert (seen["mastership"], seen["mastershipheldbyme"]) == ("remote", "FALSE")
        assert other.post(f"{controller.url}/rw/mastership/rapid?action=request").status_code == 403


def test_logout_is_answered_with_a_page_and_ends_the_session(http: requests.Session, controller: VirtualController) -> None:
    http.get(f"{controller.url}/rw/system")
    assert len(controller.sessions.active) == 1
    answer = http.get(f"{controller.url}/logout")
    assert answer.status_code == 200
    assert answer.content.startswith(b"<?xml")
    assert controller.sessions.active == {}


def test_without_the_cookie_every_call_opens_a_session_until_none_is_left() -> None:
    with virtual_controller(session_limit=3) as controller:
        statuses = [requests.get(f"{controller.url}/rw/system", auth=DIGEST, timeout=5).status_code for _ in range(5)]
        assert statuses == [200, 200, 200, 503, 503]


def test_a_wrong_password_is_refused_and_opens_nothing(controller: VirtualController) -> None:
    wrong = requests.auth.HTTPDigestAuth("Default User", "wrong")
    assert requests.get(f"{controller.url}/rw/system", auth=wrong, timeout=5).status_code == 401
    assert controller.sessions.active == {}


def test_idle_sessions_expire(controller: VirtualController, http: requests.Session) -> None:
    http.get(f"{controller.url}/rw/system")
    controller.sessions.idle_s = 0.0
    time.sleep(0.01)
    assert controller.sessions.find("") is None
    assert controller.sessions.active == {}


def test_a_stopped_move_goes_on_at_the_next_start_unless_the_pointer_was_reset() -> None:
    with virtual_controller(time_scale=1.0) as controller:
        program, symbols = controller.machine.program, controller.machine.program.symbols
        program.start()
        symbols.find("mm_order").value = [1.0, [[40.0, 0.0, 0.0, 0.0, 30.0, 0.0], [9e9] * 6], [150.0, 30.0, 150.0, 30.0]]
        symbols.put("mm_cmd", 1.0)
        program.advance()
        time.sleep(0.2)
        program.stop()
        stopped = controller.machine.joints_deg()[0]
        assert 0.0 < stopped < 40.0
        program.start()
        time.sleep(0.2)
        assert controller.machine.joints_deg()[0] > stopped
        program.stop()
        program.reset_pointer()
        stopped = controller.machine.joints_deg()[0]
        program.start()
        time.sleep(0.2)
        assert controller.machine.joints_deg()[0] == stopped


def test_the_world_is_told_where_the_arm_comes_to_rest() -> None:
    rests: list[Any] = []
    with virtual_controller(on_rest=rests.append) as controller:
        program, symbols = controller.machine.program, controller.machine.program.symbols
        program.start()
        symbols.find("mm_order").value = [1.0, [[4.0, 0.0, 0.0, 0.0, 30.0, 0.0], [9e9] * 6], [150.0, 30.0, 150.0, 30.0]]
        symbols.put("mm_cmd", 1.0)
        program.advance()
        time.sleep(0.01)
        program.advance()
    np.testing.assert_allclose(rests[-1], [4, 0, 0, 0, 30, 0])


def test_an_order_whose_number_is_another_one_moves_nothing() -> None:
    with virtual_controller() as controller:
        program, symbols = controller.machine.program, controller.machine.program.symbols
        program.start()
        symbols.put("mm_cmd", 5.0)  # the order still has number 0
        program.advance()
        assert symbols.find("mm_answer").value[2] == 7.0
        np.testing.assert_allclose(controller.machine.joints_deg(), [0, 0, 0, 0, 30, 0])


VERSION_2 = {"Accept": "application/hal+json;v=2.0"}


def test_the_second_version_has_verbs_in_its_paths_and_demands_its_media_types() -> None:
    with virtual_controller(version=2) as controller, requests.Session() as http:
        http.trust_env = False
        http.auth = ("Default User", "robotics")
        http.headers.update(VERSION_2)
        form = {"Content-Type": "application/x-www-form-urlencoded;v=2.0"}
        assert http.get(f"{controller.url}/rw/panel/ctrl-state").json()["state"][0]["ctrlstate"] == "motoron"
        assert http.get(f"{controller.url}/rw/system", headers={"Accept": "application/json"}).status_code == 406
        assert http.post(f"{controller.url}/rw/mastership/edit/request", data={"a": "1"}).status_code == 415
        assert http.post(f"{controller.url}/rw/mastership/edit/request", headers=form).status_code == 204
        symbol = f"{controller.url}/rw/rapid/symbol/RAPID/T_ROB1/MeasureApp/mm_settle/data"
        assert http.post(symbol, headers=form, data={"value": "0.7"}).status_code == 204
        assert float(http.get(symbol).json()["state"][0]["value"]) == pytest.approx(0.7)
        assert http.post(f"{controller.url}/rw/mastership/edit/release", headers=form).status_code == 204
        error = http.post(symbol, headers=form, data={"value": "x"})
        assert error.json()["status"]["code"] < 0
        assert len(controller.sessions.active) == 1
