"""Rigid transforms that know their frames, pinhole cameras, lines and fits of basic shapes."""
