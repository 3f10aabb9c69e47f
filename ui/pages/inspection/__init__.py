"""The Inspection page and what stands on it."""
