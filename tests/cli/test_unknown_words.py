"""Options and commands that there are not, and no command at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from measureapp.cli import main
from tests.cli.command_names import ALL_COMMANDS
from tests.cli.refusal import refused


@pytest.mark.parametrize("command", [command for command in ALL_COMMANDS if command != ("gui",)], ids=" ".join)
def test_an_unknown_option_is_refused(command: tuple[str, ...], capsys) -> None:
    assert "--no-such-option" in refused(capsys, [*command, "--no-such-option"])


def test_gui_refuses_what_is_no_project_and_an_unknown_option(tmp_path: Path, capsys) -> None:
    assert main(["gui", str(tmp_path / "absent")]) == main(["gui", str(tmp_path)]) == main(["gui", "--no-such-option"]) == 2
    assert capsys.readouterr().err.count("\n") == 3


@pytest.mark.parametrize(
    ("given", "answer"),
    [
        (["--rig", "no_such"], "There is no world 'no_such'. Name one of "),
        (["--part", "notes.txt"], "notes.txt is not a supported mesh file."),
        (["--viewpoints", "0"], "Request 1 to 500."),
        (["--viewpoints", "1000000"], "Request 1 to 500."),
        (["--turn-deg", "nan", "0", "0"], "Give three angles in degrees."),
    ],
)
def test_the_demo_refuses_what_it_cannot_show(given: list[str], answer: str, tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "notes.txt").write_text("no mesh")
    assert answer in refused(capsys, ["demo", "--out", str(tmp_path / "new"), *given])
    assert not (tmp_path / "new").exists()


def test_an_unknown_command_is_refused(capsys) -> None:
    assert "nonsense" in refused(capsys, ["nonsense"])


def test_without_a_command_the_help_is_shown_and_a_program_reads_what_is_missing(capsys) -> None:
    assert main([]) == 2
    assert "Commands:" in capsys.readouterr().err
    assert main(["calibrate", "--json"]) == 2
    assert main(["--json"]) == 2


@pytest.mark.parametrize(
    ("arguments", "command"),
    [
        (["nonsense"], "measureapp"),
        (["calibrate", "nonsense"], "measureapp calibrate"),
        (["calibrate", "axis", "--nope"], "measureapp calibrate axis"),
        (["measure", "cloud.ply", "program.toml", "--align", "none"], "measureapp measure"),
        (["plan", "make"], "measureapp plan make"),
    ],
)
def test_a_usage_error_names_the_help_of_its_command(arguments: list[str], command: str, capsys) -> None:
    assert main(arguments) == 2
    assert capsys.readouterr().err.rstrip().endswith(f"See `{command} --help`.")
