"""A login with what is done through it, closed in every case; logins that a crashed program left open are closed at the next start."""

from __future__ import annotations

import hashlib
import json
import logging
import os
from collections.abc import Callable
from pathlib import Path
from types import TracebackType

import psutil  # type: ignore[import-untyped]

from .controller import Controller
from .dialect import VERSIONS, Dialect
from .mailbox import Mailbox
from .session import Access, RwsSession, http_session
from .settings import AbbSettings

_log = logging.getLogger(__name__)


class Login:
    """One session and the typed calls on it."""

    def __init__(self, session: RwsSession, controller: Controller, mailbox: Mailbox, kept: Path) -> None:
        self.session, self.controller, self.mailbox, self._kept = session, controller, mailbox, kept

    def on_renewed(self, check: Callable[[], None]) -> None:
        """Call ``check`` whenever the controller had forgotten the session."""
        self.session.renewed = check

    def close(self) -> None:
        """Log out."""
        self.session.log_out()
        self._kept.unlink(missing_ok=True)

    def __enter__(self) -> Login:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()


def open_login(settings: AbbSettings, owner: str, reply_timeout_s: float, loss_s: float) -> Login:
    """Log in. Raises DeviceError as `RwsSession.log_in`."""
    dialect = VERSIONS[settings.version]
    access = Access(
        settings.address,
        settings.user,
        settings.password.get_secret_value(),
        settings.certificate_sha256,
        reply_timeout_s,
        loss_s,
        settings.login_patience_s,
    )
    _close_left_logins(access, dialect)
    session = RwsSession(access, dialect)
    try:
        session.log_in()
    except BaseException:
        session.log_out()
        raise
    controller = Controller(session, {"task": settings.task, "module": settings.module, "unit": settings.mechanical_unit})
    kept = _keep(settings.address, session.cookies)
    return Login(session, controller, Mailbox(controller, owner, settings.take_over), kept)


def state_folder() -> Path:
    """Return the folder where open logins are noted."""
    base = os.environ.get("XDG_STATE_HOME") or os.environ.get("LOCALAPPDATA")
    return (Path(base) if base else Path.home() / ".local" / "state") / "measureapp" / "rws"


def _keep(address: str, cookies: dict[str, str]) -> Path:
    """Note a login, readable by this user alone, so that it can be closed after a crash."""
    folder = state_folder()
    text = json.dumps({"address": address, "cookies": cookies})
    path = folder / f"{os.getpid()}-{hashlib.sha256(text.encode()).hexdigest()[:12]}.json"
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        with os.fdopen(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "w", encoding="utf-8") as file:
            file.write(text)
    except OSError as error:
        _log.warning("the login cannot be noted for a crash: %s", error)
    return path


def _close_left_logins(access: Access, dialect: Dialect) -> None:
    """Log out what ended programs of this user have left open at this controller."""
    for path in sorted(state_folder().glob("*-*.json")):
        process = path.name.partition("-")[0]
        if not process.isdecimal() or psutil.pid_exists(int(process)):
            continue
        try:
            noted = json.loads(path.read_text(encoding="utf-8"))
            if noted["address"] != access.address:
                continue
            with http_session(access, dialect) as http:
                http.get(access.address + dialect.path("logout", {}), cookies=noted["cookies"], timeout=access.reply_timeout_s)
            _log.warning("the login of a crashed program at %s was closed", access.address)
        except (OSError, ValueError, KeyError, TypeError) as error:
            _log.warning("%s: %s", path, error)
        path.unlink(missing_ok=True)
