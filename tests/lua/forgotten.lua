-- Forgotten inputs are named: a run in which nothing loads or moves, a model that is free in some ways. A flat membrane under pressure is no such model.
-- warns: nothing loads or moves
local fabric = require "fabric"
local mm = fabric.units.mm
local function has(text, part) assert(text:find(part, 1, true), text .. "\nis without: " .. part) end
local card = fabric.card("blend", { bending = "estimated" })
local function sheet()
  local mesh = fabric.mesh.rectangle { width = 40 * mm, height = 60 * mm, nx = 4, ny = 6 }
  return fabric.model { mesh = mesh, card = card, warp = 0 }, mesh
end

local m = sheet()
local a = fabric.static { model = m:fix("bottom", "x y z"):fix("top", "x y z"), duration = 1 }:solve()
assert(#a.warnings == 1 and a.warnings[1].code == "idle", #a.warnings)
has(a.warnings[1].text, "nothing loads or moves the cloth in this run")
m = sheet()
a = fabric.static { model = m:fix("bottom", "x y z rotation"):force("top", { y = fabric.ramp(0, 1) }), duration = 1 }:solve()
assert(#a.warnings == 0) -- a load of zero is somebody's wish

local function free(model)
  local run = fabric.static { model = model, duration = 1 }
  local ok, e = pcall(run.solve, run)
  assert(not ok and e.kind == "numerical", tostring(e))
  return e.why
end
m = sheet()
has(free(m:fix("bottom", "y"):force("top", { y = fabric.ramp(10, 1) })), "move as a whole in 4 ways (along x and z, about x and y)")
m = sheet()
has(free(m:fix("all", "z"):fix("left", "x rotation"):force("right", { x = fabric.ramp(3, 1) })), "along (0, 1, 0)")

-- Shallow, at a small pressure, and deep: by every method the same.
local elastic = fabric.svk { young = 5e7, poisson = 0.25, density = 400, thickness = 0.3 * mm }
for _, pressure in ipairs { 2, 300 } do
  for _, triangles in ipairs { false, true } do
    local heights = {}
    for _, method in ipairs { "auto", "newton", "either", "relaxation" } do
      local mesh = fabric.mesh.rectangle { width = 160 * mm, height = 120 * mm, nx = 8, ny = 6, triangles = triangles }
      m = fabric.model { mesh = mesh, card = elastic, warp = 0, membrane = true }
      m:fix("boundary", "x y z"):pressure(fabric.ramp(pressure, 1))
      local run = fabric.static { model = m, duration = 1, step = 0.25, method = method }:solve()
      assert(run.steps[#run.steps].stable == true)
      local top = 0
      for _, z in ipairs(run:field "uz") do top = math.max(top, z) end
      heights[#heights + 1] = top
    end
    for i = 2, #heights do
      fabric.expect { { ("height at %g Pa, method %d, m"):format(pressure, i), heights[i], heights[1], relative = 1e-5 } }
    end
  end
end

m = sheet()
local ok, e = pcall(m.remove, m, 1)
assert(not ok)
has(e, "remove: expected something declared, the model has nothing in m:list()")
