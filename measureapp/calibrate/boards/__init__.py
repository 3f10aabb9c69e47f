"""Boards in images: their marks, which part of the board they are, and the pose of the board."""
