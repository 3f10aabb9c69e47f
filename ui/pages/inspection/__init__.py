"""The Inspection page and its parts."""
