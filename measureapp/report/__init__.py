"""Report documents: one model, and its writers."""
