"""The images of a session as the pages show them: the newest of each camera, small ones of all, and some in full."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QImage

from ui.controllers.collecting_nouns import LiveImage
from ui.workers.mailbox import Mailboxes

if TYPE_CHECKING:
    from measureapp.calibration_session.session import CalibrationSession
    from ui.controllers.collecting_work import Added

IMAGES_KEPT = 9  # in memory, of those shown last


class CollectedImages:
    """Thumbnails by (observation, camera), and full images as long as they are shown."""

    def __init__(self, thumbnails: Mapping[tuple[str, str], QImage] | None = None) -> None:
        self.live: Mailboxes[LiveImage] = Mailboxes()
        self.thumbnails = dict(thumbnails or {})
        self._newest: dict[str, LiveImage] = {}
        self._full: OrderedDict[tuple[str, str], np.ndarray] = OrderedDict()

    def take_live(self) -> bool:
        """Fetch the newest images from their mailbox; returns whether there were any."""
        found = self.live.take_all()
        self._newest.update(found)
        return bool(found)

    def newest(self, camera: str) -> LiveImage | None:
        """Return the newest image of a camera while its board is still being detected."""
        return self._newest.get(camera)

    def add(self, event: Added) -> None:
        """Take over the images of a view; what was the newest image is now looked at as part of it."""
        for camera, picture in event.thumbnails.items():
            self.thumbnails[event.id, camera] = picture
            self._remember(event.id, camera, event.images[camera])
            newest = self._newest.get(camera)
            if newest is not None and newest.view == event.name:
                del self._newest[camera]

    def forget_newest(self) -> None:
        """Forget the newest images."""
        self._newest.clear()

    def full(self, session: CalibrationSession, id_: str, camera: str) -> np.ndarray | None:
        """Return the image of one camera in a view, or None where it has none. Raises InputError where it cannot be read."""
        if (id_, camera) not in self._full:
            stored = session.observation(id_).images.get(camera)
            if stored is None:
                return None
            self._remember(id_, camera, stored.pixels())
        return self._full.get((id_, camera))

    def _remember(self, id_: str, camera: str, pixels: np.ndarray) -> None:
        self._full[id_, camera] = pixels
        while len(self._full) > IMAGES_KEPT:
            self._full.popitem(last=False)
