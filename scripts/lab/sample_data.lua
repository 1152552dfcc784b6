-- The recipe of share/data/synthetic-blend: what a laboratory would have measured on the cloth of the card `blend`. Made by this
-- program, not measured; every file says so in its first line.
--
--   fabricsh scripts/lab/sample_data.lua [out]
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units

local place = arg[0]:match "^(.*)scripts/" or ""
local out = arg[1] or "out/synthetic-blend"
local label = "# synthetic: made by scripts/lab/sample_data.lua from share/cards/blend.lua, not measured\n"
local compliance, slip = 2e-7, 1e-6
if fabric.checking() then return end

local files = {}
local function write(name, lines) files[name] = label .. table.concat(lines, "\n") .. "\n" end

-- The warp as a frame set to German writes it, the weft in inches and pounds-force.
local dialects = {
  warp = { "Zeit (s);Weg (mm);Kraft (N)", "%.2f;%.5f;%.4f", 1 / u.mm, 1, function(s) return (s:gsub("%.", ",")) end },
  weft = { "time (s),extension (in),load (lbf)", "%.2f,%.7f,%.5f", 1 / u.inch, 1 / 4.4482216152605, function(s) return s end },
  bias = { "frame\tdisplacement (mm)\tforce (N)", "%d\t%.5f\t%.4f", 1 / u.mm, 1, function(s) return s end },
}

local function record(name, direction, r, step)
  local d = dialects[direction]
  local lines = { d[1] }
  for i = 1, #r.force do lines[#lines + 1] = d[5](d[2]:format(i * step, r.displacement[i] * d[3], r.force[i] * d[4])) end
  write(name, lines)
end

local function markers(name, grid)
  local lines, n = { "frame,marker,x (mm),y (mm)" }, grid.rows * grid.columns
  for i = 1, #grid.x do lines[#lines + 1] = ("%d,%d,%.4f,%.4f"):format((i - 1) // n + 1, (i - 1) % n + 1, grid.x[i] / u.mm, grid.y[i] / u.mm) end
  write(name, lines)
end

for i, direction in ipairs { "warp", "weft", "bias" } do
  local bias = direction == "bias"
  local made = lab.synthetic { card = fabric.card "blend", direction = direction, specimens = 5, seed = 2010 + i, rows = 120, markers = { 4, 3 },
    photographs = bias and 90 or 25, compliance = compliance, slip = slip }
  for k, s in ipairs(made) do
    local stem = direction .. "-" .. k
    if bias then record(stem .. "-frames.csv", direction, s.photographs, 1) else record(stem .. ".csv", direction, s.record, 0.5) end
    markers(stem .. "-markers.csv", s.photographs.markers)
  end
end
files["laboratory.lua"] = [[
-- synthetic: made by scripts/lab/sample_data.lua from share/cards/blend.lua, not measured
return {
  name = "synthetic blend", source = "synthetic sample data (scripts/lab/sample_data.lua)",
  gauge_length = 76.2e-3, width = 25.4e-3, thickness = 0.38e-3, plies = 2, -- a sewn loop on two pins
  mass_per_area = 0.2242, markers = { 4, 3 }, compliance = 2e-7, slip = 1e-6, shared = 0.005,
}
]]

-- The files are written, and must be those that the program ships, byte for byte.
local rows, names = {}, {}
for name in pairs(files) do names[#names + 1] = name end
table.sort(names)
fabric.card "blend":write(out .. "/reference.lua")
for _, name in ipairs(names) do
  local f <close> = assert(io.open(out .. "/" .. name, "w"))
  f:write(files[name])
  local shipped <close> = io.open(place .. "share/data/synthetic-blend/" .. name)
  rows[#rows + 1] = { name, shipped and shipped:read "a" == files[name] and 1 or 0, 1, absolute = 0 }
end
fabric.expect(rows)
