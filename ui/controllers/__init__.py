"""One slot per user action; no widgets."""
