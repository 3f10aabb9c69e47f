"""After a scan: what is measured of the nominal, why the rest is not, and which further views would pay."""
