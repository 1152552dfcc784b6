return require"fabric".svk{ density=500, thickness=0.001, warp=1e7, weft=2e7, shear=1e6, poisson={0.3, 0.6}, transverse={2e5, 1e5} }
