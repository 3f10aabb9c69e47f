"""Documents: one model, then writers of it."""
