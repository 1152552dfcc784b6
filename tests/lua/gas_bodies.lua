-- Rigid bodies and floors that close volumes of gas: volumes, forces and moments on the bodies, in all schemes.
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local air, radius, long = 101325, 0.05, 0.1
local rows = {}
local function row(name, got, want, within) rows[#rows + 1] = { name, got, want, relative = within.relative, absolute = within.absolute } end
local card = fabric.svk { young = 30e6, poisson = 0, density = 700, thickness = 0.3e-3 }

local function tube(around, along, triangles, map)
  local mesh = fabric.mesh.cylinder { radius = radius, length = long, around = around, along = along }
  if triangles then mesh = check.in_triangles(mesh) end
  if map then mesh = mesh:map(map) end
  return fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, membrane = true }
end
local function section(around) return around / 2 * radius ^ 2 * math.sin(2 * math.pi / around) end
local function floor() return fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 }, name = "floor" } end
local function plate(mass) return fabric.rigid.disc { radius = 0.07, edge = 1e-3, centre = { 0, 0, long + 1e-3 }, normal = { 0, 0, 1 }, name = "plate", mass = mass } end

-- A piston on a tube whose sides only follow it: p V^n is kept, and the piston and the floor bear p A.
for _, n in ipairs { 1, 1.4 } do
  for _, triangles in ipairs { false, true } do
    local m, area = tube(11, 3, triangles), section(11)
    local ground, piston, down = floor(), plate(), fabric.ramp(-0.3 * long, 1)
    m:fix("all", "x y"):fix("bottom", "z"):move("top", { z = down }):move(piston, { z = down })
    local g = m:gas { lids = { ground, piston }, initial = 2000, exponent = n }
    local a = fabric.static { model = m, duration = 1, step = 0.1 }
    row("volume of the tube", select(2, a:gas(g)), area * long, { relative = 1e-12 })
    a:solve()
    local p, V = a:gas(g)
    row("volume when pressed", V, 0.7 * area * long, { relative = 1e-12 })
    row("pressure when pressed", p, (air + 2000) * 0.7 ^ -n - air, { relative = 1e-12 })
    row("force that holds the piston", select(3, a:reaction(piston)), -p * area, { relative = 1e-9 })
    row("force that holds the floor", select(3, a:reaction(ground)), p * area, { relative = 1e-9 })
    row("ledger", a.energy.error, 0, { absolute = 2e-3 })
  end
end

-- Bodies of other shapes, about a tube that nothing moves. The sum of all forces of the gas is zero.
local function held(name, body, map, volume, within, normal, force)
  for _, triangles in ipairs { false, true } do
    local m = tube(24, 4, triangles, map):fix("all", "x y z")
    local ground = floor()
    local g = m:gas { lids = { ground, body }, initial = 3000 }
    local a = fabric.dynamic { model = m, duration = 1e-5, scheme = "implicit" }:solve()
    local p, V = a:gas(g)
    row(name .. ", volume", V, volume, { relative = within })
    local f, sum = { a:reaction(body) }, { 0, 0, 0 }
    for _, of in ipairs { body, ground, "all" } do
      for i, c in ipairs { a:reaction(of) } do sum[i] = sum[i] + c end
    end
    for i = 1, 3 do
      row(name .. ", sum of forces", sum[i], 0, { absolute = 1e-9 })
      row(name .. ", force that holds it", f[i], -p * section(24) * normal[i], { absolute = force or 1e-9 })
    end
  end
end
local area, up = section(24), { 0, 0, 1 }
local function cap(R, h) return math.pi * h ^ 2 * (3 * R - h) / 3 end
local R = 0.06
local sink = math.sqrt(R ^ 2 - radius ^ 2)
held("ball from above", fabric.rigid.sphere { radius = R, centre = { 0, 0, long + sink } }, nil, area * long - cap(R, R - sink), 2e-3, up)
local S = 0.052
local deep = math.sqrt(S ^ 2 - radius ^ 2)
held("ball more than half inside", fabric.rigid.sphere { radius = S, centre = { 0, 0, long - deep } }, nil, area * long - cap(S, S + deep), 2e-2, up)
local half = math.pi * radius ^ 3 * 2 / 3
held("end of a rod", fabric.rigid.cylinder { radius = radius, from = { 0, 0, long }, to = { 0, 0, 2 * long } }, nil, area * long - half, 2e-2, up)
held("rounded disc at its rim", fabric.rigid.disc { radius = radius, edge = 0.01, centre = { 0, 0, long }, normal = { 0, 0, -1 } }, nil,
  area * long - math.pi * 0.01 * (0.04 ^ 2 + math.pi / 2 * 0.04 * 0.01 + 2 / 3 * 0.01 ^ 2), 5e-3, up)
held("oblique floor", fabric.rigid.plane { point = { 0, 0, long }, normal = { -0.3, 0, 1 } },
  function(x, y, z) return x, y, z * (1 + 0.3 * x / long) end, area * long, 1e-12, { -0.3, 0, 1 })
local function bowl(x, y) return x, y, long - 4 * (radius ^ 2 - x ^ 2 - y ^ 2) end
local sheet = fabric.mesh.rectangle { width = 0.12, height = 0.12, nx = 24, ny = 24, origin = { -0.06, -0.06, 0 } }:map(bowl)
held("bowl of facets", fabric.rigid.surface { mesh = sheet }, nil, area * long - 4 * math.pi / 2 * radius ^ 4, 3e-3, up, 0.01)

-- A plate that moves freely and is tied to the rim: the same as a rigid rim under a lid, with its moment, too.
for _, triangles in ipairs { false, true } do
  local function pressed(with_body)
    local m, body, g = tube(12, 3, triangles), plate(), nil
    m:fix("bottom", "x y z")
    local load = { y = fabric.ramp(0.3, 1) }
    if with_body then
      m:tie("rigid", "top", body):force(body, { z = fabric.ramp(60, 1) }):moment(body, load)
      g = m:gas { lids = { floor(), body }, initial = 8e3 }
    else
      m:tie("rigid", "top"):force("top", { z = fabric.ramp(60, 1) }):moment("top", load)
      g = m:gas { lids = { "bottom", "top" }, initial = 8e3 }
    end
    local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
    return a, g, m
  end
  local a, g, m = pressed(true)
  local b, h = pressed(false)
  row("tied plate, pressure", (a:gas(g)), (b:gas(h)), { relative = 2e-3 })
  row("tied plate, volume", (select(2, a:gas(g))), (select(2, b:gas(h))), { relative = 2e-5 })
  for _, n in ipairs { m.mesh:set("top")[1], m.mesh:set("top")[4] } do
    row("tied plate, height", a:node(n).z - long, b:node(n).z - long, { absolute = 2e-6 })
    row("tied plate, aside", a:node(n).x, b:node(n).x, { absolute = 2e-6 })
  end
  row("tied plate, ledger", a.energy.error, 0, { absolute = 5e-3 })
  assert(a.steps[#a.steps].iterations <= 8, a.steps[#a.steps].iterations)
end
fabric.expect(rows)
