"""Drawing of all controls in the colours of the theme, without a style sheet."""
