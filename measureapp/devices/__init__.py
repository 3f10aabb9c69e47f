"""Device interfaces, the connected rig, and the plugin loader."""
