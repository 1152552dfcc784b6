-- Convergence in displacement on smooth problems with exact solutions, on regular meshes and on meshes whose inner nodes
-- are moved at random by up to 0.2 of an element (on every mesh anew, so that elements never become parallelograms):
--   sheet  a square of an isotropic sheet under its own weight in its plane, u a quadratic, held at its edges to it;
--   plate  a square cut from a clamped circular Mindlin plate under pressure, w of fourth order, displacements and
--          rotations of the edges held to it.
-- Loads are so small that the linear solutions hold to about 1e-6. The error is the root mean square over the nodes,
-- over that of the solution.
--
--   fabricsh scripts/verify/rates.lua
-- warns: is far from what cloth is
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local young, nu, thickness = 1e9, 0.3, 0.02

local function square(n, shift, seed)
  local mesh = fabric.mesh.rectangle { width = 1, height = 1, nx = n, ny = n, origin = { -0.5, -0.5 } }
  math.randomseed(seed)
  mesh:map(function(x, y, z)
    if math.abs(math.abs(x) - 0.5) < 1e-9 or math.abs(math.abs(y) - 0.5) < 1e-9 then return x, y, z end
    return x + (2 * math.random() - 1) * shift / n, y + (2 * math.random() - 1) * shift / n, z
  end)
  return mesh
end

local function rim(mesh, act)
  for i, node in ipairs(mesh:set "boundary") do
    mesh:set("rim " .. i, { node })
    act("rim " .. i, mesh.nodes[node])
  end
end

-- Root mean square of the error over that of the solution.
local function judge(run, mesh, component, exact)
  local miss, size = 0, 0
  for i = 1, #mesh.nodes do
    local X, u = mesh.nodes[i], run:node(i)
    local want = { exact(X[1], X[2]) }
    for k, name in ipairs(component) do
      miss, size = miss + (u[name] - want[k]) ^ 2, size + want[k] ^ 2
    end
  end
  return math.sqrt(miss / size)
end

local function card(density)
  return fabric.svk { name = "sheet", young = young, poisson = nu, density = density, thickness = thickness }
end

local function sheet(n, shift)
  local f = 1e-6 * young -- weight per volume: strains of 1e-6
  local function exact(x, y) return -nu * f / young * x * y, f / (2 * young) * (y * y + nu * x * x) end
  local mesh = square(n, shift, n)
  local m = fabric.model { mesh = mesh, card = card(f / 10), warp = 0 }
  m:fix("all", "z rotation"):gravity { 0, -10, 0 }
  rim(mesh, function(set, X)
    local u, v = exact(X[1], X[2])
    m:move(set, { x = fabric.ramp(u, 1), y = fabric.ramp(v, 1) })
  end)
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  return judge(run, mesh, { "ux", "uy" }, exact)
end

local function plate(n, shift)
  local D, shear = young * thickness ^ 3 / 12 / (1 - nu ^ 2), 5 / 6 * young / (2 * (1 + nu)) * thickness
  local q = 1e-3 * thickness * 64 * D -- deflection of a thousandth of the thickness for a = 1
  local function exact(x, y)
    local r2 = x * x + y * y
    return q / (64 * D) * (1 - r2) ^ 2 + q / (4 * shear) * (1 - r2)
  end
  local mesh = square(n, shift, n)
  local m = fabric.model { mesh = mesh, card = card(1000), warp = 0 }
  m:fix("all", "x y"):traction("all", { z = fabric.ramp(q, 1) })
  rim(mesh, function(set, X)
    local x, y = X[1], X[2]
    m:move(set, { z = fabric.ramp(exact(x, y), 1) })
    -- The director turns by minus the slope of the bending part, about (-y, x): its tilt is outward along (x, y).
    local r = math.sqrt(x * x + y * y)
    local tilt = q / (16 * D) * (1 - r * r) * r
    m:turn(set, { axis = { -y / r, x / r, 0 }, angle = fabric.ramp(math.deg(tilt), 1) })
  end)
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  return judge(run, mesh, { "uz" }, exact)
end

local checks = {}
for _, problem in ipairs { { "sheet", sheet }, { "plate", plate } } do
  local name, solve = problem[1], problem[2]
  for _, shift in ipairs { 0, 0.2 } do
    local kind = shift == 0 and "regular" or "distorted"
    print(("%s, %s mesh"):format(name, kind))
    local errors = {}
    for _, n in ipairs { 4, 8, 16, 32 } do
      errors[n] = solve(n, shift)
      local order = errors[n / 2] and errors[n] > 0 and ("   order %.2f"):format(math.log(errors[n / 2] / errors[n], 2)) or ""
      print(("  %2d x %-2d  %10.3e%s"):format(n, n, errors[n], order))
    end
    local order = math.log(errors[8] / errors[32], 4)
    -- Regular meshes are exact at the nodes for the quadratic; the order of random meshes scatters.
    if errors[32] > 1e-6 then checks[#checks + 1] = { ("order, %s, %s mesh"):format(name, kind), order, 2, absolute = 0.25 } end
  end
end
if fabric.checking() then return end
fabric.expect(checks)
