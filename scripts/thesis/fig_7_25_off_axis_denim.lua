-- Fig. 7-25 of [williams2010]: denim, warp at 30 and 60 degrees from the pull; stress as the machine, the average and the middle show it.
--
--   fabricsh scripts/thesis/fig_7_25_off_axis_denim.lua
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "off_axis.lua")("7-25", "denim", "fig_7_25")
