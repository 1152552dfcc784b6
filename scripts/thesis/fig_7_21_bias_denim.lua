-- Fig. 7-21 of [williams2010]: bias test at 45 degrees to 20 mm, denim, ends free and clamped, and what the text's numbers imply.
--
--   fabricsh scripts/thesis/fig_7_21_bias_denim.lua
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
-- warns: INSIDE the tested range
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "bias.lua")("7-21", "denim", "fig_7_21")
