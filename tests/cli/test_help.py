"""The help of every command says what to write in words, not in types of the programming language."""

from __future__ import annotations

import re
import subprocess
import sys

import pytest

from measureapp.cli import main
from tests.cli.command_names import ALL_COMMANDS

GROUPS = sorted({command[:count] for command in ALL_COMMANDS for count in range(len(command))})
TYPES = re.compile(r"<|>|\b(list|tuple|dict|set)\[|\bOptional\b|\bNone\b|\bPath\b|\bstr\b|\bint\b|\bfloat\b|\bbool\b|\bNoneType\b|\{\w+\}")


def help_of(capsys, command):
    assert main([*command, "--help"]) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize("command", [*GROUPS, *ALL_COMMANDS], ids=" ".join)
def test_no_help_text_holds_a_python_type(capsys, command):
    said = help_of(capsys, command)
    assert not TYPES.findall(said), said
    assert said.startswith(f"Usage: measureapp {' '.join(command)}".rstrip())


@pytest.mark.parametrize("command", GROUPS, ids=" ".join)
def test_a_group_says_in_a_whole_sentence_what_each_command_does(capsys, command):
    listed = help_of(capsys, command).partition("Commands:")[2]
    assert listed.strip()
    assert "..." not in listed


def test_what_a_value_is_and_how_large_it_may_be_stands_in_words(capsys):
    said = " ".join(help_of(capsys, ("bracket",)).split())
    assert "--noise PATH" in said
    assert "--max-exposures NUMBER" in said
    assert "from 1 to 16" in said
    assert "at least 0.001" in said
    assert "plane, line, circle" in " ".join(help_of(capsys, ("fit",)).split())


def test_help_loads_none_of_the_large_libraries():
    """Help answers at once: what takes most of a start is loaded by the commands that use it."""
    code = "import sys; from measureapp.cli import main; main(['--help']); print([name for name in LARGE if name in sys.modules])"
    large = ("scipy", "pydantic", "cv2", "numba", "open3d", "trimesh", "typst", "PySide6", "vtkmodules")
    done = subprocess.run([sys.executable, "-c", f"LARGE = {large}; {code}"], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"
