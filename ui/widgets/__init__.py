"""Displays and value editors that know no hardware."""
