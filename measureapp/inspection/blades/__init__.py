"""Blade sections: mean line, chord, thickness, edges, twist and pitch."""
