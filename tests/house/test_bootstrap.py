"""The set-up: refuses in words, installs or names what is missing, repairs what is broken."""

from __future__ import annotations

import ast
import importlib
import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

INSTALLER = Path(__file__).resolve().parents[2] / "installer"
MODULES = ("bootstrap", "steps", "environment", "machine", "proofs", "system_libraries", "probe", "trouble")


@pytest.fixture
def installer(monkeypatch: pytest.MonkeyPatch) -> Iterator[SimpleNamespace]:
    monkeypatch.syspath_prepend(str(INSTALLER))
    yield SimpleNamespace(**{name: importlib.import_module(name) for name in MODULES})
    for name in MODULES:
        sys.modules.pop(name, None)


# ---- the first words


def test_old_pythons_can_read_the_first_file() -> None:
    tree = ast.parse((INSTALLER / "bootstrap.py").read_text(encoding="utf-8"), feature_version=(3, 4))
    newer = (ast.JoinedStr, ast.AnnAssign, ast.NamedExpr, ast.AsyncFunctionDef)
    assert not [node for node in ast.walk(tree) if isinstance(node, newer) or getattr(node, "returns", None)]


@pytest.mark.parametrize("version", [(2, 7, 18), (3, 10, 1), (3, 14, 0)])
def test_a_python_that_does_not_fit_is_refused_in_words(installer, monkeypatch, capsys, version) -> None:
    monkeypatch.setattr(installer.bootstrap.sys, "version_info", version)
    assert installer.bootstrap.main(["run"]) == 2
    assert "needs Python 3.11, 3.12 or 3.13" in capsys.readouterr().err


def test_help_and_unknown_commands_set_nothing_up(installer, capsys) -> None:
    assert installer.bootstrap.main(["--help"]) == 0
    assert "bootstrap.py test" in capsys.readouterr().out
    assert installer.bootstrap.main(["instal"]) == 2
    assert "no command 'instal'" in capsys.readouterr().err


# ---- system libraries


def test_nothing_is_missing_where_every_library_loads(installer) -> None:
    assert installer.system_libraries.missing_packages(True, loads=lambda name: True, fonts=lambda: True) == []


def test_a_missing_library_is_named_by_its_package(installer) -> None:
    missing = installer.system_libraries.missing_packages
    assert missing(False, loads=lambda name: name != "libEGL.so.1", fonts=lambda: False) == ["libegl1", "fonts-dejavu-core"]
    assert missing(True, loads=lambda name: "xcb-cursor" not in name, fonts=lambda: True) == ["libxcb-cursor0"]
    assert missing(False, loads=lambda name: "xcb-cursor" not in name, fonts=lambda: True) == []


def test_the_driver_of_a_graphics_card_stands_in_for_mesa(installer) -> None:
    assert installer.system_libraries.missing_packages(False, loads=lambda name: "mesa" not in name, fonts=lambda: True) == []


def test_without_root_the_exact_line_is_given(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.system_libraries.shutil, "which", lambda name: "apt-get")
    monkeypatch.setattr(installer.system_libraries.os, "geteuid", lambda: 1000, raising=False)
    with pytest.raises(installer.trouble.SetupTrouble) as caught:
        installer.system_libraries.install(["libegl1", "libgl1"])
    assert "\n    sudo apt-get install -y --no-install-recommends libegl1 libgl1\n" in caught.value.remedy


@pytest.mark.parametrize("works", [True, False])
def test_root_updates_once_and_installs_without_questions(installer, monkeypatch, works) -> None:
    calls = []

    def run(command, env, **_):
        calls.append((command, env["DEBIAN_FRONTEND"]))
        return subprocess.CompletedProcess(command, 0 if works else 100)

    monkeypatch.setattr(installer.system_libraries.shutil, "which", lambda name: "apt-get")
    monkeypatch.setattr(installer.system_libraries.os, "geteuid", lambda: 0, raising=False)
    monkeypatch.setattr(installer.system_libraries.subprocess, "run", run)
    if works:
        installer.system_libraries.install(["libegl1"])
    else:
        with pytest.raises(installer.trouble.SetupTrouble, match="package lists could not be updated"):
            installer.system_libraries.install(["libegl1"])
    assert [command[:2] + command[-1:] for command, _ in calls] == [["apt-get", "update", "-qq"], ["apt-get", "-qq", "libegl1"]]
    assert {mode for _, mode in calls} == {"noninteractive"}


@pytest.mark.parametrize(("user", "works"), [(0, True), (0, False), (1000, True)])
def test_what_single_tests_need_is_installed_by_root_alone_and_never_stops_the_others(installer, monkeypatch, capsys, user, works) -> None:
    libraries, asked = installer.system_libraries, []

    def install(packages):
        asked.extend(packages)
        if not works:
            raise installer.trouble.SetupTrouble("apt-get could not install system packages.", "")

    monkeypatch.setattr(libraries.shutil, "which", lambda name: "apt-get" if name == "apt-get" else None)
    monkeypatch.setattr(libraries.os, "geteuid", lambda: user, raising=False)
    monkeypatch.setattr(libraries.sys, "platform", "linux")
    monkeypatch.setattr(libraries, "_loads", lambda name: False)
    monkeypatch.setattr(libraries, "install", install)
    libraries.ensure_for_tests()
    assert asked == (["libaravis-0.8-0", "aravis-tools"] if user == 0 else [])
    assert ("skipped" in capsys.readouterr().out) == (not works)


def test_without_apt_the_packages_are_named(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.system_libraries.shutil, "which", lambda name: None)
    with pytest.raises(installer.trouble.SetupTrouble, match="libegl1"):
        installer.system_libraries.install(["libegl1"])


# ---- the environment


class Workshop:
    """The environment module with its slow hands replaced: counts builds and installations."""

    def __init__(self, module: ModuleType, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.module, self.root, self.made, self.installed, self.pip_fails = module, root, 0, 0, 0
        self.inventory, self.problems = ["numpy==2.4"], []
        (root / "requirements.lock").write_text("numpy==2.4\n")
        (root / "pyproject.toml").write_text("[project]\n")
        monkeypatch.setattr(module, "ROOT", root)
        monkeypatch.setattr(module, "LOCK", root / "requirements.lock")
        monkeypatch.setattr(module.subprocess, "run", self._make)
        monkeypatch.setattr(module, "_pip", self._pip)
        monkeypatch.setattr(module, "_check_machine", lambda: None)
        monkeypatch.setattr(module, "_probe", lambda home: {"inventory": self.inventory, "problems": self.problems})

    def _make(self, command, **_):
        self.made += 1
        self.home.script("measureapp").parent.mkdir(parents=True)
        self.home.script("measureapp").touch()
        return subprocess.CompletedProcess(command, 0)

    def _pip(self, home, *arguments):
        if self.pip_fails:
            self.pip_fails -= 1
            raise self.module.SetupTrouble("pip failed", "again")
        self.installed += "--require-hashes" in arguments

    @property
    def home(self):
        return self.module.Environment(self.root / ".venv")

    def done(self) -> tuple[int, int]:
        """Ensure the environment; return how often it was made and the lock file installed."""
        self.made = self.installed = 0
        self.module.ensure()
        return self.made, self.installed


@pytest.fixture
def workshop(installer, tmp_path, monkeypatch) -> Workshop:
    ready = Workshop(installer.environment, tmp_path, monkeypatch)
    assert ready.done() == (1, 1)
    return ready


def test_a_second_start_does_nothing(workshop) -> None:
    assert workshop.done() == (0, 0)


def test_a_changed_lock_or_project_file_is_installed_into_the_same_environment(workshop) -> None:
    for name in ("requirements.lock", "pyproject.toml"):
        (workshop.root / name).write_text("# changed\n")
        assert workshop.done() == (0, 1)
    assert workshop.done() == (0, 0)


def test_an_update_that_fails_builds_anew(workshop) -> None:
    (workshop.root / "requirements.lock").write_text("# changed\n")
    workshop.pip_fails = 1
    assert workshop.done() == (1, 1)


def test_an_interrupted_installation_builds_anew(workshop) -> None:
    (workshop.root / "requirements.lock").write_text("# changed\n")
    workshop.pip_fails = 2
    with pytest.raises(workshop.module.SetupTrouble):
        workshop.done()
    assert workshop.done() == (1, 1)


@pytest.mark.parametrize(
    "harm",
    [
        lambda shop: shop.home.script("measureapp").unlink(),
        lambda shop: shop.home.stamp.unlink(),
        lambda shop: shop.home.stamp.write_text('{"maker": '),
        lambda shop: setattr(shop, "inventory", []),
        lambda shop: shop.home.stamp.write_text(
            json.dumps({**json.loads(shop.home.stamp.read_text()), "maker": {"python": "cpython 3.9", "folder": str(shop.root)}})
        ),
        lambda shop: shop.home.stamp.write_text(
            json.dumps({**json.loads(shop.home.stamp.read_text()), "maker": {**shop.module._maker(), "folder": "elsewhere"}})
        ),
    ],
    ids=["script gone", "half-finished", "stamp torn", "package gone", "other Python", "checkout moved"],
)
def test_a_broken_environment_is_built_anew(workshop, harm) -> None:
    harm(workshop)
    assert workshop.done() == (1, 1)


def test_an_environment_whose_packages_do_not_import_is_built_anew(workshop, monkeypatch) -> None:
    answers = iter([["cv2: broken"], []])
    monkeypatch.setattr(workshop.module, "_probe", lambda home: {"inventory": workshop.inventory, "problems": next(answers)})
    assert workshop.done() == (1, 1)


def test_too_little_space_is_refused_before_anything_is_made(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.environment.shutil, "disk_usage", lambda path: SimpleNamespace(free=1e9))
    with pytest.raises(installer.trouble.SetupTrouble, match=r"Only 1\.0 GB"):
        installer.environment._check_machine()


def test_an_old_linux_is_refused_in_words(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.environment.platform, "libc_ver", lambda: ("glibc", "2.31"))
    monkeypatch.setattr(installer.environment.platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(installer.environment.shutil, "disk_usage", lambda path: SimpleNamespace(free=1e12))
    with pytest.raises(installer.trouble.SetupTrouble, match=r"glibc 2\.31"):
        installer.environment._check_machine()


def test_variables_that_lead_python_elsewhere_are_kept_out(installer, monkeypatch, tmp_path) -> None:
    monkeypatch.setenv("PYTHONPATH", "elsewhere")
    monkeypatch.setenv("PIP_TARGET", "elsewhere")
    variables = installer.environment.Environment(tmp_path).variables()
    assert not {"PYTHONPATH", "PIP_TARGET"} & variables.keys()
    assert variables["PATH"].startswith(str(tmp_path))


def test_a_lost_or_cut_file_of_a_package_is_found(installer, tmp_path) -> None:
    info = tmp_path / "thing-1.0.dist-info"
    info.mkdir()
    (tmp_path / "whole.py").write_text("12345")
    (tmp_path / "cut.py").write_text("123")
    (info / "METADATA").write_text("Name: thing\nVersion: 1.0\n")
    (info / "RECORD").write_text("whole.py,sha256=x,5\ncut.py,sha256=x,5\nlost.py,sha256=x,5\nwhole.pyc,,\nthing-1.0.dist-info/RECORD,,\n")
    (found,) = importlib.metadata.distributions(path=[str(tmp_path)])
    assert [Path(path).name for path in installer.probe.damaged_files(found)] == ["cut.py", "lost.py"]


# ---- the two commands


@pytest.fixture
def called(installer, monkeypatch, tmp_path):
    """Return the commands a step starts; nothing is set up."""
    commands: list[list[str]] = []
    codes: dict[str, int] = {}
    variables: list[dict[str, str]] = []
    started: list[list[str]] = []

    class Started:
        def terminate(self):
            started.append(["terminated"])

        def wait(self):
            pass

    def call(command, home, more=None):
        commands.append([Path(command[0]).stem, *command[1:]])
        variables.append(more or {})
        return codes.get(Path(command[0]).stem, 0)

    monkeypatch.setattr(installer.steps, "_call", call)
    monkeypatch.setattr(installer.system_libraries, "ensure", lambda screen: None)
    monkeypatch.setattr(installer.environment, "ensure", lambda: installer.environment.Environment(tmp_path))
    monkeypatch.setattr(installer.steps.subprocess, "Popen", lambda command, **_rest: started.append(command) or Started())
    return SimpleNamespace(started=started, commands=commands, codes=codes, variables=variables)


def test_run_opens_the_window_on_a_screen_and_runs_the_demo_without(installer, called, monkeypatch) -> None:
    for screen in (True, False):
        monkeypatch.setattr(installer.steps, "has_screen", lambda screen=screen: screen)
        assert installer.steps.perform("run", ["--extra"]) == 0
    assert called.commands == [
        ["measureapp", "gui", "--demo", "--extra"],
        ["measureapp", "demo", "--resolution", "quarter", "--out", str(INSTALLER.parent / "demo-gypsum-quarter"), "--extra"],
    ]


@pytest.mark.parametrize("compiled", [False, True])
def test_the_first_demo_finds_the_kernels_compiled_by_a_process_beside_it(installer, called, monkeypatch, tmp_path, compiled) -> None:
    monkeypatch.setattr(installer.steps, "has_screen", lambda: False)
    monkeypatch.setattr(installer.environment, "ROOT", tmp_path)
    if compiled:
        cache = tmp_path / "measureapp" / "fringe" / "__pycache__"
        cache.mkdir(parents=True)
        (cache / "vote.nbi").touch()
    assert installer.steps.perform("run", []) == 0
    assert [command[-1] for command in called.started] == ([] if compiled else [installer.steps.COMPILE_KERNELS, "terminated"])


def test_a_screen_is_seen_by_its_variables(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.steps.sys, "platform", "linux")
    for name, value in (("DISPLAY", ""), ("WAYLAND_DISPLAY", "")):
        monkeypatch.setenv(name, value)
    assert not installer.steps.has_screen()
    monkeypatch.setenv("WAYLAND_DISPLAY", "wayland-0")
    assert installer.steps.has_screen()


def test_test_runs_every_check_and_returns_the_worst(installer, called, capsys) -> None:
    called.codes.update(mypy=1, python=2)
    assert installer.steps.perform("test", ["-k", "one"]) == 2
    assert [command[0] for command in called.commands] == ["ruff", "ruff", "mypy", "lint-imports", "python"]
    assert called.commands[-1] == ["python", "-m", "pytest", "-k", "one"]
    assert "failed (2)" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("workers", "shared"), [(1, []), (3, ["-n", "3", "--dist", "loadfile", "--no-loadscope-reorder", "-m", "not slow and not timed"])]
)
def test_the_whole_suite_compiles_first_and_runs_in_as_many_processes_as_there_is_room_for(
    installer, called, monkeypatch, capsys, workers, shared
) -> None:
    monkeypatch.setattr(installer.machine, "workers", lambda: workers)
    assert installer.steps.perform("test", []) == 0
    timed = [["python", "-m", "pytest", "-m", "timed and not slow"]] if shared else []
    assert called.commands[-1 - len(timed) :] == [["python", "-m", "pytest", *shared], *timed]
    assert ["python", "-c", installer.steps.COMPILE_KERNELS] in called.commands[:-1]
    assert "kernels       passed" in capsys.readouterr().out


@pytest.mark.parametrize(("processor", "checked"), [("x86_64", True), ("aarch64", False)])
def test_the_whole_suite_tests_kernels_for_an_older_processor_with_a_cache_of_their_own(
    installer, called, monkeypatch, processor, checked
) -> None:
    monkeypatch.setattr(installer.steps.platform, "machine", lambda: processor)
    assert installer.steps.perform("test", []) == 0
    older = [more for command, more in zip(called.commands, called.variables, strict=True) if "tests/compiled" in command]
    assert [more["NUMBA_CPU_NAME"] for more in older] == ["haswell"] * checked
    assert not any(Path(more["NUMBA_CACHE_DIR"]).exists() for more in older)
    assert called.variables[-1] == {}


def test_the_tests_for_an_older_processor_exist(installer) -> None:
    for name in installer.steps.KERNEL_TESTS:
        file, _, test = name.partition("::")
        path = INSTALLER.parent / file
        assert path.exists() and (not test or f"def {test}(" in path.read_text(encoding="utf-8"))


def test_kernels_that_do_not_compile_fail_the_whole_suite(installer, called, capsys) -> None:
    called.codes.update(python=1)
    assert installer.steps.perform("test", []) == 1
    assert "kernels       failed (1)" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("processors", "free_gb", "limit", "workers"),
    [
        (2, 20, "max", 2),
        (16, 100, "max", 4),
        (4, 7, "max", 2),
        (4, 1, "max", 1),
        (1, 20, "max", 1),
        (4, 20, "8000000000", 2),
        (4, None, "max", 4),
    ],
    ids=["two processors", "many", "little memory", "very little memory", "one processor", "a container's limit", "memory unknown"],
)
def test_there_are_as_many_workers_as_processors_and_memory_allow(
    installer, monkeypatch, tmp_path, processors, free_gb, limit, workers
) -> None:
    for name in ("MEMORY", "LIMIT", "USED"):
        monkeypatch.setattr(installer.machine, name, tmp_path / name)
    if free_gb is not None:
        (tmp_path / "MEMORY").write_text(f"MemTotal: 1 kB\nMemAvailable:  {free_gb * 10**9 // 1024} kB\n")
    (tmp_path / "LIMIT").write_text(f"{limit}\n")
    (tmp_path / "USED").write_text("500000000\n")
    monkeypatch.setattr(installer.machine, "processors", lambda: processors)
    assert installer.machine.workers() == workers


def test_trouble_is_reported_in_words_with_exit_code_2(installer, called, monkeypatch, capsys) -> None:
    def trouble(screen):
        raise installer.trouble.SetupTrouble("Libraries are missing.", "Run this line.")

    monkeypatch.setattr(installer.system_libraries, "ensure", trouble)
    assert installer.steps.perform("run", []) == 2
    assert capsys.readouterr().err == "Libraries are missing.\nRun this line.\n"


@pytest.mark.parametrize("absent", ["ensurepip", "venv"])
def test_a_python_that_came_without_venv_gets_the_package_of_its_version(installer, monkeypatch, absent) -> None:
    asked: list[list[str]] = []
    monkeypatch.setattr(installer.environment.importlib.util, "find_spec", lambda name: None if name == absent else object())
    monkeypatch.setattr(installer.environment.system_libraries, "install", asked.append)
    installer.environment._ensure_venv_module()
    assert asked == [[f"python{sys.version_info.major}.{sys.version_info.minor}-venv"]]
