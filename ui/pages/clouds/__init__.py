"""The Clouds page and what stands on it."""
