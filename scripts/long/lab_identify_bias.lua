-- scripts/lab/identify_bias.lua on a finer mesh.
arg[0] = arg[0]:gsub("long/lab_", "lab/")
for i, word in ipairs { "", "150", "450", "out/identify-bias-fine", "10" } do arg[i] = word end
dofile(arg[0])
