"""What the projector shows, what it makes of it, and what a set of patterns promises."""
