"""Images of a small checkerboard, drawn as two small cameras see it."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform

LENS = PinholeCamera(480, 360, np.array([[700.0, 0, 240], [0, 700, 180], [0, 0, 1]]), np.zeros(5))
SMALL_HEAD = CameraArrayCalibration(
    "left",
    {
        "left": CameraCalibration("left", LENS, RigidTransform.identity("camera", "left")),
        "right": CameraCalibration("right", LENS, RigidTransform.from_vector([0, -0.3, 0], [150, 0, 20], "camera", "right")),
    },
)


def drawn_views(folder, head, board, poses):
    """Write images of a board seen at poses; its corner square is black."""
    square = 30
    columns, rows = board[0] + 1, board[1] + 1
    picture = np.full(((rows + 2) * square, (columns + 2) * square), 235, np.uint8)
    for row in range(rows):
        for column in range(columns):
            if (row + column) % 2 == 0:
                picture[(row + 1) * square : (row + 2) * square, (column + 1) * square : (column + 2) * square] = 20
    drawing = np.array([[12 / square, 0, -24 + 6 / square], [0, 12 / square, -24 + 6 / square], [0, 0, 1]])
    for number, pose in enumerate(poses):
        for name, camera in head.cameras.items():
            in_camera = camera.reference_from_camera.inverse().matrix @ pose.matrix
            homography = camera.pinhole.matrix @ in_camera[:3, [0, 1, 3]] @ drawing
            twice = np.array([[2, 0, 0.5], [0, 2, 0.5], [0, 0, 1.0]])
            size = (camera.pinhole.width_px, camera.pinhole.height_px)
            image = cv2.warpPerspective(picture, twice @ homography, (2 * size[0], 2 * size[1]), borderValue=120, flags=cv2.INTER_AREA)
            image = cv2.GaussianBlur(cv2.resize(image, size, interpolation=cv2.INTER_AREA), (0, 0), 0.7)
            cv2.imwrite(str(folder / f"{name}{number}.png"), image)
