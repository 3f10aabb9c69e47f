"""Resources of the virtual controller: what each path and action reads or does."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from measureapp.peers.rws.arm import configuration
from measureapp.peers.rws.machine import Machine
from measureapp.peers.rws.replies import BAD_FORM, HELD_BY_OTHER, NOT_FOUND, NOT_MASTER, WRONG_STATE, Answer, refusal, state
from measureapp.peers.rws.sessions import Session, Sessions
from measureapp.peers.rws.symbols import parse, same_shape, write

DONE = Answer(204)
START_FIELDS = ("regain", "execmode", "cycle", "condition", "stopatbp", "alltaskbytsp")
UNUSED_AXES = {f"eax_{letter}": "0" for letter in "abcdef"}


@dataclass(frozen=True)
class Call:
    """One request, in the words of version 1.0: the path below /rw, the action of a POST, query and form."""

    method: str
    path: str
    action: str
    query: Mapping[str, str]
    form: Mapping[str, str]
    session: Session


@dataclass
class Cell:
    """What the resources work on."""

    machine: Machine
    sessions: Sessions
    implicit_mastership: bool = True  # a write while nobody is master passes


Handler = Callable[[Cell, Call, re.Match[str]], Answer]


def answer(cell: Cell, call: Call) -> Answer:
    """Answer one request."""
    for method, pattern, action, handler in ROUTES:
        match = re.fullmatch(pattern, call.path)
        if match and method == call.method and action == call.action:
            with cell.machine.lock:
                return handler(cell, call, match)
    return refusal(404, NOT_FOUND, f"The resource /rw/{call.path} does not exist.")


def read_system(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """Name, version and id of the system, then its options."""
    machine = cell.machine
    first = state("sys-system-li", "system", name="Virtual", rwversion=machine.version, rwversionname="6.15", sysid=machine.system_id)
    return Answer(states=(first, state("sys-options-li", "options", option="616-1 PC Interface")))


def read_ctrlstate(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """State of the motors."""
    return Answer(states=(state("pnl-ctrlstate", "ctrlstate", ctrlstate=cell.machine.ctrlstate),))


def set_ctrlstate(cell: Cell, call: Call, _match: re.Match[str]) -> Answer:
    """Switch the motors."""
    machine, wanted = cell.machine, call.form.get("ctrl-state", "")
    if wanted not in ("motoron", "motoroff"):
        return refusal(400, BAD_FORM, "The parameter ctrl-state is missing or invalid.")
    if wanted == "motoroff":
        if machine.ctrlstate == "motoron":
            machine.switch_motors_off()
        return DONE
    if machine.opmode != "AUTO" or machine.ctrlstate not in ("motoron", "motoroff"):
        return refusal(403, WRONG_STATE, f"Motors cannot be switched on in state {machine.ctrlstate}, mode {machine.opmode}.")
    machine.ctrlstate = "motoron"
    return DONE


def read_opmode(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """Operating mode."""
    return Answer(states=(state("pnl-opmode", "opmode", opmode=cell.machine.opmode),))


def read_speed_ratio(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """Speed in percent."""
    return Answer(states=(state("pnl-speedratio", "speedratio", speedratio=round(cell.machine.program.speed_ratio * 100)),))


def set_speed_ratio(cell: Cell, call: Call, _match: re.Match[str]) -> Answer:
    """Set the speed in percent, 1…100."""
    try:
        percent = float(call.form.get("speed-ratio", ""))
    except ValueError:
        percent = 0.0
    if not 1.0 <= percent <= 100.0:
        return refusal(400, BAD_FORM, "The parameter speed-ratio is missing or invalid.")
    cell.machine.program.speed_ratio = percent / 100.0
    return DONE


def read_mastership(cell: Cell, call: Call, match: re.Match[str]) -> Answer:
    """Who is master of a domain."""
    return Answer(states=tuple(_mastership(cell, call, domain) for domain in _domains(match)))


def request_mastership(cell: Cell, call: Call, match: re.Match[str]) -> Answer:
    """Become master."""
    held = [domain for domain in _domains(match) if cell.sessions.masters.get(domain, call.session.key) != call.session.key]
    if held:
        return refusal(403, HELD_BY_OTHER, f"Mastership of {held[0]} is held by another client.")
    if cell.machine.opmode != "AUTO":
        return refusal(403, WRONG_STATE, f"Mastership is not granted in mode {cell.machine.opmode}.")
    cell.sessions.masters.update(dict.fromkeys(_domains(match), call.session.key))
    return DONE


def release_mastership(cell: Cell, call: Call, match: re.Match[str]) -> Answer:
    """Hand mastership back."""
    held = [domain for domain in _domains(match) if cell.sessions.masters.get(domain) == call.session.key]
    if not held:
        return refusal(403, NOT_MASTER, "The client does not hold mastership.")
    for domain in held:
        del cell.sessions.masters[domain]
    return DONE


def read_tasks(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """RAPID tasks."""
    running = "started" if cell.machine.is_running() else "stopped"
    return Answer(
        states=(
            state("rap-task-li", "T_ROB1", name="T_ROB1", type="norm", taskstate="link", excstate=running, active="On", motiontask="TRUE"),
        )
    )


def switch_task(_cell: Cell, _call: Call, match: re.Match[str]) -> Answer:
    """Accept the activation of the one task."""
    return DONE if match.group(1) == "T_ROB1" else refusal(400, NOT_FOUND, f"There is no task {match.group(1)}.")


def read_execution(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """Whether programs run."""
    running = "running" if cell.machine.is_running() else "stopped"
    return Answer(states=(state("rap-execution", "execution", ctrlexecstate=running, cycle="forever"),))


def start(cell: Cell, call: Call, _match: re.Match[str]) -> Answer:
    """Start the program at its pointer."""
    missing = [name for name in START_FIELDS if name not in call.form]
    if missing:
        return refusal(400, BAD_FORM, f"The parameter {missing[0]} is missing.")
    machine = cell.machine
    if machine.ctrlstate != "motoron" or machine.opmode != "AUTO":
        return refusal(403, WRONG_STATE, f"Programs cannot be started in state {machine.ctrlstate}, mode {machine.opmode}.")
    if machine.is_running():
        return refusal(409, WRONG_STATE, "The program is running already.")
    return _if_master(cell, call) or _done(machine.program.start)


def stop(cell: Cell, call: Call, _match: re.Match[str]) -> Answer:
    """Stop the program; needs no mastership."""
    if call.form.get("stopmode", "stop") not in ("cycle", "instr", "stop", "qstop"):
        return refusal(400, BAD_FORM, "The parameter stopmode is invalid.")
    return _done(cell.machine.program.stop)


def reset_pointer(cell: Cell, call: Call, _match: re.Match[str]) -> Answer:
    """Set the program pointer to main."""
    if cell.machine.is_running():
        return refusal(409, WRONG_STATE, "The program pointer cannot be moved while the program runs.")
    return _if_master(cell, call) or _done(cell.machine.program.reset_pointer)


def read_symbol(cell: Cell, _call: Call, match: re.Match[str]) -> Answer:
    """Value of a data object."""
    cell.machine.program.advance()
    found = cell.machine.program.symbols.find(match.group("name"))
    if found is None:
        return _no_symbol(match)
    return Answer(states=(state("rap-data", match.group("name"), value=write(found.value)),))


def set_symbol(cell: Cell, call: Call, match: re.Match[str]) -> Answer:
    """Write a data object."""
    cell.machine.program.advance()
    name, found = match.group("name").lower(), cell.machine.program.symbols.find(match.group("name"))
    if found is None:
        return _no_symbol(match)
    if cell.machine.opmode != "AUTO":
        return refusal(403, WRONG_STATE, f"Remote access is not granted in mode {cell.machine.opmode}.")
    try:
        value = parse(call.form.get("value", ""))
    except ValueError as error:
        return refusal(400, BAD_FORM, f"The value is invalid: {error}.")
    if found.storage == "CONST" or not same_shape(value, found.value):
        return refusal(400, BAD_FORM, f"The value does not fit {found.storage} {found.type} {name}.")
    refused = _if_master(cell, call)
    if refused is None:
        found.value = value
        cell.machine.program.written(name)
    return refused or DONE


def symbol_properties(cell: Cell, _call: Call, match: re.Match[str]) -> Answer:
    """Type of a data object."""
    found = cell.machine.program.symbols.find(match.group("name"))
    if found is None:
        return _no_symbol(match)
    symtyp = {"PERS": "per", "CONST": "con", "VAR": "var"}[found.storage]
    return Answer(states=(state("rap-sympropper", match.group("name"), symtyp=symtyp, dattyp=found.type, name=match.group("name")),))


def search_symbols(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """List the persistent data."""
    found = cell.machine.program.symbols.persistents()
    rows = (state("rap-sympropper-li", f"RAPID/T_ROB1/{name}", symtyp="per", dattyp=one.type, name=name) for name, one in found.items())
    return Answer(states=tuple(rows))


def read_jointtarget(cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """Joint angles in degrees."""
    joints = {f"rax_{axis}": f"{angle:.7g}" for axis, angle in enumerate(cell.machine.joints_deg(), start=1)}
    return Answer(states=(state("ms-jointtarget", "ROB_1", **joints, **UNUSED_AXES),))


def read_robtarget(cell: Cell, call: Call, _match: re.Match[str]) -> Answer:
    """Pose of the flange; the virtual controller knows tool0 and wobj0 in its base alone, which is its world, too."""
    if call.query.get("tool", "tool0") != "tool0" or call.query.get("wobj", "wobj0") != "wobj0":
        return refusal(400, NOT_FOUND, "The tool or work object does not exist.")
    (x, y, z), quaternion = cell.machine.flange_position_mm()
    turns = dict(zip(("cf1", "cf4", "cf6", "cfx"), configuration(cell.machine.joints_deg()), strict=True))
    rotation = {f"q{index}": f"{part:.9g}" for index, part in enumerate(quaternion, start=1)}
    position = {"x": f"{x:.7g}", "y": f"{y:.7g}", "z": f"{z:.7g}"}
    return Answer(states=(state("ms-robtargets", "ROB_1", **position, **rotation, **turns, **{f"eax{x}": "9E+09" for x in "abcdef"}),))


def read_log(cell: Cell, call: Call, _match: re.Match[str]) -> Answer:
    """Messages of the event log."""
    entries = reversed(cell.machine.log) if call.query.get("order") == "lifo" else iter(cell.machine.log)
    rows = (
        state(
            "elog-message-li",
            f"/rw/elog/0/{one.number}",
            **{"msgtype": one.kind, "code": one.code, "src-name": "MC0", "tstamp": one.stamp, "argc": 0},
            **{"title": one.title, "desc": one.title, "conseqs": "", "causes": "", "actions": ""},
        )
        for one in entries
    )
    return Answer(states=tuple(rows))


def read_ramdisk(_cell: Cell, _call: Call, _match: re.Match[str]) -> Answer:
    """Path of the RAM disk."""
    return Answer(states=({"_type": "ctrl-env", "_title": "$RAMDISK", "_value": "/hd0a/ramdisk"},))


def _domains(match: re.Match[str]) -> tuple[str, ...]:
    return (match.group(1),) if match.group(1) else ("cfg", "motion", "rapid")


def _mastership(cell: Cell, call: Call, domain: str) -> dict[str, str]:
    holder = cell.sessions.masters.get(domain)
    session = cell.sessions.active.get(holder or "")
    if holder is None:
        return state("msh-resource", domain, uid=0, application="", mastership="nomaster", mastershipheldbyme="FALSE")
    mine = "TRUE" if holder == call.session.key else "FALSE"
    where = "remote" if session else "local"
    name = session.application if session else holder
    return state("msh-resource", domain, uid=session.number if session else 1, application=name, mastership=where, mastershipheldbyme=mine)


def _if_master(cell: Cell, call: Call) -> Answer | None:
    """Return the refusal of a client that is not master of RAPID."""
    holder = cell.sessions.masters.get("rapid")
    if holder not in (None, call.session.key):
        return refusal(403, HELD_BY_OTHER, "Mastership of rapid is held by another client.")
    if holder is None and not cell.implicit_mastership and call.query.get("mastership") != "implicit":
        return refusal(400, NOT_MASTER, "The client does not hold mastership of rapid.")
    return None


def _no_symbol(match: re.Match[str]) -> Answer:
    return refusal(400, NOT_FOUND, f"The symbol {match.group('name')} was not found.")


def _done(action: Callable[[], None]) -> Answer:
    action()
    return DONE


SYMBOL = r"RAPID/T_ROB1/(?:\w+/)?(?P<name>\w+)"
ROUTES: tuple[tuple[str, str, str, Handler], ...] = (
    ("GET", "system", "", read_system),
    ("GET", "panel/ctrlstate", "", read_ctrlstate),
    ("POST", "panel/ctrlstate", "setctrlstate", set_ctrlstate),
    ("GET", "panel/opmode", "", read_opmode),
    ("GET", "panel/speedratio", "", read_speed_ratio),
    ("POST", "panel/speedratio", "setspeedratio", set_speed_ratio),
    ("GET", "mastership(?:/(cfg|motion|rapid))?", "", read_mastership),
    ("POST", "mastership(?:/(cfg|motion|rapid))?", "request", request_mastership),
    ("POST", "mastership(?:/(cfg|motion|rapid))?", "release", release_mastership),
    ("GET", "rapid/tasks", "", read_tasks),
    ("POST", r"rapid/tasks/(\w+)", "activate", switch_task),
    ("POST", r"rapid/tasks/(\w+)", "deactivate", switch_task),
    ("GET", "rapid/execution", "", read_execution),
    ("POST", "rapid/execution", "start", start),
    ("POST", "rapid/execution", "stop", stop),
    ("POST", "rapid/execution", "resetpp", reset_pointer),
    ("GET", f"rapid/symbol/data/{SYMBOL}", "", read_symbol),
    ("POST", f"rapid/symbol/data/{SYMBOL}", "set", set_symbol),
    ("GET", f"rapid/symbol/properties/{SYMBOL}", "", symbol_properties),
    ("POST", "rapid/symbols", "search-symbols", search_symbols),
    ("GET", "motionsystem/mechunits/ROB_1/jointtarget", "", read_jointtarget),
    ("GET", "motionsystem/mechunits/ROB_1/robtarget", "", read_robtarget),
    ("GET", "elog/0/?", "", read_log),
    ("GET", r"ctrl/\$RAMDISK", "", read_ramdisk),
)
