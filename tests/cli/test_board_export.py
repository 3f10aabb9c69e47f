"""A board is drawn at true scale, as it is described."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import cv2
import numpy as np
import pytest

from measureapp.calibrate.boards.find import find_board
from measureapp.cli import main
from measureapp.cli.calibrate.options import BoardChoice

SVG = "{http://www.w3.org/2000/svg}"
PX_PER_MM = 4.0
OPTIONS = {
    "checkerboard": BoardChoice("9x6", 20.0),
    "charuco": BoardChoice("charuco:9x6", 20.0, marker_mm=15.0, dictionary="4X4_50"),
    "circles": BoardChoice("circles:4x11", 20.0, diameter_mm=18.0),
}


def printed(path):
    """Draw the rectangles and circles of the file at 4 px per mm, and say where its origin lies."""
    root = ElementTree.parse(path).getroot()
    x0, y0, width, height = map(float, root.attrib["viewBox"].split())
    assert root.attrib["width"] == f"{width:g}mm"
    scale = 4 * PX_PER_MM
    image = np.full((round(height * scale), round(width * scale)), 230, np.uint8)
    for shape in root:
        value = {key: float(text) for key, text in shape.attrib.items() if key in ("x", "y", "width", "height", "cx", "cy", "r")}
        if shape.tag == SVG + "rect" and "fill" not in shape.attrib:
            left, top, right, bottom = (
                round(v * scale)
                for v in (value["x"] - x0, value["y"] - y0, value["x"] - x0 + value["width"], value["y"] - y0 + value["height"])
            )
            image[top:bottom, left:right] = 20
        if shape.tag == SVG + "circle":
            centre = ((np.array([value["cx"] - x0, value["cy"] - y0]) * scale - 0.5) * 256).round().astype(int)
            cv2.circle(image, tuple(centre.tolist()), round(value["r"] * scale * 256), 20, -1, cv2.LINE_AA, 8)
    small = cv2.resize(image, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA)
    return cv2.GaussianBlur(small, (0, 0), 0.8), np.array([x0, y0])


@pytest.mark.parametrize("kind", list(OPTIONS))
def test_a_printed_board_is_found_again_at_its_scale(kind, tmp_path, capsys):
    choice, out = OPTIONS[kind], tmp_path / "board.svg"
    arguments = ["--board", choice.board, "--square-mm", choice.square_mm, "--dictionary", choice.dictionary, "--out", out]
    arguments += ["--marker-mm", choice.marker_mm] if choice.marker_mm else []
    arguments += ["--diameter-mm", choice.diameter_mm] if choice.diameter_mm else []
    assert main(["board", "export", *map(str, arguments)]) == 0
    assert "100 mm" in capsys.readouterr().out
    image, origin = printed(out)
    board = choice.description()
    found = find_board(image, board)
    assert len(found.ids) == board.count
    np.testing.assert_allclose(found.corners_px, (board.corners_mm[:, :2] - origin) * PX_PER_MM - 0.5, atol=0.1)


def test_another_kind_of_file_is_refused(tmp_path, capsys):
    assert main(["board", "export", "--board", "9x6", "--square-mm", "20", "--out", str(tmp_path / "board.jpg")]) == 2
    assert "SVG" in capsys.readouterr().err
