"""The nouns the stages exchange: frozen, with read-only arrays, without algorithms."""
