-- scripts/lab/real/drape.lua with three discs and eight elements over the overhang.
-- warns: in two halves they end
arg[0] = arg[0]:gsub("long/lab_real_", "lab/real/")
arg[1], arg[2], arg[3] = "3", "8", "out/drape_real"
dofile(arg[0])
