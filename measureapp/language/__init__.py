"""Translations of texts, for the window and for documents: catalogues, translators, and which languages there are."""
