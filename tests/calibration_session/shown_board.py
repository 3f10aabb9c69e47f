"""Feeding a collection with marks that are known: images stand for them, and the search for the board looks them up."""

from __future__ import annotations

import itertools

import numpy as np

from measureapp.calibrate.sightings import BoardDetectionError, Sighting
from measureapp.calibration_session import detection

SIGMA_PX = 0.05  # stated noise of the marks


class Shown:
    """Adds observations to collections from marks instead of images."""

    def __init__(self, monkeypatch, sigma_px=SIGMA_PX):
        self._marks, self._numbers, self._sigma_px = {}, itertools.count(1), sigma_px
        monkeypatch.setattr(detection, "find_board", self._found)

    def add(self, collection, corners, readback=None, size=(1296, 972)):
        """Add marks by camera: (N, 2) of the whole board, (ids, pixels) of a part, or a cause for which the image is refused."""
        images = {}
        for camera, marks in corners.items():
            number = next(self._numbers)
            self._marks[number] = marks
            images[camera] = np.zeros(size[::-1], np.uint16)
            images[camera][0, 0] = number
        return collection.add(images, readback)

    def _found(self, image, board):
        marks = self._marks[int(image[0, 0])]
        if isinstance(marks, str):
            raise BoardDetectionError(f"The board is {marks}.", "Take it again.", marks)
        ids, pixels = marks if isinstance(marks, tuple) else (np.arange(board.count), marks)
        return Sighting("", "", pixels, ids, np.full(len(pixels), self._sigma_px), 2.5)
