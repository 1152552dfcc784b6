-- Folds within elements of sheets that are integrated through the thickness: as with the same rigidity of their own where they are not bent, also as plies,
-- and bent ones keep their bending and their energies.
local fabric = require "fabric"
local MPa, mm = fabric.units.MPa, fabric.units.mm

local function film(thickness, across, own)
  local function yarn(E) return { loading = { E }, unloading = E, poisson = 0 } end
  local E = { 700 * MPa, across * MPa }
  local third = thickness ^ 3 / 12
  return fabric.woven { name = "film", density = 1300, thickness = thickness, warp = yarn(E[1]), weft = yarn(E[2]), shear = { loading = { 300 * MPa }, unloading = 300 * MPa },
    bending = own and { warp = E[1] * third, weft = E[2] * third, twist = 300 * MPa * third } or nil, tested = { warp = 0.05, weft = 0.05, shear = 0.05 } }
end

-- A panel that is sheared in its plane: force, mean share of the folds, and the model.
local function sheared(model)
  local mesh = fabric.mesh.rectangle { width = 0.15, height = 0.12, nx = 4, ny = 3, triangles = model.triangles }
  local m = fabric.model { mesh = mesh, card = model.card, layers = model.layers, folds = model.folds or "within elements", warp = model.warp or 0, offset = model.offset }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("left", "y"):fix("right", "y"):fix("top", "y"):move("top", { x = fabric.ramp(2 * mm, 1) })
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local share = 0
  for _, v in ipairs(a:field "folded") do share = share + v / #mesh.elements end
  return a:reaction "top", share, a
end

local rows = {}
for _, triangles in ipairs { false, true } do
  local own, own_share = sheared { card = film(0.2 * mm, 400, true), triangles = triangles }
  local through, share = sheared { card = film(0.2 * mm, 400), triangles = triangles }
  local plies = sheared { triangles = triangles, layers = { { card = film(0.12 * mm, 400), warp = 0 }, { card = film(0.08 * mm, 400), warp = 0 } } }
  -- a ply whose warp and weft change places with its angle
  local function swapped(thickness)
    local c = film(thickness, 400)
    return c:with { warp = c.weft, weft = c.warp }
  end
  local turned = sheared { triangles = triangles, layers = { { card = film(0.12 * mm, 400), warp = 0 }, { card = swapped(0.08 * mm), warp = 90 } } }
  local kind = triangles and "triangles: " or "quads: "
  print(kind, own, own_share, sheared { card = film(0.2 * mm, 400), triangles = triangles, folds = "resolved" })
  rows[#rows + 1] = { kind .. "through the thickness as of its own", through, own, relative = 1e-8 }
  rows[#rows + 1] = { kind .. "share of folds", share, own_share, relative = 1e-6 }
  rows[#rows + 1] = { kind .. "two plies", plies, own, relative = 1e-8 }
  rows[#rows + 1] = { kind .. "a ply turned by 90 degrees, warp for weft", turned, own, relative = 1e-8 }
end

-- A strip that buckles in waves which the mesh shows is as with folds resolved; and it stays bent as one.
local function pushed(folds)
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 80 * mm, height = 20 * mm, nx = 10, ny = 2 }, card = film(0.4 * mm, 400), folds = folds, warp = 0 }
  m.mesh:map(function(x, y) return x, y, 0.05 * mm * math.sin(math.pi * x / (80 * mm)) end)
  m = fabric.model { mesh = m.mesh, card = film(0.4 * mm, 400), folds = folds, warp = { 1, 0, 0 } }
  m:fix("left", "x y z"):fix("right", "y z"):move("right", { x = fabric.ramp(-4 * mm, 1) })
  local a = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  return a:reaction "right", a
end
rows[#rows + 1] = { "a strip pushed into a wave of 20 elements", pushed "within elements", pushed "resolved", relative = 1e-9 }

rows[#rows + 1] = { "what is read of the yarns is of the middle (1: yes)", (function()
  local _, a = pushed "within elements"
  local _, b = pushed "resolved"
  local most = 0
  for e, v in ipairs(a:field "nominal_strain_warp") do most = math.max(most, math.abs(v - b:field "nominal_strain_warp"[e])) end
  return most < 1e-9 and 1 or 0
end)(), 1, absolute = 0 }

-- Cloth with losses that is crumpled by two edges: the energies close, and a run in two parts is the same.
local function crumpled(scheme, offset)
  local mesh = fabric.mesh.rectangle { width = 60 * mm, height = 60 * mm, nx = 5, ny = 5 }
  mesh:map(function(x, y) return x, y, 2 * mm * math.sin(50 * x) * math.cos(70 * y) end)
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", folds = "within elements", warp = { 1, 0, 0 }, offset = offset }
  m:fix("left", "x y z"):fix("right", "y z"):move("right", { x = fabric.history { { 0, 0 }, { 0.01, -5 * mm }, { 0.02, 1 * mm } } })
  return fabric.dynamic { model = m, duration = 0.02, scheme = scheme, step = scheme == "implicit" and 2e-4 or nil, damping = { mass = 20 } }
end
for _, scheme in ipairs { "explicit", "implicit" } do
  local a = crumpled(scheme, scheme == "implicit" and 0.5 or 0)
  a:advance(0.013)
  local most = 0
  for _, v in ipairs(a:field "folded") do most = math.max(most, v) end
  a:advance(0.02)
  print(scheme, "largest share of folds", most, "ledger", a.energy.error, "dissipated", a.energy.dissipated)
  rows[#rows + 1] = { scheme .. ": it folds (1: yes)", most > 0.2 and 1 or 0, 1, absolute = 0 }
  -- Implicit steps err where the sheet snaps through, 4e-4 before.
  rows[#rows + 1] = { scheme .. ": energies close", a.energy.error, 0, absolute = scheme == "implicit" and 5e-3 or 2e-3 }
  rows[#rows + 1] = { scheme .. ": yarns lose energy (1: yes)", a.energy.dissipated > 0 and 1 or 0, 1, absolute = 0 }
end
fabric.expect(rows)
