"""Page Rig: the devices of the cell, their state, moving by hand, live images, and the demo."""
