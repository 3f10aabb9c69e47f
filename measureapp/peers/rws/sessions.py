"""Logins of the virtual controller: digest and basic authentication, sessions by cookie with a limit, mastership."""

from __future__ import annotations

import base64
import hashlib
import re
import time
import uuid
from dataclasses import dataclass, field

REALM = "validusers@robapi.abb"
PAIR = re.compile(r'(\w+)=(?:"([^"]*)"|([^\s,]+))')


@dataclass
class Session:
    """One login."""

    key: str
    number: int
    used_at: float
    application: str = "RobotWebServices"


@dataclass
class Sessions:
    """All logins, and who is master of what."""

    user: str = "Default User"
    password: str = "robotics"
    limit: int = 70
    idle_s: float = 300.0
    nonce: str = field(default_factory=lambda: uuid.uuid4().hex)
    active: dict[str, Session] = field(default_factory=dict)
    masters: dict[str, str] = field(default_factory=dict)  # domain → key of the session, or the name of who holds it at the pendant
    opened: int = 0

    def challenge(self, basic: bool) -> str:
        """Return the header of a 401 answer."""
        return f'Basic realm="{REALM}"' if basic else f'Digest realm="{REALM}", qop="auth", nonce="{self.nonce}", algorithm=MD5'

    def allows(self, authorization: str, method: str, basic: bool) -> bool:
        """Whether an Authorization header is right."""
        if basic:
            if not authorization.startswith("Basic "):
                return False
            return base64.b64decode(authorization[6:]).decode() == f"{self.user}:{self.password}"
        given = {name: quoted or plain for name, quoted, plain in PAIR.findall(authorization)}
        if given.get("username") != self.user or given.get("nonce") != self.nonce:
            return False
        secret = _md5(f"{self.user}:{REALM}:{self.password}")
        request = _md5(f"{method}:{given.get('uri', '')}")
        middle = ":".join(given.get(name, "") for name in ("nonce", "nc", "cnonce", "qop"))
        return given.get("response") == _md5(f"{secret}:{middle}:{request}")

    def find(self, key: str) -> Session | None:
        """Return a live session and mark it as used."""
        now = time.monotonic()
        for old in [one for one in self.active.values() if now - one.used_at > self.idle_s]:
            self.end(old.key)
        session = self.active.get(key)
        if session is not None:
            session.used_at = now
        return session

    def numbered(self, number: str) -> Session | None:
        """Return the live session of a number: websockets bring the second cookie alone."""
        return next((session for session in self.active.values() if str(session.number) == number), None)

    def open(self) -> Session | None:
        """Return a new session, None beyond the limit."""
        self.find("")
        if len(self.active) >= self.limit:
            return None
        self.opened += 1
        session = Session(uuid.uuid4().hex, self.opened, time.monotonic())
        self.active[session.key] = session
        return session

    def end(self, key: str) -> None:
        """Log a session out; its mastership goes with it."""
        self.active.pop(key, None)
        self.masters = {domain: holder for domain, holder in self.masters.items() if holder != key}

    def end_all(self) -> None:
        """Forget every login, as a restart does."""
        self.active.clear()
        self.masters.clear()
        self.nonce = uuid.uuid4().hex


def _md5(text: str) -> str:
    return hashlib.md5(text.encode(), usedforsecurity=False).hexdigest()
