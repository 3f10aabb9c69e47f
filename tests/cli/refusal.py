"""What every refusal of the command line must look like, and the words that the command lines of these tests are written in."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from measureapp.cli import main
from measureapp.resources import resource

NOMINAL = str(resource("parts/gypsum/nominal.stl"))
PROGRAM = str(resource("parts/gypsum/program.toml"))


def refused(capsys: pytest.CaptureFixture[str], arguments: list[str], code: int = 2) -> str:
    """Run a command for people and for programs; return the sentence after all checks that every refusal must pass."""
    assert main(arguments) == code
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("measureapp: ") and said.err.endswith("\n") and said.err.count("\n") == 1, said.err
    assert "Traceback" not in said.err and "Errno" not in said.err
    assert main([*arguments, "--json"]) == code
    written = capsys.readouterr()
    assert written.err == ""
    document = json.loads(written.out)
    assert document.keys() == {"error"}
    assert document["error"].keys() == {"type", "message", "hint"}
    assert document["error"]["message"].endswith((".", "?", ")"))
    assert document["error"]["hint"].endswith(".")
    assert said.err == f"measureapp: {document['error']['message']} {document['error']['hint']}\n"
    return said.err


def refused_with(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    """Run a command for programs that must be refused as bad input; return the kind of error and its sentence."""
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == 2
    error = json.loads(capsys.readouterr().out)["error"]
    assert error["hint"]
    return f"{error['type']}: {error['message']}"


def filled(line: str, shelf: Path, out: Path, given: str) -> list[str]:
    known = {
        "NOMINAL": NOMINAL,
        "PROGRAM": PROGRAM,
        "PLAN": str(shelf / "plan.json"),
        "POSES": str(shelf / "poses.csv"),
        "CAMERAS": str(shelf / "cameras.json"),
        "MANIFEST": str(shelf / "MANIFEST.toml"),
        "left=IMAGE": f"left={shelf / 'left' / '1000_0.png'}",
        "IN": given,
        "left=IN": f"left={given}",
    }
    return [known.get(word, word.replace("OUT", str(out))) for word in line.split()]


def cut_in_half(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
