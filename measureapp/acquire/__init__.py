"""Acquisition: running a scan plan on a rig."""
