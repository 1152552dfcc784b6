-- Critical factors of loads that are added to a state: its own stresses and loads are not multiplied.
local fabric = require "fabric"
local pi = math.pi
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end

-- A square plate that is pulled across, and pressed along: N = (pi^2 D (m^2 + 1)^2 / a^2 + N0) / m^2. The pull stays as it is.
do
  local a, D, h = 0.12, 2e-2, 0.8e-3
  local card = fabric.svk { density = 900, thickness = h, warp = 6e8, weft = 6e8, shear = 3e8, poisson = 0,
    bending = { warp = D, weft = D, twist = D / 2 } }
  local pull = 30 -- N/m
  local function N(m) return (pi ^ 2 * D * (m ^ 2 + 1) ^ 2 / a ^ 2 + pull) / m ^ 2 end
  local want = math.min(N(1), N(2), N(3))
  for _, tri in ipairs { false, true } do
    local of = tri and ", triangles" or ", quadrilaterals"
    local mesh = fabric.mesh.rectangle { width = a, height = a, nx = 14, ny = 14, triangles = tri }
    local base = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "z"):fix("left", "x"):fix("bottom", "y")
    base:force("top", { y = fabric.ramp(pull * a, 1) })
    local taut = fabric.static { model = base, duration = 1, step = 0.5 }:solve()
    for _, size in ipairs { 1e-3, 40 } do
      local load = base:copy():force("right", { x = -size * a })
      check(("pulled and pressed, load %g"):format(size) .. of, fabric.buckling { from = taut, load = load }[1].factor * size, want, 0.01)
    end
    -- by a support that moves
    local held = base:copy():move("right", { x = fabric.ramp(0, 1) })
    taut = fabric.static { model = held, duration = 1, step = 0.5 }:solve()
    local step = 1e-5
    local load = base:copy():move("right", { x = -step })
    check("by a support" .. of, fabric.buckling { from = taut, load = load }[1].factor * step * 6e8 * h / a, want, 0.01)
  end
end

-- A ring under a part of its critical pressure: what is left of 3 B / r^3, by a pressure that follows.
do
  local r, width, D = 0.04, 0.01, 2e-3
  local card = fabric.svk { density = 1000, thickness = 1e-3, warp = 5e7, weft = 5e7, shear = 2.5e7, poisson = 0,
    bending = { warp = D, weft = D, twist = D / 2 } }
  local mesh = fabric.mesh.cylinder { radius = r, length = width, around = 64, along = 1 }
  mesh:set("x axis", function(_, y) return math.abs(y) < 1e-9 end)
  mesh:set("y axis", function(x) return math.abs(x) < 1e-9 end)
  local critical = 3 * D / r ^ 3
  for _, part in ipairs { 0, 0.4 } do
    local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
    m:fix("all", "z"):fix("x axis", "y"):fix("y axis", "x"):pressure(fabric.ramp(-part * critical, 1))
    local run = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
    for _, size in ipairs { 1, critical } do
      local load = m:copy():pressure(-size)
      local more = fabric.buckling { from = run, load = load }[1].factor * size
      check(("ring with %g of it, %g more"):format(part, size), more / critical + part, 1, 0.01)
    end
  end
end

-- A column of yarns that unload along another line.
do
  local L, b, B = 0.12, 0.02, 2e-5
  local card = fabric.woven { density = 500, thickness = 0.5e-3, warp = { loading = { 9e6 }, unloading = 9.5e6, poisson = 0 },
    weft = { loading = { 9e6 }, unloading = 9.5e6, poisson = 0 }, shear = { loading = { 6e6 }, unloading = 7e6 },
    tested = { warp = 0.3, weft = 0.3, shear = 0.3 }, bending = { warp = B, weft = B, twist = B / 2 } }
  local euler = pi ^ 2 * B * b / 4 / L ^ 2
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = L, height = b, nx = 16, ny = 2 }, card = card, warp = 0 }
  m:fix("left", "x y z rotation"):force("right", { x = fabric.ramp(0.5 * euler, 1) })
  local run = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  local load = m:copy():force("right", { x = -2 * euler })
  local found = fabric.buckling { from = run, load = load, count = 2 }
  check("column that is pulled", 2 * found[1].factor, 1.5, 0.01)
  check("its second", 2 * found[2].factor, 9.5, 0.015)
end
-- Many cloths that are the same have as many equal factors and frequencies, and none of them is missed.
do
  local nodes, elements, count = {}, {}, 11
  for strip = 1, count do
    local first = #nodes
    for i = 0, 6 do
      nodes[#nodes + 1] = { 0.01 * i, 0.03 * strip, 0 }
      nodes[#nodes + 1] = { 0.01 * i, 0.03 * strip + 0.01, 0 }
      if i > 0 then
        local n = first + 2 * i
        elements[#elements + 1] = { n - 1, n + 1, n + 2, n }
      end
    end
  end
  local mesh = fabric.mesh { nodes = nodes, elements = elements }
  mesh:set("root", function(x) return x < 1e-9 end)
  mesh:set("tip", function(x) return x > 0.06 - 1e-9 end)
  local B = 2e-5
  local card = fabric.svk { density = 500, thickness = 0.5e-3, warp = 9e6, weft = 9e6, shear = 3e6, poisson = 0,
    bending = { warp = B, weft = B, twist = B / 2 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("root", "x y z rotation")
  m:force("tip", { x = fabric.ramp(-count * 1e-5, 1) })
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  for name, found in pairs { frequency = fabric.modes { model = m, count = count + 3 }, factor = fabric.buckling { from = run, count = count + 3 } } do
    local equal = 0
    for _, one in ipairs(found) do
      if math.abs(one[name] / found[1][name] - 1) < 1e-6 then equal = equal + 1 end
    end
    check("equal ones, " .. name, equal, count, 0)
  end
end

fabric.expect(checks)
