"""Displays and value editors, independent of hardware."""
