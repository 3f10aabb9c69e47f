"""Languages of the window: texts stay English in the code, and are translated where they are displayed."""
