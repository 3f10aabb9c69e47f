"""The calibrated projector as one more eye: alone with a camera, or filling what only one camera sees."""
