"""Collisions of head, arm, guide, table, part and fixtures, at viewpoints and along the moves between them."""
