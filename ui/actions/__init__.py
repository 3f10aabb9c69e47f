"""Everything a user can ask the window to do: one list for menus, command palette, shortcuts and tests."""
