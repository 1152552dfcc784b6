-- scripts/verify/drape_solvers.lua on three meshes.
arg[0] = arg[0]:gsub("long/verify", "verify")
arg[1] = "28x3 36x4 54x6"
dofile(arg[0])
