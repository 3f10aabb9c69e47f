"""States of the controller in words, and what a person does about them."""

from __future__ import annotations

STATES = {
    "motoron": ("motors on", ""),
    "motoroff": ("motors off", "Switch the motors on."),
    "guardstop": ("protective stop: a guard is open", "Close the guard and acknowledge it, then switch the motors on."),
    "emergencystop": (
        "emergency stop",
        "Remove the cause, release the emergency stop, press the motors-on button, then connect again.",
    ),
    "emergencystopreset": ("emergency stop released, motors off", "Press the motors-on button, then connect again."),
    "sysfail": ("system failure", "Read the event log on the FlexPendant and restart the controller."),
    "init": ("starting", "Wait until the controller has started."),
}
MODES = {
    "AUTO": ("automatic mode", ""),
    "MANR": ("manual mode with reduced speed", "Turn the key to automatic mode, confirm it on the FlexPendant, then connect again."),
    "MANF": ("manual mode with full speed", "Turn the key to automatic mode, confirm it on the FlexPendant, then connect again."),
    "AUTO_CH": ("changing to automatic mode", "Confirm automatic mode on the FlexPendant, then connect again."),
    "MANF_CH": ("changing to manual mode", "Turn the key to automatic mode, then connect again."),
    "INIT": ("starting", "Wait until the controller has started."),
}


def state_words(ctrlstate: str) -> tuple[str, str]:
    """Return a state of the motors and its remedy."""
    return STATES.get(ctrlstate, (f"state {ctrlstate}", "Read the event log on the FlexPendant."))


def mode_words(opmode: str) -> tuple[str, str]:
    """Return an operating mode and its remedy."""
    return MODES.get(opmode, (f"mode {opmode}", "Select automatic mode."))
