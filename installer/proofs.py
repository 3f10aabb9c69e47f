"""The slow proofs, one file after the other: what passed is kept until a source changes, and all of it becomes one table."""

from __future__ import annotations

import hashlib
import json
import platform
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import machine
from trouble import SetupTrouble

SOURCES = ("measureapp", "ui", "plugins", "tests", "resources", "installer/requirements.lock", "pyproject.toml")
SUFFIXES = (".py", ".toml", ".lock")
CAMPAIGN = """folder = "campaign"
[demo]
parts = ["gypsum"]
rigs = ["ideal", "good", "usual", "bad"]
seeds = "1-3"
resolution = "quarter"
"""
Run = Callable[[Sequence[str]], int]  # arguments of the environment's Python; returns its exit code
NOTHING_SELECTED = 5
FAILED, PASSED, SKIPPED = "failed", "passed", "skipped"


def prove(root: Path, folder: Path, rooms: Sequence[str], run: Run) -> int:
    """Run the proofs of the rooms, all without any named, and the accuracy campaign with all; write ``proofs.json`` and ``proofs.md``.

    Parameters
    ----------
    root : the checkout
    folder : where answers are kept; those of the same sources that passed are not run again
    rooms : folders of ``tests``, such as ``pipeline``
    run : starts the environment's Python

    Raises
    ------
    SetupTrouble
        a room does not exist, or the tests cannot be collected
    """
    for room in rooms:
        if not (root / "tests" / room).is_dir():
            known = ", ".join(sorted(path.name for path in (root / "tests").iterdir() if path.is_dir() and path.name[0].isalpha()))
            raise SetupTrouble(f"There is no room tests/{room}.", f"Name one of: {known}.")
    folder.mkdir(parents=True, exist_ok=True)
    program, began = fingerprint(root), time.monotonic()
    files = _files(folder, rooms, run)
    answers = []
    for number, file in enumerate(files, start=1):
        answer = _kept(_place(folder, file), program)
        if answer is None:
            print(f"== {number} of {len(files)}: {file}{_left(folder, files[number - 1 :], program)}", flush=True)
            answer = _proven(folder, file, program, run)
        answers.append(answer)
        _write(folder, answers, [], len(files))
    coverage, code = ([], 0) if rooms else _campaign(folder, run)
    _write(folder, answers, coverage, len(files))
    wrong = [one for one in answers if one["code"] not in (0, NOTHING_SELECTED)]
    print(f"{len(answers)} files of proofs, {len(wrong)} failed, {(time.monotonic() - began) / 60:.0f} min; table: {folder / 'proofs.md'}")
    return 1 if wrong or code else 0


def fingerprint(root: Path) -> str:
    """Return what changes with any source, test, rig or part."""
    found = hashlib.sha256()
    for path in sorted(_sources(root)):
        found.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes())
    return found.hexdigest()


def _sources(root: Path) -> Iterator[Path]:
    for name in SOURCES:
        place = root / name
        yield from (path for path in ([place] if place.is_file() else place.rglob("*")) if path.suffix in SUFFIXES)


def _files(folder: Path, rooms: Sequence[str], run: Run) -> list[str]:
    """Return the files with slow tests, those of a room one after the other."""
    listing = folder / "collected.txt"
    places = [f"tests/{room}" for room in rooms] or ["tests"]
    collect = "import contextlib, pytest, sys\nwith open(sys.argv[1], 'w') as out, contextlib.redirect_stdout(out): sys.exit(pytest.main(sys.argv[2:]))"
    code = run(["-c", collect, str(listing), "-m", "slow", "--collect-only", "-q", *places])
    if code not in (0, NOTHING_SELECTED):
        raise SetupTrouble("The tests could not be collected.", f"The reason stands in {listing}.")
    lines = listing.read_text(encoding="utf-8").splitlines()
    return list(dict.fromkeys(line.partition("::")[0] for line in lines if line.startswith("tests/") and "::" in line))


def _place(folder: Path, file: str) -> Path:
    return folder / f"{file.removeprefix('tests/').removesuffix('.py').replace('/', '.')}.json"


def _kept(place: Path, program: str) -> dict[str, Any] | None:
    """Return the answer of the same sources, where it passed."""
    answer = _read(place)
    return answer if answer.get("program") == program and answer.get("code") == 0 else None


def _read(place: Path) -> dict[str, Any]:
    try:
        answer = json.loads(place.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return answer if isinstance(answer, dict) else {}


def _left(folder: Path, files: Sequence[str], program: str) -> str:
    """Say how long the remaining files took earlier, where that is known of all of them."""
    waiting = [place for place in (_place(folder, file) for file in files) if _kept(place, program) is None]
    earlier = [_read(place).get("seconds") for place in waiting]
    return "" if None in earlier else f" – about {sum(filter(None, earlier)) / 60:.0f} min left"


def _proven(folder: Path, file: str, program: str, run: Run) -> dict[str, Any]:
    """Run the slow tests of one file and keep what they answered."""
    report, speeds = folder / "report.xml", folder / "benchmark.json"
    for path in (report, speeds):
        path.unlink(missing_ok=True)
    timing = [f"--benchmark-json={speeds}"] if file.startswith("tests/benchmarks/") else []
    began = time.monotonic()
    code = run(["-m", "pytest", "-q", "-m", "slow", f"--junit-xml={report}", *timing, file])
    answer = {
        "file": file,
        "program": program,
        "code": code,
        "seconds": time.monotonic() - began,
        "machine": f"{platform.machine()}, {machine.processors()} processors, Python {platform.python_version()}",
        "proofs": _proofs(report, _speeds(speeds)),
    }
    _replace(_place(folder, file), json.dumps(answer, indent=1))
    return answer


def _proofs(report: Path, speeds: Mapping[str, Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Return name, outcome, seconds and recorded figures of each test of a JUnit report; none where pytest came to no report."""
    if not report.is_file():
        return []
    found = []
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        name = case.get("name", "")
        states = {child.tag for child in case}
        outcome = FAILED if states & {"failure", "error"} else SKIPPED if "skipped" in states else PASSED
        figures = {item.get("name", ""): item.get("value", "") for item in case.iter("property")}
        found.append(
            {"name": name, "outcome": outcome, "seconds": float(case.get("time", 0)), "figures": {**figures, **speeds.get(name, {})}}
        )
    return found


def _speeds(place: Path) -> dict[str, dict[str, Any]]:
    """Return the median time and further figures of each benchmark by its name."""
    benchmarks = _read(place).get("benchmarks", [])
    return {one["name"]: {"median, ms": f"{one['stats']['median'] * 1e3:.4g}", **one["extra_info"]} for one in benchmarks}


def _campaign(folder: Path, run: Run) -> tuple[list[dict[str, Any]], int]:
    """Measure virtual parts on all rigs; return how often U contains the truth, and the exit code."""
    print("== accuracy and coverage on the virtual rigs", flush=True)
    description, answer = folder / "campaign.toml", folder / "campaign.json"
    description.write_text(CAMPAIGN, encoding="utf-8")
    keep = "import contextlib, sys\nfrom measureapp.cli import main\nwith open(sys.argv[1], 'w') as out, contextlib.redirect_stdout(out): sys.exit(main(sys.argv[2:]))"
    code = run(["-c", keep, str(answer), "campaign", str(description), "--json"])
    document = _read(answer)
    # Parts out of tolerance give 1: that is an answer. Measurements without a result are failures.
    return document.get("coverage", []), 0 if code in (0, 1) and document.get("coverage") and not document.get("failed") else 1


def _write(folder: Path, answers: Sequence[Mapping[str, Any]], coverage: Sequence[Mapping[str, Any]], files: int) -> None:
    _replace(folder / "proofs.json", json.dumps({"files": files, "proofs": answers, "coverage": coverage}, indent=1))
    _replace(folder / "proofs.md", "\n".join(_table(answers, coverage, files)) + "\n")


def _table(answers: Sequence[Mapping[str, Any]], coverage: Sequence[Mapping[str, Any]], files: int) -> Iterator[str]:
    machines = sorted({one["machine"] for one in answers})
    yield from ("# Slow proofs", "", f"{len(answers)} of {files} files have run ({'; '.join(machines)}).", "")
    if coverage:
        yield from (
            "## Accuracy and coverage",
            "",
            "| part and rig | dimensions | within U | largest error | median U (k = 2) |",
            "|---|---|---|---|---|",
        )
        for group in coverage:
            sizes = f"{group['largest_error_mm']:.4f} mm | {group['median_u_mm']:.4f} mm"
            yield f"| {group['group']}, {group['measurements']} seeds | {group['dimensions']} | {group['inside']} | {sizes} |"
        yield ""
    if any(proof["figures"] for answer in answers for proof in answer["proofs"]):
        yield from ("## Figures and speed", "", "| proof | figure | value |", "|---|---|---|")
    for answer in answers:
        for proof in answer["proofs"]:
            name = f"{_place(Path(), answer['file']).stem}: {proof['name']}"
            yield from (f"| {_cell(name)} | {_cell(figure)} | {_cell(value)} |" for figure, value in proof["figures"].items())
    yield from ("", "## Outcomes", "", "| room | proofs passed | failed | skipped | minutes |", "|---|---|---|---|---|")
    for room in dict.fromkeys(answer["file"].split("/")[1] for answer in answers):
        inside = [answer for answer in answers if answer["file"].split("/")[1] == room]
        states = [proof["outcome"] for answer in inside for proof in answer["proofs"]]
        counts = " | ".join(str(states.count(state)) for state in (PASSED, FAILED, SKIPPED))
        yield f"| {room} | {counts} | {sum(answer['seconds'] for answer in inside) / 60:.1f} |"
    yield from _failures(answers)


def _failures(answers: Iterable[Mapping[str, Any]]) -> Iterator[str]:
    wrong = [(one["file"], one) for one in answers if one["code"] not in (0, NOTHING_SELECTED)]
    if wrong:
        yield from ("", "## Failed", "")
    for file, answer in wrong:
        names = [proof["name"] for proof in answer["proofs"] if proof["outcome"] == FAILED]
        yield f"- `{file}`: {', '.join(names) or 'pytest ended with code ' + str(answer['code'])}"


def _cell(value: object) -> str:
    return (f"{value:.5g}" if isinstance(value, float) else str(value)).replace("|", "\\|").replace("\n", " ")


def _replace(place: Path, text: str) -> None:
    """Write beside and replace, so that an interruption leaves the earlier answer."""
    beside = place.with_suffix(place.suffix + ".new")
    beside.write_text(text, encoding="utf-8")
    beside.replace(place)
