"""A language of brackets, in which every text that is not translated shows."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import pytest
from made_once import made_once
from without_pictures import without_pictures

from measureapp.language.catalogue import Catalogue, Entry
from tests.ui.look.language.read_sources import ReadSources

NAMES = re.compile(  # of files, devices, views, standards and people stay as they are
    r"demo-gypsum|[Gg]ypsum(-\d+)?|view-\d+|Camera (left|right|upper)|left|right|upper|Basler.*|ABB.*|TOYO.*|DLP.*|Paper rig \(virtual\)\.?|top|equator|Equator"
    r"|RPS|English|No points lie near the feature\.|view\d+|([Ff]ace [xy][+-]|[Aa]rm (side y[+-]|tops)|[Cc]entre top)( \(\))?|sample-gypsum|/.*|Robot [xyz] .*|Turn about .*|Linear guide [−+].*|Rotary table [−+].*|ISO 14253.*|[\d.,\s−…]*(mm|px|GB|bit|lens)\b.*|±.*ppm"
    r"|\d.*|ChArUco|Paper rig \(virtual\),.*|note|rig|Stitch|Recommended\. .*|gypsum.*|(Ctrl|Alt|Shift)\+.*|(DICT|APRILTAG|ARUCO)_.*|.*\.toml|PASS|FAIL",
    re.DOTALL,
)


@pytest.fixture(scope="module", autouse=True)
def _without_pictures() -> Iterator[None]:
    """The preview of a report is made again with every change of the language; its pictures have no text that is displayed."""
    with without_pictures():
        yield


@pytest.fixture(scope="session")
def read_sources(tmp_path_factory: pytest.TempPathFactory) -> ReadSources:
    """What tests need of all sources; to read these takes seconds."""

    def read(folder: Path) -> None:
        (folder / "sources.json").write_text(json.dumps(ReadSources.of_program()._asdict()), encoding="utf-8")

    return ReadSources(**json.loads((made_once(tmp_path_factory, "sources", read) / "sources.json").read_text(encoding="utf-8")))


@pytest.fixture(scope="session")
def all_texts(read_sources: ReadSources) -> dict[str, str]:
    """Every text of the program and its room."""
    return read_sources.texts


@pytest.fixture(scope="session")
def bracketed(all_texts) -> Catalogue:
    """A language in which every text is in brackets, and longer."""
    return Catalogue("zh_CN", {text: Entry(text, f"⟦{text}⟧") for text in all_texts})


@pytest.fixture
def speaking(application, monkeypatch, bracketed):
    """Return a function that changes the language, and waits until everything on display followed."""
    monkeypatch.setattr("ui.look.language.language.catalogue_of", lambda name: None if name == "en" else bracketed)

    def speak(name: str) -> None:
        application.settings.set_text("language", name)
        application.language.retranslation.finish()

    return speak


def texts_left(texts: Iterable[tuple[str, str]]) -> list[str]:
    """Return the texts (kind, text) that are neither in brackets nor names."""
    found = []
    for kind, text in texts:
        bare = re.sub(r"⟦.*⟧|⟦.*…$", "", text, flags=re.DOTALL).strip("\u2009 …:,")
        if re.search(r"[A-Za-z]{3}", bare) and NAMES.fullmatch(bare.strip()) is None:
            found.append(f"{kind} “{text}”")
    return sorted(set(found))


@pytest.fixture
def english_left() -> Callable[[Iterable[tuple[str, str]]], list[str]]:
    """The function that tells what is left in English."""
    return texts_left
