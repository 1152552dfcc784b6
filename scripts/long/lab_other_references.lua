-- scripts/lab/other_references.lua twenty times.
-- warns: make no card and were drawn again
-- warns: is unlike the others
arg[0] = arg[0]:gsub("long/lab_", "lab/")
arg[1], arg[2] = "20", "24"
dofile(arg[0])
