"""Repeated inspection of the same points: only what a changed program affects is measured again."""
