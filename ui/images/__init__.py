"""Images of numbers: maps of decoded views with values under the cursor, profiles along a line, stored fringe images."""
