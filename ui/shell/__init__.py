"""The nouns of the main window: its commands, the project menu, the state in the header, what is dropped on it."""
