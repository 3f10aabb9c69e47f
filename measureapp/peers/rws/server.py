"""The virtual controller as an HTTP server on the loopback interface."""

from __future__ import annotations

import logging
import socket
import ssl
import sys
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from types import TracebackType
from typing import Any
from urllib.parse import parse_qsl, urlsplit

from measureapp.peers.rws.link_faults import LinkFaults, Request
from measureapp.peers.rws.replies import BAD_FORM, NOT_FOUND, Answer, json_body, refusal, xhtml_body
from measureapp.peers.rws.resources import Call, Cell, answer
from measureapp.peers.rws.second_version import ACCEPTED, FORM_TYPE, translate
from measureapp.peers.rws.sessions import Session
from measureapp.peers.rws.subscriptions import PROTOCOL, Subscriptions, accept_key, page, send_events

LOGGED_OUT = b'<?xml version="1.0" encoding="UTF-8"?><html xmlns="http://www.w3.org/1999/xhtml"><body>Logged out</body></html>'
LONGEST_FORM = 1 << 20
_log = logging.getLogger(__name__)


class RwsServer(ThreadingHTTPServer):
    """Serves one cell; `close` leaves no thread behind, not even one that waits for a client."""

    daemon_threads = False
    request_queue_size = 64

    def __init__(self, cell: Cell, faults: LinkFaults, second_version: bool, tls: ssl.SSLContext | None) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.cell, self.faults, self.second_version = cell, faults, second_version
        self.closing = threading.Event()
        self.requests: list[Request] = []
        self.subscriptions = Subscriptions()
        self._connections: set[socket.socket] = set()
        self._lock = threading.Lock()
        self._tls = tls
        self._thread = threading.Thread(target=self.serve_forever, kwargs={"poll_interval": 0.02}, name="virtual controller")
        self._thread.start()

    def get_request(self) -> tuple[socket.socket, object]:
        """Accept a connection and remember it."""
        connection, address = super().get_request()
        if self._tls is not None:
            connection = self._tls.wrap_socket(connection, server_side=True, do_handshake_on_connect=False)
        with self._lock:
            self._connections.add(connection)
        return connection, address

    def shutdown_request(self, request: Any) -> None:
        """Forget a connection that has ended."""
        with self._lock:
            self._connections.discard(request)
        super().shutdown_request(request)

    def handle_error(self, _request: object, _client_address: object) -> None:
        """Ignore clients that break off; log what is a mistake of this server."""
        if not isinstance(sys.exception(), OSError):
            _log.exception("the virtual controller failed")

    def break_connections(self) -> None:
        """Reset every connection, as a restart or a pulled cable does."""
        with self._lock:
            for connection in self._connections:
                try:
                    connection.shutdown(socket.SHUT_RDWR)
                except OSError:
                    continue  # it has ended by itself

    def close(self) -> None:
        """Stop serving and wait for every thread."""
        self.closing.set()
        self.shutdown()
        self.break_connections()
        self.server_close()
        self._thread.join()

    def __enter__(self) -> RwsServer:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True
    server: RwsServer
    _calls = 0

    def do_GET(self) -> None:
        self._serve()

    do_POST = do_PUT = do_DELETE = do_GET  # noqa: N815

    def log_message(self, format: str, *args: object) -> None:
        pass

    def _serve(self) -> None:
        faults, request = self.server.faults, (self.command, self.path)
        form = self._form()
        if faults.half_open:
            self.server.closing.wait()
        if faults.half_open or faults.refuses or faults.drops_request(request) or self.server.closing.wait(faults.delay_before_s(request)):
            self.close_connection = True
            return
        self.server.requests.append(request)
        if self.command == "GET" and self.headers.get("Upgrade", "").lower() == "websocket":
            self._send_events()
            return
        raw = self._answer(form)
        self.server.closing.wait(faults.delay_after_s(request))
        self._calls += 1
        if faults.drops_answer(request):
            self.close_connection = True
            return
        self._send(faults.changed(raw, request), faults.slice_s)
        if faults.calls_per_connection is not None and self._calls >= faults.calls_per_connection:
            self.close_connection = True

    def _form(self) -> dict[str, str]:
        length = min(int(self.headers.get("Content-Length") or 0), LONGEST_FORM)
        return dict(parse_qsl(self.rfile.read(length).decode("utf-8", "replace"), keep_blank_values=True))

    def _answer(self, form: dict[str, str]) -> bytes:
        cell = self.server.cell
        with cell.machine.lock:
            session, cookies, refused = self._session()
        if refused is not None:
            return self._wrapped(refused)
        assert session is not None
        url = urlsplit(self.path)
        if url.path == "/logout":
            with cell.machine.lock:
                cell.sessions.end(session.key)
            return self._raw(200, {"Content-Type": "application/xhtml+xml"}, LOGGED_OUT)
        if url.path.startswith("/subscription"):
            return self._subscription(url.path, form, cookies)
        return self._wrapped(self._resource(url.path, dict(parse_qsl(url.query)), form, session), cookies)

    def _resource(self, path: str, query: dict[str, str], form: dict[str, str], session: Session) -> Answer:
        action = query.pop("action", "")
        if self.server.second_version:
            if self.headers.get("Accept", "") not in ACCEPTED:
                return refusal(406, NOT_FOUND, "The media type is not acceptable.")
            if self.command == "POST" and self.headers.get("Content-Type", "") != FORM_TYPE:
                return refusal(415, NOT_FOUND, "The media type is not supported.")
            path, action = translate(self.command, path)
        return answer(self.server.cell, Call(self.command, path.strip("/").removeprefix("rw/"), action, query, form, session))

    def _subscription(self, path: str, form: dict[str, str], cookies: dict[str, str]) -> bytes:
        subscriptions = self.server.subscriptions
        if self.command == "DELETE":
            number = path.rpartition("/")[2]
            known = number.isdecimal() and int(number) in subscriptions.watched
            if known:
                del subscriptions.watched[int(number)]
            return self._wrapped(Answer() if known else refusal(404, NOT_FOUND, "There is no such subscription."))
        made = subscriptions.add(form)
        if made is None:
            return self._wrapped(refusal(400, BAD_FORM, "A resource cannot be subscribed."))
        url = f"ws://{self.headers.get('Host', '')}/poll/{made}"
        return self._raw(201, {"Location": url, "Content-Type": "application/xhtml+xml"}, page(url), cookies)

    def _send_events(self) -> None:
        """Turn the connection into a websocket and send events on it."""
        self.close_connection = True
        number = self.path.rpartition("/")[2]
        resources = self.server.subscriptions.watched.get(int(number)) if number.isdecimal() else None
        refused = self._session()[2]
        if resources is None or refused is not None:
            self._send(self._wrapped(refused or refusal(404, NOT_FOUND, "There is no such subscription.")), None)
            return
        accepted = accept_key(self.headers.get("Sec-WebSocket-Key", ""))
        lines = ("HTTP/1.1 101 Switching Protocols", "Upgrade: websocket", "Connection: Upgrade", f"Sec-WebSocket-Accept: {accepted}")
        self._send("\r\n".join([*lines, f"Sec-WebSocket-Protocol: {PROTOCOL}", "", ""]).encode(), None)
        send_events(self.connection, self.server.cell.machine, resources, self.server.closing)

    def _session(self) -> tuple[Session | None, dict[str, str], Answer | None]:
        """Return the session of the request, cookies to set, and a refusal instead of these."""
        sessions = self.server.cell.sessions
        session = sessions.find(self._cookie("-http-session-").partition("::")[0])
        session = session or sessions.numbered(self._cookie("ABBCX"))
        if session is not None:
            return session, {}, None
        if not sessions.allows(self.headers.get("Authorization") or "", self.command, self.server.second_version):
            challenge = {"WWW-Authenticate": sessions.challenge(self.server.second_version)}
            return None, {}, Answer(401, code=-1, message="Authentication is required.", headers=challenge)
        session = sessions.open()
        if session is None:
            return None, {}, refusal(503, -1, "The maximum number of sessions is in use.")
        return session, {"-http-session-": f"{session.key}::http.session", "ABBCX": str(session.number)}, None

    def _cookie(self, name: str) -> str:
        pairs = (pair.strip().partition("=") for pair in (self.headers.get("Cookie") or "").split(";"))
        return next((value for key, _, value in pairs if key == name), "")

    def _wrapped(self, reply: Answer, cookies: dict[str, str] | None = None) -> bytes:
        base = f"http://{self.headers.get('Host', '')}"
        second = self.server.second_version
        wants_json = "json" in self.headers.get("Accept", "") if second else "json=1" in self.path
        body = b"" if reply.status == 204 else json_body(reply, base, second) if wants_json else xhtml_body(reply, base)
        kind = "application/json" if wants_json else "application/xhtml+xml"
        if second:
            kind = "application/hal+json;v=2.0" if wants_json else "application/xhtml+xml;v=2.0"
        headers = {**reply.headers, **({"Content-Type": kind} if body else {})}
        return self._raw(reply.status, headers, body, cookies)

    def _raw(self, status: int, headers: dict[str, str], body: bytes, cookies: dict[str, str] | None = None) -> bytes:
        lines = [f"HTTP/1.1 {status} {self.responses[status][0]}", *(f"{name}: {value}" for name, value in headers.items())]
        lines += [f"Set-Cookie: {name}={value}; path=/; httponly" for name, value in (cookies or {}).items()]
        if status != 204:
            lines.append(f"Content-Length: {len(body)}")
        return "\r\n".join([*lines, "", ""]).encode() + body

    def _send(self, raw: bytes, pause_s: float | None) -> None:
        if pause_s is None:
            self.wfile.write(raw)
            return
        for index in range(len(raw)):
            self.wfile.write(raw[index : index + 1])
            self.server.closing.wait(pause_s)
