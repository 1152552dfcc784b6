-- Every card, own bending or estimated, under seven loads, on three meshes and with three steps each, beside relaxation and slow implicit motion: the largest
-- displacement normal to the sheet. One row must hold one number; a run may end with an error instead, and says so.
--
--   fabricsh scripts/long/verify/statics.lua [cards [elements [ways]]]
--     cards     names with blanks between, usually all
--     elements  along a side, usually "4 8 16"
--     ways      usually "0.25 0.05 0.01 relaxation"; "motion" is slow implicit motion
-- warns: guard.shear
-- warns: the card extrapolates
-- warns: nine measured cloths in ten have
-- warns: no tested strain is stated
local fabric = require "fabric"
local mm, g, side = fabric.units.mm, 9.80665, 0.2

local loads = {
  { "pressure 20 Pa, clamped", function(m) m:fix("boundary", "x y z rotation"):pressure(fabric.ramp(20, 1)) end },
  { "pressure 20 Pa, held at the corners", function(m) m:fix("corners", "x y z"):pressure(fabric.ramp(20, 1)) end },
  { "2 N in the middle, clamped", function(m) m:fix("boundary", "x y z rotation"):force("middle", { z = fabric.ramp(2, 1) }) end },
  { "weight, clamped", function(m) m:fix("boundary", "x y z rotation"):gravity { 0, 0, fabric.ramp(-g, 1) } end },
  { "weight, held at two edges", function(m) m:fix("left", "x y z"):fix("right", "x y z"):gravity { 0, 0, fabric.ramp(-g, 1) } end },
  { "weight, held at one edge", function(m) m:fix("left", "x y z rotation"):gravity { 0, 0, fabric.ramp(-g, 1) } end },
  { "poked by 20 mm", function(m) m:fix("boundary", "x y z"):move("middle", { z = fabric.ramp(20 * mm, 1) }) end, force = true },
}

local function words(text)
  local list = {}
  for word in text:gmatch "%S+" do list[#list + 1] = word end
  return list
end
local cards = words(arg[1] or table.concat(fabric.cards(), " "))
local sizes, ways = words(arg[2] or "4 8 16"), words(arg[3] or "0.25 0.05 0.01 relaxation")
if fabric.checking() then sizes, ways = { sizes[1] }, { ways[1] } end -- the checks are the same for all of them

-- With the bending that was measured, or else estimated.
local function soft(name)
  local card = fabric.card(name)
  return card.bending and card or fabric.card(name, { bending = "estimated" })
end

-- The largest deflection, mm; of a poke, whose deflection is given, the force, N.
local function reading(a, load)
  if load.force then return (select(3, a:reaction "middle")) end
  local most = 0
  for _, z in ipairs(a:field "uz") do most = math.abs(z) > math.abs(most) and z or most end
  return most / mm
end

local function run(card, n, load, way)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n }
  mesh:set("middle", function(x, y) return math.abs(x - side / 2) < 1e-6 and math.abs(y - side / 2) < 1e-6 end)
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  load[2](m)
  local a
  if way == "motion" then
    a = fabric.dynamic { model = m, duration = 2, scheme = "implicit", step = 5e-3, damping = { mass = 30 } }
  else
    a = fabric.static { model = m, duration = 1, step = tonumber(way) or 0.1, method = tonumber(way) == nil and way or nil }
  end
  local done, trouble = pcall(a.solve, a)
  return done and reading(a, load), trouble
end

print("card       load                                  elements  " .. table.concat(ways, "  ") .. "   spread/%")
local worst, ended, rows, runs = 0, 0, 0, 0
for _, name in ipairs(cards) do
  for _, load in ipairs(loads) do
    for _, n in ipairs(sizes) do
      local row, least, most = {}, math.huge, -math.huge
      for i, way in ipairs(ways) do
        runs = runs + 1
        local value = run(soft(name), tonumber(n), load, way)
        row[i] = value and ("%10.4f"):format(value) or "     ended"
        if value then least, most = math.min(least, value), math.max(most, value) end
        if not value then ended = ended + 1 end
      end
      local spread = 100 * (most - least) / math.max(math.abs(least), math.abs(most))
      print(("%-10s %-36s %5s %s %8.3f"):format(name, load[1], n, table.concat(row, " "), spread))
      if spread > worst then worst = spread end
      if spread > 1 then rows = rows + 1 end
    end
  end
end
print(("%d rows spread by more than 1 %%, the worst by %.3f %%; %d of %d runs ended with an error"):format(rows, worst, ended, runs))
fabric.expect {
  { "rows that spread by more than 1 %", rows, 0, absolute = 0 },
  { "share of runs that ended with an error", ended / runs, 0, absolute = 0.005 },
}
