-- scripts/lab/two_corners.lua on three meshes.
-- warns: locks where yarns are pulled
arg[0] = arg[0]:gsub("long/lab_", "lab/")
arg[1], arg[2] = "8 16 32", "3"
dofile(arg[0])
