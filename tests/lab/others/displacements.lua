-- fabricsh displacements.lua <first> <second> <out.csv> <left> <right> <top> <bottom> <search> <subset>: correlates two photographs.
local lab = require "fabric".lab
local region = { left = tonumber(arg[4]), right = tonumber(arg[5]), top = tonumber(arg[6]), bottom = tonumber(arg[7]) }
local t = lab.correlate { files = { arg[1], arg[2] }, region = region, search = tonumber(arg[8]), subset = tonumber(arg[9]) }
local n = t.rows * t.columns
local out = assert(io.open(arg[3], "w"))
out:write "x,y,u,v,E11,E22,E12,deviation\n"
for i = 1, n do
  local x, y, k = t.x[i], t.y[i], n + i
  out:write(("%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n"):format(x, -y, t.x[k] - x, y - t.y[k], t.E11[k], t.E22[k], t.E12[k], t.deviation[k]))
end
out:close()
