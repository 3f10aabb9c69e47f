"""Full-screen patterns on a second screen, in a process of its own that drivers talk to by lines of JSON."""
