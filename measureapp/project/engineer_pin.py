"""The engineer's PIN or password: only a salted scrypt hash of it is stored (RFC 7914). Wrong attempts slow down the next ones."""

from __future__ import annotations

import hashlib
import hmac
import secrets
from math import ceil
from pathlib import Path
from typing import Literal

from pydantic import Field, ValidationError

from measureapp.data.model import Model, first_problem
from measureapp.errors import InputError, StorageError
from measureapp.project.atomic import write_text

SHORTEST = 4  # characters
SALT_BYTES, KEY_BYTES = 16, 32
COST, BLOCKS, LANES = 2**14, 8, 1  # scrypt's N, r, p: 16 MB and about 50 ms
FREE_ATTEMPTS = 3
LONGEST_WAIT_S = 300.0
RESET = "If the PIN is forgotten, run `measureapp gui --reset-engineer-pin` on this computer, then set a new one."


class StoredPin(Model):
    """What is stored of a PIN, and how often a wrong one was given since the last right one."""

    schema_version: Literal[1] = 1
    salt: str = Field(pattern=r"^[0-9a-f]+$")
    key: str = Field(pattern=r"^[0-9a-f]+$")
    cost: int = Field(default=COST, ge=2**10, le=2**20)
    blocks: int = Field(default=BLOCKS, ge=1, le=32)
    lanes: int = Field(default=LANES, ge=1, le=16)
    wrong: int = Field(default=0, ge=0)
    last_wrong_s: float = 0.0  # seconds since 1970


def pin_file() -> Path:
    """Return the file of the PIN, below the user's home."""
    return Path.home() / "MeasureApp" / "engineer_pin.json"


def has_pin(file: Path) -> bool:
    """Whether a PIN is set; a damaged file counts as one, so that damaging it opens nothing."""
    return file.exists()


def set_pin(file: Path, pin: str) -> None:
    """Store another PIN.

    Raises
    ------
    InputError
        It is too short.
    StorageError
        The file cannot be written.
    """
    if len(pin) < SHORTEST:
        raise InputError(f"The PIN has fewer than {SHORTEST} characters.", f"Choose one with {SHORTEST} or more digits or letters.")
    salt = secrets.token_bytes(SALT_BYTES)
    empty = StoredPin(salt=salt.hex(), key="00")
    write_text(file, empty.model_copy(update={"key": _key(pin, empty).hex()}).model_dump_json(indent=2))


def check_pin(file: Path, pin: str, now_s: float) -> bool:
    """Return whether ``pin`` is the one stored; a wrong one is counted. Takes about 50 ms.

    Raises
    ------
    InputError
        Too many wrong attempts: the message names the seconds to wait.
    StorageError
        The file is damaged or cannot be written.
    """
    stored = _read(file)
    left_s = seconds_to_wait(stored, now_s)
    if left_s > 0:
        raise InputError(f"Too many wrong attempts. Wait {ceil(left_s)} s.", RESET)
    right = hmac.compare_digest(_key(pin, stored), bytes.fromhex(stored.key))
    if right and not stored.wrong:
        return True
    counted = {"wrong": 0} if right else {"wrong": stored.wrong + 1, "last_wrong_s": now_s}
    write_text(file, stored.model_copy(update=counted).model_dump_json(indent=2))
    return right


def seconds_to_wait(stored: StoredPin, now_s: float) -> float:
    """Return how long no attempt is accepted: 2 s after the third wrong one, twice as long after each further one.

    A clock that was set back does not lock anyone out for longer than that.
    """
    if stored.wrong < FREE_ATTEMPTS:
        return 0.0
    wait_s = float(min(2.0 ** (stored.wrong - FREE_ATTEMPTS + 1), LONGEST_WAIT_S))
    return min(max(0.0, stored.last_wrong_s + wait_s - now_s), wait_s)


def remove_pin(file: Path) -> bool:
    """Remove the PIN, and return whether there was one. Raises StorageError."""
    try:
        existed = file.exists()
        file.unlink(missing_ok=True)
    except OSError as error:
        raise StorageError(f"{file} cannot be removed: {error.strerror or error}.", "Check the permissions.") from error
    return existed


def _read(file: Path) -> StoredPin:
    try:
        return StoredPin.model_validate_json(file.read_bytes())
    except OSError as error:
        raise StorageError(f"{file} cannot be read: {error.strerror or error}.", RESET) from error
    except ValidationError as error:
        raise StorageError(f"{file} is damaged: {first_problem(error, 'the PIN')}.", RESET) from error


def _key(pin: str, stored: StoredPin) -> bytes:
    salt = bytes.fromhex(stored.salt)
    memory = 256 * stored.cost * stored.blocks  # twice what scrypt needs
    return hashlib.scrypt(pin.encode(), salt=salt, n=stored.cost, r=stored.blocks, p=stored.lanes, maxmem=memory, dklen=KEY_BYTES)
