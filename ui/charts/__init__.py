"""Charts, drawn by pyqtgraph in the colours and letters of the theme."""
