-- One run that lands on a time, and two of which the second goes on from the first with nothing changed: the same bits.
-- warns: at full value at time 0
local fabric = require "fabric"
local rows = {}

local function strip(triangles, flat)
  local mesh = fabric.mesh.rectangle { width = 0.12, height = 0.03, nx = 5, ny = 2, triangles = triangles }
  if flat then
    local card = fabric.svk { density = 500, thickness = 0.4e-3, warp = 6e6, weft = 4e6, shear = 2e6, poisson = 0.1 }
    local m = fabric.model { mesh = mesh, card = card, warp = 20, membrane = true, prestress = { warp = 40, weft = 15 } }
    return m:fix("left", "x y z"):fix("right", "x y z"):gravity { 0, 0, -9.81 }
  end
  local m = fabric.model { mesh = mesh, card = fabric.card("denim", { bending = "estimated" }), warp = 0 }
  return m:fix("left", "x y z rotation"):force("right", { z = fabric.ramp(2e-3, 1e-3) }):gravity { 0, 0, fabric.ramp(-9.81, 1e-3) }
end

local function numbers(a)
  local all = { a.energy.stored, a.energy.kinetic, a.time }
  for i = 1, #a.model.mesh.nodes do
    local p = a:node(i)
    for _, k in ipairs { "x", "y", "z", "nx", "ny", "nz", "vx", "vy", "vz" } do all[#all + 1] = p[k] or 0 end
  end
  return all
end

local function compare(name, run, options, flat)
  for _, triangles in ipairs { false, true } do
    local function with(more)
      for k, v in pairs(options) do more[k] = more[k] or v end
      return run(more)
    end
    local one = with { model = strip(triangles, flat), duration = 2 * options.duration }
    one:advance(options.duration)
    one:solve()
    local first = with { model = strip(triangles, flat) }:solve()
    local a, b = numbers(one), numbers(with { from = first }:solve())
    local same = 0
    for i = 1, #a do same = same + (a[i] == b[i] and 1 or 0) end
    rows[#rows + 1] = { name .. (triangles and ", triangles" or ""), same, #a, absolute = 0 }
  end
end
compare("statics", fabric.static, { duration = 1, step = 0.25 })
compare("statics of a membrane", fabric.static, { duration = 1, step = 0.5 }, true)
compare("explicit, a given step", fabric.dynamic, { duration = 2e-3, step = 6e-6 })
compare("explicit", fabric.dynamic, { duration = 2e-3 })
compare("explicit, a membrane", fabric.dynamic, { duration = 2e-3, step = 2e-5 }, true)
fabric.expect(rows)
