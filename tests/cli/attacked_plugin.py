"""A plugin of its own in a temporary folder: the virtual rig with one thing going wrong, and a record of every stop."""

from __future__ import annotations

from pathlib import Path

MANIFEST = """
id = "attacked_rig"
name = "Attacked rig"
version = "1"
api = 2

[drives.rig]
entry = "driver:connect"
settings = "settings:Settings"
"""
SETTINGS = """
from measureapp.data.model import Model

class Settings(Model):
    attack: str = ""
    record: str
    shipped: str
    time_scale: float = 0.0
"""
DRIVER = '''
import errno
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from measureapp.devices.plugin_loader import load_driver
from measureapp.geometry.transform import RigidTransform

TURN = RigidTransform.from_vector([0.0, 0.0, 0.01], [0.0, 0.0, 0.0], "flange", "flange")  # 0.57 degrees


def connect(request):
    virtual = load_driver(Path(request.settings.shipped), "virtual_rig", "rig")
    settings = virtual.settings(part="gypsum", seed=1, time_scale=request.settings.time_scale)
    rig = virtual.entry(replace(request, settings=settings))
    record = Path(request.settings.record)
    for device in rig.devices:
        record_calls(device, record)
    ATTACKS[request.settings.attack](rig)
    return rig


def record_calls(device, record):
    stop, move = device.stop, getattr(device, "move_to", None)

    def note(what):
        with record.open("a", encoding="utf-8") as file:
            file.write(f"{time.time():.4f} {what} {type(device).__name__} {device.name}\\n")

    def stopping():
        stop()
        note("stop")

    def moving(goal, *, timeout_s):
        note("move")
        move(goal, timeout_s=timeout_s)

    device.stop = stopping
    if move is not None:
        device.move_to = moving


def at_second(device, name, instead):
    """Let the second call of a method do something else."""
    genuine, calls = getattr(device, name), []

    def method(*args, **kwargs):
        calls.append(1)
        return instead(genuine, *args, **kwargs) if len(calls) == 2 else genuine(*args, **kwargs)

    setattr(device, name, method)


def oserror(rig):
    def fail(genuine, goal, *, timeout_s):
        raise OSError(errno.ECONNRESET, "Connection reset by peer")

    at_second(rig.table, "move_to", fail)


def value_error(rig):
    def fail(genuine, *, timeout_s):
        raise ValueError("bad reply")

    at_second(rig.cameras["right"], "next_frame", fail)


def stop_fails(rig):
    oserror(rig)

    def fail():
        raise OSError(errno.EHOSTUNREACH, "No route to host")

    rig.robot.stop = fail


def stuck(rig):
    at_second(rig.table, "move_to", lambda genuine, goal, *, timeout_s: None)


def turning(rig):
    """The flange turns with the first image; its position stays."""
    pose, next_frame, taken = rig.robot.pose, rig.cameras["right"].next_frame, []

    def noting(*, timeout_s):
        taken.append(1)
        return next_frame(timeout_s=timeout_s)

    rig.cameras["right"].next_frame = noting
    rig.robot.pose = lambda: pose() @ TURN if taken else pose()


def spoiled(change):
    """Change one image of the right camera at the second viewpoint, in every try."""

    def attack(rig):
        camera, table, kept = rig.cameras["right"], rig.table, []
        genuine = camera.next_frame

        def next_frame(*, timeout_s):
            frame = genuine(timeout_s=timeout_s)
            first_view = abs(table.angle_rad() - 0.1745) < 1e-3  # at 10 degrees
            if first_view:
                kept.append(frame.pixels)
                return frame
            return replace(frame, pixels=change(frame, kept)) if frame.number == 5 else frame

        camera.next_frame = next_frame

    return attack


def of_view_before(frame, kept):
    return kept[frame.number].copy()


def all_stale(rig):
    camera, table, kept = rig.cameras["right"], rig.table, []
    genuine = camera.next_frame

    def next_frame(*, timeout_s):
        frame = genuine(timeout_s=timeout_s)
        if abs(table.angle_rad() - 0.1745) < 1e-3:
            kept.append(frame.pixels)
            return frame
        return replace(frame, pixels=kept[frame.number].copy())

    camera.next_frame = next_frame


def half_black(frame, kept):
    pixels = frame.pixels.copy()
    pixels[len(pixels) // 2:] = 0
    return pixels


ATTACKS = {
    "": lambda rig: None,
    "oserror": oserror,
    "value error": value_error,
    "stop fails": stop_fails,
    "stuck": stuck,
    "turning": turning,
    "all stale": all_stale,
    "stale": spoiled(of_view_before),
    "half black": spoiled(half_black),
    "half exposure": spoiled(lambda frame, kept: frame.pixels // 2),
    "wrapped": spoiled(lambda frame, kept: (frame.pixels.astype(np.uint16) * 16).astype(np.uint8)),
}
'''


def write_plugin(folder: Path) -> None:
    """Write the plugin below ``folder``."""
    (folder / "attacked_rig").mkdir(parents=True)
    for name, text in (("plugin.toml", MANIFEST), ("settings.py", SETTINGS), ("driver.py", DRIVER)):
        (folder / "attacked_rig" / name).write_text(text, encoding="utf-8")
