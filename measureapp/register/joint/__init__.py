"""Joint registration of all views: pose graph, loop closure, innovation test, and error models."""
