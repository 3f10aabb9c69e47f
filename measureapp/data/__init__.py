"""Value types exchanged between the stages: immutable, with read-only arrays, without algorithms."""
