"""Files of recorded fringe images, pattern sets, camera noise and projector responses."""
