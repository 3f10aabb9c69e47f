"""Checks of the error model by the data: what it does not explain becomes the contribution "unexplained" of every dimension."""
