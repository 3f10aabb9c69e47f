"""One program at a time on a cell: what holds a rig is locked, and another program is told who has it."""

from __future__ import annotations

import getpass
import json
import logging
import os
import socket
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from datetime import datetime
from hashlib import blake2b
from pathlib import Path

from filelock import FileLock, Timeout

from measureapp.data.rig import RigDescription
from measureapp.errors import DeviceError

SIMULATED = ("virtual_rig", "camera_folder")  # drivers of devices that any number of programs may use
ADDRESS = ("address", "host", "tcp_port", "port", "usb_serial", "serial")  # settings that say which device is meant
_log = logging.getLogger(__name__)


def hold_rig(rig: RigDescription) -> Callable[[], None]:
    """Lock the devices of ``rig`` for this program, and return the function that releases them.

    Each device is locked by its address, so that two descriptions of one cell exclude each other, too. The system releases the locks of
    a program that dies. They lie in the user's folder: programs of another user, or on another computer, are not seen.

    Raises
    ------
    DeviceError
        Another program, or this one, has connected one of the devices; names the holder.
    """
    held = ExitStack()
    try:
        for place in places(rig):
            held.callback(_hold(rig.name, place))
    except BaseException:
        held.close()
        raise
    return held.close


def places(rig: RigDescription) -> tuple[str, ...]:
    """Return what identifies the devices of ``rig``: addresses and serial numbers, or its name where it tells none; nothing if simulated."""
    if set(rig.drivers.values()) <= set(SIMULATED):
        return ()
    choices = {name: choice.settings for name, choice in rig.devices.items() if choice.driver not in SIMULATED}
    tables = (rig.driver_settings, *rig.links.values(), *choices.values())
    serials = (camera.serial for camera in rig.cameras if rig.drivers[camera.name] not in SIMULATED)
    found = {*filter(None, map(_address, tables)), *(f"camera {serial}" for serial in serials if serial)}
    return tuple(sorted(found)) or (rig.name,)


def folder_of_locks() -> Path:
    """Return where the locks of this user lie."""
    return Path(os.environ.get("XDG_STATE_HOME") or Path.home()) / "MeasureApp" / "rigs_in_use"


def _address(settings: Mapping[str, object]) -> str:
    return " ".join(f"{name} {settings[name]}" for name in ADDRESS if settings.get(name))


def _hold(rig: str, place: str) -> Callable[[], None]:
    """Lock one device. The file beside the lock names the holder; it says nothing once the lock is free."""
    name = blake2b(place.encode(), digest_size=8).hexdigest()
    folder = folder_of_locks()
    lock = FileLock(folder / f"{name}.lock", timeout=0, thread_local=False)  # a window connects and closes on different threads
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock.acquire()
    except Timeout as error:
        raise DeviceError(
            f"Rig {rig} is in use: {_read_holder(folder / f'{name}.json')} has connected {place}.",
            "Disconnect the rig there first. Projects can be opened, processed and reported here meanwhile, without the rig.",
        ) from error
    except (OSError, NotImplementedError) as error:  # no reason to keep a person from the rig
        _log.warning("%s cannot be locked, so that another program could use it at the same time: %s", place, error)
        return lambda: None
    _write_holder(folder / f"{name}.json", place)
    return lock.release


def _write_holder(path: Path, place: str) -> None:
    holder = {
        "device": place,
        "process": os.getpid(),
        "user": getpass.getuser(),
        "computer": socket.gethostname(),
        "since": datetime.now().astimezone().isoformat(timespec="seconds"),
    }
    try:
        path.write_text(json.dumps(holder), encoding="utf-8")
    except OSError as error:
        _log.warning("%s cannot be written: %s", path, error)


def _read_holder(path: Path) -> str:
    """Return the holder in words, also where its file is damaged or not yet written."""
    try:
        entry = json.loads(path.read_text(encoding="utf-8"))
        who = "this program" if entry["process"] == os.getpid() else f"another program, process {entry['process']}"
        return f"{who} (user {entry['user']} at {entry['computer']}, since {entry['since']})"
    except (OSError, ValueError, KeyError, TypeError):
        return "another program"
