"""Points sorted into cells and voxels, and the compiled loops over them."""
