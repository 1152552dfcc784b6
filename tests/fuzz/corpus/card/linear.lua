return require"fabric".linear{ density=500, thickness=0.001, warp=2e6, weft=1e6, shear=5e5, poisson={0.2, 0.1} }
