-- Fig. 7-24 of [williams2010]: blend, warp at 30 and 60 degrees from the pull; stress as the machine, the average and the middle show it.
--
--   fabricsh scripts/thesis/fig_7_24_off_axis_blend.lua
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "off_axis.lua")("7-24", "blend", "fig_7_24")
