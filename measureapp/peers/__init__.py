"""Virtual peers: what drivers talk to where there is no hardware; loopback only, each speaks the real protocol."""
