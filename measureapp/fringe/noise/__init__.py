"""The noise of cameras, from flat images or from the fringes themselves."""
