-- scripts/lab/simulation_route.lua, ten times each fabric.
-- warns: the card was tested to 0.3
arg[0] = arg[0]:gsub("long/lab_", "lab/")
for i, word in ipairs { "10", "blend", "duck", "muslin", "denim" } do arg[i] = word end
dofile(arg[0])
