"""The Clouds page and its parts."""
