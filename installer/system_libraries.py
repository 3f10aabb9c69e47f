"""The system libraries that Qt, VTK and Open3D load: found missing by loading them, installed by apt where that is possible."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

from trouble import SetupTrouble

# library name (alternatives after |) → Debian and Ubuntu package
ALWAYS = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libEGL_mesa.so.0|libEGL_nvidia.so.0": "libegl-mesa0",
    "libGLX_mesa.so.0|libGLX_nvidia.so.0": "libglx-mesa0",
    "libX11.so.6": "libx11-6",
    "libidn2.so.0": "libidn2-0",
    "libudev.so.1": "libudev1",
    "libusb-1.0.so.0": "libusb-1.0-0",
    "libgomp.so.1": "libgomp1",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libdbus-1.so.3": "libdbus-1-3",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libgssapi_krb5.so.2": "libgssapi-krb5-2",
    "libbrotlidec.so.1": "libbrotli1",
    "libzstd.so.1": "libzstd1",
    "libdrm.so.2": "libdrm2",
}
FOR_A_SCREEN = {
    "libX11-xcb.so.1": "libx11-xcb1",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render.so.0": "libxcb-render0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-shm.so.0": "libxcb-shm0",
    "libxcb-sync.so.1": "libxcb-sync1",
    "libxcb-util.so.1": "libxcb-util1",
    "libxcb-xfixes.so.0": "libxcb-xfixes0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libwayland-client.so.0": "libwayland-client0",
    "libwayland-cursor.so.0": "libwayland-cursor0",
}
# library or program that single tests need, which are skipped without → package
FOR_TESTS = {
    "libaravis-0.8.so.0": "libaravis-0.8-0",
    "arv-fake-gv-camera-0.8": "aravis-tools",
}
FONT_PACKAGE = "fonts-dejavu-core"
FONT_FOLDERS = ("/usr/share/fonts", "/usr/local/share/fonts", "~/.fonts", "~/.local/share/fonts")


def ensure(screen: bool) -> None:
    """Install the missing libraries, or raise SetupTrouble with the line that does."""
    if sys.platform.startswith("linux"):
        install(missing_packages(screen))


def ensure_for_tests() -> None:
    """Install what single tests need where that takes no question: as root with apt. Elsewhere these tests are skipped and state why."""
    if not sys.platform.startswith("linux") or shutil.which("apt-get") is None or os.geteuid() != 0:
        return
    try:
        install(package for name, package in FOR_TESTS.items() if not (shutil.which(name) or _loads(name)))
    except SetupTrouble as trouble:
        print(f"{trouble.message} Tests that need them are skipped.", flush=True)


def missing_packages(screen: bool, loads: Callable[[str], bool] | None = None, fonts: Callable[[], bool] | None = None) -> list[str]:
    """Return the packages whose library cannot be loaded; ``loads`` and ``fonts`` stand in for this machine in tests."""
    loads, fonts = loads or _loads, fonts or _has_fonts
    wanted = ALWAYS | (FOR_A_SCREEN if screen else {})
    packages = [package for names, package in wanted.items() if not any(loads(name) for name in names.split("|"))]
    return packages if fonts() else [*packages, FONT_PACKAGE]


def install(packages: Iterable[str]) -> None:
    """Install packages by apt as root; otherwise raise SetupTrouble with the exact line to run."""
    packages = list(packages)
    if not packages:
        return
    if shutil.which("apt-get") is None:
        raise SetupTrouble(
            f"System libraries are missing, which Debian and Ubuntu call: {' '.join(packages)}.",
            "Install the packages of your distribution that hold them, then start again.",
        )
    line = f"apt-get install -y --no-install-recommends {' '.join(packages)}"
    if os.geteuid() != 0:
        raise SetupTrouble(f"System packages are missing: {' '.join(packages)}.", f"Run this line, then start again:\n\n    sudo {line}\n")
    print(f"Installing system packages: {' '.join(packages)}", flush=True)
    variables = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    updated = subprocess.run(["apt-get", "update", "-qq"], env=variables, stdout=sys.stderr, check=False).returncode
    if subprocess.run(["apt-get", "-qq", *line.split()[1:]], env=variables, stdout=sys.stderr, check=False).returncode != 0:
        reason = " (its package lists could not be updated)" if updated else ""
        raise SetupTrouble(f"apt-get could not install system packages{reason}.", f"Run this line, then start again:\n\n    sudo {line}\n")


def _loads(name: str) -> bool:
    try:
        ctypes.CDLL(name)
    except OSError:
        return False
    return True


def _has_fonts() -> bool:
    folders = (Path(folder).expanduser() for folder in FONT_FOLDERS)
    return any(path.suffix.lower() in (".ttf", ".otf", ".ttc") for folder in folders if folder.is_dir() for path in folder.rglob("*.?t?"))
