"""Results of many parts measured by one program."""
