-- scripts/lab/round_trip.lua a hundred times.
-- warns: was the specimen slack, or gripped late?
-- warns: is unlike the others
arg[0] = arg[0]:gsub("long/lab_", "lab/")
arg[1], arg[2] = "100", "6"
dofile(arg[0])
