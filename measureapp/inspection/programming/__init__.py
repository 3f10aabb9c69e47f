"""Writing inspection programs: edits as pure functions, nominals from the features, proposals for what is selected."""
