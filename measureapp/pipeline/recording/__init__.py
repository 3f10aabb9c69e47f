"""Recordings of other rigs: checked, imported as projects, and processed as far as they go."""
