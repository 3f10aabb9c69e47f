"""One file for each driver: how it is connected to its peer, for the contract tests."""
