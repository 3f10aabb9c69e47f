"""One workspace each."""
