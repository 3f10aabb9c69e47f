"""A calibration that is collected: a session with its store and undo, detection, recorded images, acceptance.

One writer at a time changes a session; readers take immutable snapshots. Nothing here knows a window or a device: images and read-backs
come in, snapshots go out, and `calibrate` solves and evaluates them.
"""
