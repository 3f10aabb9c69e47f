"""Stopping a rig: all devices in parallel, from any thread, and nothing moves again before a reset."""

from __future__ import annotations

import threading
import time
from collections.abc import Sequence

from measureapp.devices.rig import Device, Rig
from measureapp.errors import MeasureError

STOP_WITHIN_S = 0.2  # a device that has not confirmed by then is named


def abort(rig: Rig, reason: str, *, latch: bool = True) -> str:
    """Stop every device of ``rig`` now, by default latch the stop, and return what a person must know, empty if all devices confirmed.

    May be called from any thread, also while another one waits for a device. Axes are asked before cameras and projector, each on
    a thread of its own, so that one that blocks or fails does not keep the others moving.
    """
    if latch:
        rig.latch.set(reason)
    unconfirmed = _stop(rig.devices)
    if not unconfirmed:
        return ""
    return f"Not every device confirmed the stop: {'; '.join(unconfirmed)}. Use the emergency stop and check these devices."


def reset(rig: Rig) -> None:
    """Let a stopped rig run again; a person has to have removed the cause."""
    rig.latch.reset()


def _stop(devices: Sequence[Device]) -> list[str]:
    """Stop devices in parallel; return those that did not confirm, with the reason of each."""
    outcomes = ["no answer"] * len(devices)

    def stop(index: int) -> None:
        try:
            devices[index].stop()
        except MeasureError as error:
            outcomes[index] = error.message.rstrip(".")
        except BaseException as error:  # foreign code may raise anything
            outcomes[index] = f"{type(error).__name__}: {error}"
        else:
            outcomes[index] = ""

    threads = [
        threading.Thread(target=stop, args=(index,), name=f"stop {device.name}", daemon=True) for index, device in enumerate(devices)
    ]
    for thread in threads:
        thread.start()
    deadline = time.monotonic() + STOP_WITHIN_S
    for thread in threads:
        thread.join(max(0.0, deadline - time.monotonic()))
    return [f"{device.name}: {problem}" for device, problem in zip(devices, outcomes.copy(), strict=True) if problem]
