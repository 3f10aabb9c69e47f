"""A session on disk: settings, observations and images, each written once; and the list of actions, rewritten after every change.

session.json         kind, board, what was known before, and the actions with how many of them are in effect (the rest can be redone)
cameras.json         the cameras, where they were known
observations/ID.json what was found in the images, with the read-back
images/HASH.png      the pixels, named by their checksum
lit/HASH.npz         of the board under fringes: which pixel of the projector lights each pixel of a camera
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal

import cv2
import numpy as np
from pydantic import TypeAdapter

from measureapp.arrays import ImageArray
from measureapp.calibrate.cameras.projector_sightings import ProjectorPixels
from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.kinds.table import find_kind
from measureapp.calibrate.sightings import Sighting
from measureapp.calibration_session.observation import CollectedObservation, Refusal, StoredImage, StoredPixels
from measureapp.data.board import AnyBoard
from measureapp.data.fringe import Readback
from measureapp.errors import FrameMismatch, InputError, StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.atomic import remove, replacing, write_json
from measureapp.project.calibration.camera_file import read_cameras, write_cameras
from measureapp.project.calibration.projector_pixels import checksum_of, write_projector_pixels
from measureapp.project.documents import hand_eye_from, link_document, noise_document, noise_from, transform_document, transform_from
from measureapp.project.frame_store import checksum

SESSION_VERSION, OBSERVATION_VERSION = 3, 2
SESSION, CAMERAS = "session.json", "cameras.json"
BOARD: TypeAdapter[Any] = TypeAdapter(AnyBoard)
Act = Literal["add", "remove"]


@dataclass(frozen=True, slots=True)
class Action:
    """One change of the session."""

    act: Act
    observation: str


class Store:
    """The folder of one session."""

    def __init__(self, folder: Path) -> None:
        self.folder = Path(folder)

    def exists(self) -> bool:
        """Whether there is a session here."""
        return (self.folder / SESSION).is_file()

    def discard(self) -> None:
        """Delete the session with its folder. Raises StorageError."""
        remove(*(path for path in self.folder.rglob("*") if path.is_file()))
        try:
            shutil.rmtree(self.folder)
        except OSError as error:
            raise StorageError(f"{self.folder} cannot be removed: {error.strerror or error}.", "Check the permissions.") from error

    def keep_image(self, pixels: ImageArray, name: str) -> StoredImage:
        """Write an image unless the same is there already. Raises StorageError."""
        digest = checksum(np.asarray(pixels))
        path = self.folder / "images" / f"{digest}.png"
        if not path.exists():
            encoded, data = cv2.imencode(".png", np.asarray(pixels))
            if not encoded:
                raise StorageError(f"An image ({name or 'from a camera'}) cannot be encoded.", "Take it again.")
            with replacing(path) as temporary:
                temporary.write_bytes(data.tobytes())
        return StoredImage(path, digest, (pixels.shape[1], pixels.shape[0]), name)

    def keep_lit(self, camera: str, lit: ProjectorPixels) -> StoredPixels:
        """Save the projector pixels from which its marks are read. Raises StorageError."""
        digest = checksum_of(lit)
        path = self.folder / "lit" / f"{digest}.npz"
        write_projector_pixels(path, lit)
        return StoredPixels(path, digest, camera)

    def keep_observation(self, observation: CollectedObservation) -> None:
        """Save the sightings of an observation."""
        write_json(self.folder / "observations" / f"{observation.id}.json", _observation_document(observation))

    def keep_setup(self, setup: Setup) -> None:
        """Write the cameras known beforehand; the rest of the settings is part of the session."""
        if setup.cameras is not None:
            write_cameras(self.folder / CAMERAS, setup.cameras)

    def keep_session(self, setup: Setup, actions: Sequence[Action], done: int) -> None:
        """Save the settings and actions."""
        document = {
            "schema_version": SESSION_VERSION,
            **_setup_document(setup),
            "actions": [{"act": action.act, "observation": action.observation} for action in actions],
            "done": done,
        }
        write_json(self.folder / SESSION, document)

    def read(self) -> tuple[Setup, list[Action], int, dict[str, CollectedObservation]]:
        """Return settings, actions, how many of them are in effect, and the observations by id.

        Raises
        ------
        InputError
            There is no session here.
        StorageError
            It is damaged; the message names the file.
        """
        if not self.exists():
            raise InputError(f"{self.folder} holds no calibration session.", "Start one by naming the kind, the board and images.")
        document = _read(self.folder / SESSION)
        try:
            document = migrate(document)
            setup = _setup_from(document, self.folder)
            actions = [Action(entry["act"], str(entry["observation"])) for entry in document["actions"]]
            done = int(document["done"])
            if not 0 <= done <= len(actions) or any(action.act not in ("add", "remove") for action in actions):
                raise ValueError("the list of actions is inconsistent")
        except (KeyError, TypeError, ValueError, FrameMismatch) as error:
            raise StorageError(f"{self.folder / SESSION} cannot be used: {error}.", "Restore it from a backup, or start again.") from error
        names = dict.fromkeys(action.observation for action in actions)
        return setup, actions, done, {name: self._observation(name) for name in names}

    def _observation(self, name: str) -> CollectedObservation:
        path = self.folder / "observations" / f"{name}.json"
        document = _read(path)
        try:
            return _observation_from(document, self.folder)
        except (KeyError, TypeError, ValueError, FrameMismatch) as error:
            raise StorageError(f"{path} cannot be used: {error}.", "Restore it from a backup, or start again.") from error


def _read(path: Path) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Restore it from a backup, or start again.") from error


def migrate(document: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return a session's document in the present form.

    Version 1 kept the hand-eye transform without its standard deviations, version 2 knew no projector.

    Raises
    ------
    ValueError
        A version that is not known.
    """
    version = document["schema_version"]
    if version == 1:
        known = document["flange_from_camera"]
        link = None if known is None else {"flange_from_camera": known}
        return migrate({**document, "schema_version": 2, "hand_eye": link})
    if version == 2:
        return {**document, "schema_version": SESSION_VERSION, "projector_px": None}
    if version != SESSION_VERSION:
        raise ValueError(f"schema_version is {version!r}, not {SESSION_VERSION}")
    return document


def _setup_document(setup: Setup) -> dict[str, Any]:
    return {
        "kind": setup.kind.name,
        "board": setup.board.model_dump(mode="json") | {"kind": getattr(setup.board, "kind", "checkerboard")},
        "camera_names": list(setup.camera_names),
        "cameras_known": setup.cameras is not None,
        "hand_eye": None if setup.hand_eye is None else link_document(setup.hand_eye),
        "noise": noise_document(setup.noise),
        "distortion_count": setup.distortion_count,
        "standoff_mm": setup.standoff_mm,
        "length_mm": setup.length_mm,
        "serials": dict(setup.serials),
        "projector_px": setup.projector_px,
    }


def _setup_from(document: Mapping[str, Any], folder: Path) -> Setup:
    known, size_px = document["hand_eye"], document["projector_px"]
    return Setup(
        kind=find_kind(document["kind"]),
        board=BOARD.validate_python(document["board"]),
        camera_names=tuple(document["camera_names"]),
        cameras=read_cameras(folder / CAMERAS) if document["cameras_known"] else None,
        hand_eye=None if known is None else hand_eye_from(known),
        noise=noise_from(document["noise"]),
        distortion_count=int(document["distortion_count"]),
        standoff_mm=document["standoff_mm"],
        length_mm=float(document["length_mm"]),
        serials=dict(document["serials"]),
        projector_px=None if size_px is None else (int(size_px[0]), int(size_px[1])),
    )


def _observation_document(observation: CollectedObservation) -> dict[str, Any]:
    readback = observation.readback
    pose: RigidTransform | None = readback.base_from_flange
    return {
        "schema_version": OBSERVATION_VERSION,
        "id": observation.id,
        "images": {
            camera: {"checksum": image.checksum, "size_px": list(image.size_px), "name": image.name}
            for camera, image in observation.images.items()
        },
        "readback": {
            "base_from_flange": None if pose is None else transform_document(pose),
            "guide_mm": readback.guide_mm,
            "table_rad": readback.table_rad,
        },
        "seen": {
            camera: {
                "ids": found.ids.tolist(),
                "corners_px": found.corners_px.tolist(),
                "sigma_px": None if found.sigma_px is None else found.sigma_px.tolist(),
                "edge_px": found.edge_px,
            }
            for camera, found in observation.seen.items()
        },
        "refused": {camera: asdict(refusal) for camera, refusal in observation.refused.items()},
        "temperature_c": observation.temperature_c,
        "lit": None if observation.lit is None else {"camera": observation.lit.camera, "checksum": observation.lit.checksum},
    }


def _observation_from(document: Mapping[str, Any], folder: Path) -> CollectedObservation:
    readback, lit = document["readback"], document.get("lit")  # version 1 kept neither the temperature nor anything of the fringes
    pose = readback["base_from_flange"]
    return CollectedObservation(
        id=str(document["id"]),
        images={
            camera: StoredImage(
                folder / "images" / f"{entry['checksum']}.png",
                str(entry["checksum"]),
                (int(entry["size_px"][0]), int(entry["size_px"][1])),
                str(entry["name"]),
            )
            for camera, entry in document["images"].items()
        },
        readback=Readback(None if pose is None else transform_from(pose), readback["guide_mm"], readback["table_rad"]),
        seen={camera: _sighting_from(entry) for camera, entry in document["seen"].items()},
        refused={camera: Refusal(**entry) for camera, entry in document["refused"].items()},
        temperature_c=document.get("temperature_c"),
        lit=None if lit is None else StoredPixels(folder / "lit" / f"{lit['checksum']}.npz", str(lit["checksum"]), str(lit["camera"])),
    )


def _sighting_from(entry: Mapping[str, Any]) -> Sighting:
    corners = np.array(entry["corners_px"], float).reshape(-1, 2)
    if not np.all(np.isfinite(corners)):
        raise ValueError("marks that are not numbers")
    return Sighting("", "", corners, np.array(entry["ids"], np.int64), np.array(entry["sigma_px"], float), float(entry["edge_px"]))
