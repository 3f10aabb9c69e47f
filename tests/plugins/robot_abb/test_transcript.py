"""Answers word by word as the manual and published clients have them, error bodies included, and what the driver makes of them."""

from __future__ import annotations

import ssl
import subprocess
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from shutil import which
from typing import Any
from urllib.parse import urlsplit

import numpy as np
import pytest
from abb_cell import connect, goal
from robot_requests import plugin_module

from measureapp.errors import DeviceError
from measureapp.peers.rws import virtual_controller

session = plugin_module("robot_abb", "session")
dialect = plugin_module("robot_abb", "dialect")
control = plugin_module("robot_abb", "controller")

CHALLENGE = 'Digest realm="validusers@robapi.abb", qop="auth", nonce="5a3f", algorithm=MD5, domain="/"'
BASE = '{"_links":{"base":{"href":"http://192.168.125.1/rw/"}},'
SYSTEM = (
    BASE + '"_embedded":{"_state":[{"_type":"sys-system","_title":"system","name":"1200-501374","rwversion":"6.08.0134",'
    '"sysid":"{E9F1A2B3-0000-4444-8888-1234567890AB}","starttm":"2024-03-05 T 12:00:00","rwversionname":"6.08.01.00"},'
    '{"_type":"sys-options-li","_title":"options","options":[{"_type":"sys-option-li","_title":"0","option":"616-1 PC Interface"}]}]}}'
)
JOINTS = (
    BASE
    + '"_embedded":{"_state":[{"_type":"ms-jointtarget","_title":"ROB_1","rax_1":"-1.2e-05","rax_2":"12.5","rax_3":"-3.75","rax_4":"0",'
    '"rax_5":"30","rax_6":"179.99","eax_a":"8.999999488E+09","eax_b":"0","eax_c":"0","eax_d":"0","eax_e":"0","eax_f":"0"}]}}'
)
ROBTARGET = (
    BASE
    + '"_embedded":{"_state":[{"_type":"ms-robtargets","_title":"ROB_1","x":"364.35","y":"0.0000149","z":"594","q1":"0.5","q2":"2.1e-08",'
    '"q3":"0.866025","q4":"-1.2e-08","cf1":"-1","cf4":"-1","cf6":"0","cfx":"0","eaxa":"8.9e+09","eaxb":"0","eaxc":"0","eaxd":"0","eaxe":"0",'
    '"eaxf":"0"}]}}'
)
NO_MASTERSHIP = (
    '{"_links":{"base":{"href":"http://192.168.125.1/rw/"}},"_embedded":{"status":{"code":-1073414146,"msg":'
    '"Client does not hold mastership. RESTful operation failed"}}}'
)
ELOG = (
    BASE + '"_embedded":{"_state":[{"_type":"elog-message-li","_title":"/rw/elog/0/3207","msgtype":"3","code":"10013","src-name":"MC0",'
    '"tstamp":"2014-06-24 T 13:23:05","argc":"0","argv":[],"title":"Emergency stop state","desc":"The system is in the Emergency stop state.",'
    '"conseqs":"","causes":"","actions":""},{"_type":"elog-message-li","_title":"/rw/elog/0/3206","msgtype":"1","code":"10011",'
    '"src-name":"MC0","tstamp":"2014-06-24 T 13:20:00","argc":"0","title":"Motors ON state","desc":"","conseqs":"","causes":"","actions":""}]}}'
)
VALUE = BASE + '"_embedded":{"_state":[{"_type":"rap-data","_title":"RAPID/T_ROB1/MeasureApp/mm_answer","value":"[3,17,1,0,4711]"}]}}'
MODE = BASE + '"_embedded":{"_state":[{"_type":"pnl-opmode","_title":"opmode","opmode":"MANR"}]}}'
STATE = BASE + '"_embedded":{"_state":[{"_type":"pnl-ctrlstate","_title":"ctrlstate","ctrlstate":"guardstop"}]}}'
EXECUTION = BASE + '"_embedded":{"_state":[{"_type":"rap-execution","_title":"execution","ctrlexecstate":"running","cycle":"forever"}]}}'

ANSWERS: dict[str, tuple[int, str]] = {
    "/rw/system": (200, SYSTEM),
    "/rw/motionsystem/mechunits/ROB_1/jointtarget": (200, JOINTS),
    "/rw/motionsystem/mechunits/ROB_1/robtarget": (200, ROBTARGET),
    "/rw/rapid/symbol/data/RAPID/T_ROB1/MeasureApp/mm_answer": (200, VALUE),
    "/rw/rapid/symbol/data/RAPID/T_ROB1/MeasureApp/mm_cmd": (400, NO_MASTERSHIP),
    "/rw/elog/0": (200, ELOG),
    "/rw/panel/opmode": (200, MODE),
    "/rw/panel/ctrlstate": (200, STATE),
    "/rw/rapid/execution": (200, EXECUTION),
    "/logout": (200, '<?xml version="1.0" encoding="UTF-8"?><html></html>'),
}


class Recorded(BaseHTTPRequestHandler):
    """A controller that answers with recorded bodies, after a digest challenge, and notes what it was asked."""

    protocol_version = "HTTP/1.1"
    asked: list[tuple[str, str, dict[str, str]]]

    def do_GET(self) -> None:
        """Answer."""
        self.rfile.read(int(self.headers.get("Content-Length") or 0))
        self.asked.append((self.command, self.path, dict(self.headers)))
        has_cookie = "-http-session-=14::http.session" in (self.headers.get("Cookie") or "")
        if not has_cookie and not self.headers.get("Authorization"):
            return self._say(401, "", {"WWW-Authenticate": CHALLENGE})
        status, body = ANSWERS[urlsplit(self.path).path]
        cookies = {} if has_cookie else {"Set-Cookie": "-http-session-=14::http.session::aaf5a5; path=/; domain=localhost; httponly"}
        return self._say(status, body, {"Content-Type": "application/json", **cookies})

    do_POST = do_GET  # noqa: N815

    def _say(self, status: int, body: str, headers: dict[str, str]) -> None:
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value.replace("; domain=localhost", ""))
        if "Set-Cookie" in headers:
            self.send_header("Set-Cookie", "ABBCX=52; path=/")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body.encode())

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@pytest.fixture
def recorded() -> Iterator[tuple[Any, list[tuple[str, str, dict[str, str]]]]]:
    asked: list[tuple[str, str, dict[str, str]]] = []
    handler = type("Handler", (Recorded,), {"asked": asked})
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.daemon_threads = False
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02})
        thread.start()
        access = session.Access(f"http://127.0.0.1:{server.server_address[1]}", "Default User", "robotics", "", 1.0, 1.5, 0.0)
        login = session.RwsSession(access, dialect.VERSIONS["1.0"])
        login.log_in()
        yield control.Controller(login, {"task": "T_ROB1", "module": "MeasureApp", "unit": "ROB_1"}), asked
        login.log_out()
        server.shutdown()
        thread.join()


def test_the_login_answers_the_challenge_and_keeps_both_cookies(recorded: Any) -> None:
    controller, asked = recorded
    controller.joints_deg()
    assert "Authorization" not in asked[0][2]
    assert asked[1][2]["Authorization"].startswith(
        'Digest username="Default User", realm="validusers@robapi.abb", nonce="5a3f", uri="/rw/system'
    )
    for _, _, headers in asked[2:]:  # no digest round trip once the session stands
        assert "Authorization" not in headers
        assert "-http-session-=14::http.session::aaf5a5" in headers["Cookie"]
        assert "ABBCX=52" in headers["Cookie"]


def test_recorded_answers_are_read(recorded: Any) -> None:
    controller, _ = recorded
    assert controller.system() == ("{E9F1A2B3-0000-4444-8888-1234567890AB}", "6.08.0134")
    np.testing.assert_allclose(controller.joints_deg(), [-1.2e-5, 12.5, -3.75, 0, 30, 179.99])
    pose = controller.pose()
    np.testing.assert_allclose(pose.translation_mm, [364.35, 0.0000149, 594])
    np.testing.assert_allclose(pose.quaternion_wxyz, [0.5, 0, 0.866025, 0], atol=1e-6)
    situation = controller.situation()
    assert (situation.ctrlstate, situation.opmode, situation.running) == ("guardstop", "MANR", True)
    assert not situation.may_move
    assert situation.words == "protective stop: a guard is open, manual mode with reduced speed, program running"
    assert controller.read("mm_answer") == "[3,17,1,0,4711]"


def test_the_recorded_event_log_is_read_from_a_number_on(recorded: Any) -> None:
    controller, _ = recorded
    assert [(message.number, message.kind, message.code) for message in controller.messages()] == [(3207, 3, 10013), (3206, 1, 10011)]
    assert [message.title for message in controller.messages(3206)] == ["Emergency stop state"]


def test_the_recorded_refusal_without_mastership_is_told_with_its_code(recorded: Any) -> None:
    controller, asked = recorded
    with pytest.raises(session.Refused, match=r"400, code -1073414146.*does not hold mastership") as caught:
        controller.write("mm_cmd", "18")
    assert (caught.value.status, caught.value.code) == (400, -1073414146)
    posts = [path for method, path, _ in asked if method == "POST"]
    assert posts == ["/rw/rapid/symbol/data/RAPID/T_ROB1/MeasureApp/mm_cmd?action=set&json=1"]
    explained = controller.explained(caught.value)
    assert "protective stop" in explained.message
    assert "Close the guard" in explained.hint


@pytest.fixture
def certificate(tmp_path: Path) -> tuple[ssl.SSLContext, str]:
    if which("openssl") is None:
        pytest.skip("needs the program openssl (apt-get install openssl)")
    key, made = tmp_path / "key.pem", tmp_path / "certificate.pem"
    command = [
        "openssl",
        "req",
        "-x509",
        "-newkey",
        "rsa:2048",
        "-nodes",
        "-days",
        "2",
        "-subj",
        "/CN=controller",
        "-keyout",
        key,
        "-out",
        made,
    ]
    subprocess.run(command, check=True, capture_output=True, timeout=60)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(made, key)
    shown = subprocess.run(
        ["openssl", "x509", "-noout", "-fingerprint", "-sha256", "-in", made], check=True, capture_output=True, text=True
    )
    return context, shown.stdout.strip().partition("=")[2]


def test_the_second_version_accepts_the_pinned_certificate_alone(certificate: tuple[ssl.SSLContext, str]) -> None:
    context, fingerprint = certificate
    with virtual_controller(version=2, tls=context) as controller:
        robot = connect(controller, version="2.0", certificate_sha256=fingerprint)
        robot.move_to(goal(5.0), timeout_s=10.0)
        robot.close()
        for wrong in ("", "00:" * 31 + "00"):
            with pytest.raises(DeviceError, match=r"certificate is not accepted.*fingerprint"):
                connect(controller, version="2.0", certificate_sha256=wrong)
        assert controller.sessions.active == {}
