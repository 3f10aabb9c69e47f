"""One login at the controller: authentication, cookie, time limits, and what counts as lost."""

from __future__ import annotations

import http.client
import json
import logging
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import requests
import urllib3
from requests.adapters import HTTPAdapter
from requests.auth import AuthBase, HTTPBasicAuth, HTTPDigestAuth

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout

from .dialect import Dialect, Row, refusal, states

LONGEST_ANSWER = 1 << 20
EXCERPT = 32  # bytes
SHORTEST_WAIT_S = 0.1
TRANSPORT = (OSError, urllib3.exceptions.HTTPError)  # those of requests are OSErrors
SESSION_COOKIE = "-http-session-"
_log = logging.getLogger(__name__)


class Unanswered(DeviceTimeout):
    """A write got no answer: whether it was carried out is unknown until it is read back."""


class Refused(DeviceError):
    """The controller refused a call; nothing was changed."""

    def __init__(self, message: str, hint: str, status: int, code: int) -> None:
        super().__init__(message, hint)
        self.status, self.code = status, code


class _NoSession(Exception):
    """The controller does not know the session any more."""


@dataclass(frozen=True)
class Access:
    """Where the controller is, who logs in, and how patient the caller is."""

    address: str
    user: str
    password: str
    certificate_sha256: str
    reply_timeout_s: float
    loss_s: float
    login_patience_s: float


class RwsSession:
    """A login; calls may come from any thread, one at a time is sent.

    Parameters
    ----------
    renewed : called after the controller had forgotten the session and a new one was opened, before the interrupted call is repeated; it
        raises where another controller or program answers now
    """

    def __init__(self, access: Access, dialect: Dialect, renewed: Callable[[], None] = lambda: None) -> None:
        self._access, self._dialect, self.renewed = access, dialect, renewed
        self._lock = threading.RLock()
        self._http = http_session(access, dialect)
        self._authentication: AuthBase = (HTTPDigestAuth if dialect.digest else HTTPBasicAuth)(access.user, access.password)
        self._asks_always = False  # a controller that wants authentication in spite of the cookie
        self._checking = False
        self._is_closed = False
        self._silent_since: float | None = None  # when the controller did not answer for the first time since its last answer

    @property
    def cookies(self) -> dict[str, str]:
        """The cookies of the session; empty without one."""
        return {cookie.name: cookie.value or "" for cookie in self._http.cookies}

    @property
    def patience_s(self) -> float:
        """How long a controller may not answer."""
        return self._access.loss_s

    def log_in(self) -> None:
        """Open a session; wait while the controller has none left.

        Raises
        ------
        DeviceError
            Wrong user or password, no session free in time.
        DeviceLost
            Nobody answers.
        """
        with self._lock:
            self._http.cookies.clear()
            end, pause = time.monotonic() + self._access.login_patience_s, 0.25
            while True:
                try:
                    self._call("GET", "system", {}, {}, self._authentication)
                    self._asks_always = not self._cookie_suffices()
                    return
                except Refused as error:
                    if error.status != 503 or time.monotonic() + pause > end:
                        raise
                    _log.warning("%s has no free session; next attempt in %.2f s", self._access.address, pause)
                except _NoSession:
                    raise DeviceError(
                        f"The controller at {self._access.address} refuses user {self._access.user!r} (401).",
                        "Correct user and password, or the version of Robot Web Services, in the robot's settings.",
                    ) from None
                time.sleep(pause)
                pause = min(2.0 * pause, 4.0)

    def get(self, what: str, **names: str) -> list[Row]:
        """Read a resource; a read that is not answered is repeated until the controller counts as lost.

        Raises
        ------
        Refused
            The controller refuses it.
        DeviceLost
            It does not answer.
        DeviceError
            The answer makes no sense.
        """
        return self._with_session("GET", what, {}, names)

    def post(self, what: str, form: Mapping[str, str] | None = None, **names: str) -> None:
        """Write, once. Raises as `get`, and Unanswered where it is unknown whether it was carried out."""
        self._with_session("POST", what, form or {}, names)

    def log_out(self) -> None:
        """Close the session for good, as far as the controller answers. Harmless when repeated."""
        with self._lock:
            self._is_closed = True
            if self.cookies:
                try:
                    self._send("GET", "logout", {}, {}, None, self._access.reply_timeout_s)
                except (*TRANSPORT, DeviceError, _NoSession):
                    _log.warning("%s did not answer to the logout", self._access.address)
            self._http.cookies.clear()
            self._http.close()

    def _cookie_suffices(self) -> bool:
        try:
            self._call("GET", "system", {}, {}, None)
        except _NoSession:
            return False
        return True

    def _with_session(self, method: str, what: str, form: Mapping[str, str], names: Mapping[str, str]) -> list[Row]:
        with self._lock:
            if self._is_closed:  # logging in again would leave a session behind
                raise DeviceLost(f"The connection to the controller at {self._access.address} was closed.", "Connect again.")
            before = self.cookies.get(SESSION_COOKIE)
            try:
                rows = self._call(method, what, form, names, self._authentication if self._asks_always else None)
            except _NoSession:
                _log.warning("%s has forgotten the session: logging in again", self._access.address)
                self.log_in()
                self._check_renewed()
                return self._call(method, what, form, names, self._authentication)
            if self._asks_always and self.cookies.get(SESSION_COOKIE) != before:
                self._check_renewed()
            return rows

    def _check_renewed(self) -> None:
        if not self._checking:
            self._checking = True
            try:
                self.renewed()
            finally:
                self._checking = False

    def _call(
        self, method: str, what: str, form: Mapping[str, str], names: Mapping[str, str], authentication: AuthBase | None
    ) -> list[Row]:
        """Send a call; a read as often as time allows, counted from the first call that was not answered."""
        while True:
            began = time.monotonic()
            left_s = self._access.loss_s - (0.0 if self._silent_since is None else began - self._silent_since)
            timeout_s = min(self._access.reply_timeout_s, max(left_s, SHORTEST_WAIT_S))
            try:
                return self._send(method, what, form, names, authentication, timeout_s)
            except TRANSPORT as error:
                self._http.close()  # the next call opens a fresh connection
                self._silent_since = self._silent_since or began
                _refuse_garbage(error, what)
                _log.warning("%s: no answer to %s %s: %s", self._access.address, method, what, type(error).__name__)
                if method != "GET":
                    raise Unanswered(f"The controller at {self._access.address} did not answer to {what!r}.") from error
                time.sleep(0.05)
                if time.monotonic() >= self._silent_since + self._access.loss_s:
                    self._silent_since = None  # whoever calls again may wait as long again
                    raise DeviceLost(
                        f"The controller at {self._access.address} does not answer any more ({what}).",
                        "Check that it is on and its network cable is plugged in, then connect again. The robot's state is unknown.",
                    ) from error

    def _send(
        self,
        method: str,
        what: str,
        form: Mapping[str, str],
        names: Mapping[str, str],
        authentication: AuthBase | None,
        timeout_s: float,
    ) -> list[Row]:
        data = dict(form) if method == "POST" else None
        status, body = self._exchange(method, what, names, data, authentication, timeout_s)
        self._silent_since = None
        if status == 401:
            raise _NoSession
        return _states(status, body, what)

    def _exchange(
        self,
        method: str,
        what: str,
        names: Mapping[str, str],
        data: dict[str, str] | None,
        authentication: AuthBase | None,
        timeout_s: float,
    ) -> tuple[int, bytes]:
        """Return status and body; apart, because an error that is kept would keep the connection open with its response."""
        with self._http.request(
            method,
            self._access.address + self._dialect.path(what, names),
            data=data,
            headers={} if data is None else dict(self._dialect.form_headers),
            auth=authentication,
            timeout=timeout_s,
            stream=True,
            allow_redirects=False,
        ) as response:
            return response.status_code, _body(response, time.monotonic() + self._access.loss_s, what)


def http_session(access: Access, dialect: Dialect) -> requests.Session:
    """Return a session of the HTTP library that checks the controller's certificate as the settings say."""
    session = requests.Session()
    session.trust_env = False  # neither proxies nor passwords of the user's environment
    session.headers.update(dialect.headers)
    if access.certificate_sha256:
        session.verify = False  # the fingerprint is compared instead
        session.mount("https://", _PinnedAdapter(access.certificate_sha256))
    return session


class _PinnedAdapter(HTTPAdapter):
    """Accepts one certificate, by its fingerprint."""

    def __init__(self, sha256: str) -> None:
        self._sha256 = sha256
        super().__init__()

    def init_poolmanager(self, *args: Any, **kwargs: Any) -> None:
        """Hand the fingerprint on."""
        super().init_poolmanager(*args, **kwargs, assert_fingerprint=self._sha256)


def _body(response: requests.Response, end: float, what: str) -> bytes:
    """Read an answer of limited length in limited time: a line that delivers single bytes never exceeds a read's time limit."""
    parts: list[bytes] = []
    length = 0
    while part := response.raw.read1(65536):
        parts.append(part)
        length += len(part)
        if length > LONGEST_ANSWER:
            raise _nonsense(what, b"".join(parts), f"an answer of more than {LONGEST_ANSWER} bytes")
        if time.monotonic() > end:
            raise requests.ReadTimeout(f"the answer to {what} is not complete")
    return b"".join(parts)


def _states(status: int, body: bytes, what: str) -> list[Row]:
    if what == "logout" or (status == 204 and not body):
        return []
    try:
        document = json.loads(body) if body else {}
    except (ValueError, RecursionError):
        document = None
    if status >= 400:
        code, message = refusal(document)
        raise _refused(status, code, message, what)
    if status in (201, 202):
        return []
    try:
        return states(document)
    except ValueError as error:
        raise _nonsense(what, body, str(error)) from None


def _refused(status: int, code: int, message: str, what: str) -> Refused:
    if status == 503:
        return Refused(
            "The controller has no session left (503); it allows about 70 at a time, and one that is not logged out lasts 5 minutes.",
            "Close other programs that are connected to the controller, wait 5 minutes, then connect again.",
            status,
            code,
        )
    told = f": {message.rstrip('.')}" if message else ""
    return Refused(f"The controller refused {what!r} ({status}, code {code}){told}.", "", status, code)


def _nonsense(what: str, body: bytes, reason: str) -> DeviceError:
    excerpt = body[:EXCERPT].hex(" ")
    return DeviceError(
        f"The controller's answer to {what!r} is invalid ({reason}): {excerpt or 'nothing'}.",
        "Check that the address is that of the robot's controller, and the version of Robot Web Services.",
    )


def _refuse_garbage(error: BaseException, what: str) -> None:
    """Raise DeviceError where something answered that does not speak HTTP, or is not the controller."""
    if isinstance(error, requests.exceptions.SSLError):
        raise DeviceError(
            f"The controller's certificate is not accepted: {error}.",
            "Enter the fingerprint of the controller's certificate in the robot's settings, after comparing it at the controller.",
        ) from error
    cause: BaseException | None = error
    while cause is not None:
        for one in (cause, *cause.args):
            if isinstance(one, http.client.HTTPException) and not isinstance(
                one, http.client.RemoteDisconnected | http.client.IncompleteRead
            ):
                raise _nonsense(what, str(one).encode(), f"no HTTP: {type(one).__name__}") from error
        cause = cause.__cause__ or cause.__context__
