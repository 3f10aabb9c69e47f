"""The calibrated projector as an inverse camera: with a single camera, or filling what only one camera sees."""
