-- Stiff yarns that run obliquely across a mesh: quadrilaterals of any shape give the force of a mesh along the yarns,
-- aligned ones are as they were, and a run on triangles says that they lock.
local fabric = require "fabric"
local mm, MPa = fabric.units.mm, fabric.units.MPa
local card = fabric.woven { name = "stiff", density = 900, thickness = 0.3 * mm, warp = { loading = { 900 * MPa }, unloading = 900 * MPa, poisson = 0 },
  weft = { loading = { 700 * MPa }, unloading = 700 * MPa, poisson = 0 }, shear = { loading = { 0.2 * MPa, 0, 3 * MPa }, unloading = 2 * MPa, measure = "tensor" },
  bending = { warp = 1e-5, weft = 1e-5, twist = 1e-5 }, tested = { warp = .05, weft = .05, shear = .5 } }
local W, H, pull = 40 * mm, 110 * mm, 15 * mm

local function moved(mesh, n)
  local h = 0.2 * W / n
  return mesh:map(function(x, y)
    local inside = math.min(1, 16 * x * (W - x) / W ^ 2, 40 * y * (H - y) / H ^ 2)
    return x + h * inside * math.sin(301 * x + 777 * y), y + h * inside * math.cos(613 * x - 401 * y), 0
  end)
end

-- N: the force of a strip with clamped ends, and the codes of the run's warnings.
local function force(n, angle, kind, yarns)
  local mesh = fabric.mesh.rectangle { width = W, height = H, nx = n, ny = math.floor(n * H / W + 0.5), triangles = kind == "triangles" or kind == "pairs" }
  if kind == "pairs" then mesh:pair() end
  if kind == "moved" then moved(mesh, n) end
  local m = fabric.model { mesh = mesh, card = card, warp = angle, yarns = yarns }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(pull, 1) })
  local run = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  local codes = {}
  for _, w in ipairs(run.warnings) do codes[#codes + 1] = w.code end
  return select(2, run:reaction "top"), table.concat(codes, " "), mesh
end

-- The same of a panel whose grain is at an angle to its sides: with rows along the grain, so that it has a rim of
-- triangles, as it is meshed and refined; and with those that it takes by itself.
local function of_panel(n, angle, rows, refined)
  local mesh = fabric.mesh.panel { outline = { { 0, 0 }, { W, 0, name = "low" }, { W, H }, { 0, H, name = "high" }, { 0, 0 } }, size = W / n, grain = angle, rows = rows }
  if refined then mesh:refine() end
  local m = fabric.model { mesh = mesh, card = card }
  m:fix("all", "z rotation"):fix("low", "x y"):fix("high", "x"):move("high", { y = fabric.ramp(pull, 1) })
  local run = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  local said = ""
  for _, w in ipairs(run.warnings) do said = said .. " " .. w.text end
  return select(2, run:reaction "high"), said
end

-- A barrel, 30 mm wide at its jaws and 40 mm in the middle, pulled at 34 degrees to its yarns: the rectangle mapped
-- on it, and panels of either kind.
local function of_barrel(n, kind)
  local R = (55 ^ 2 + 5 ^ 2) / 10 * mm
  local mesh, low, high
  if kind == "mapped" then
    low, high = "bottom", "top"
    mesh = fabric.mesh.rectangle { width = 30 * mm, height = H, nx = n, ny = math.floor(n * H / W + 0.5) }
    mesh:map(function(x, y)
      local half = 20 * mm - (R - math.sqrt(R ^ 2 - (y - H / 2) ^ 2))
      return 15 * mm + (x / (15 * mm) - 1) * half, y, 0
    end)
  else
    low, high = "low", "high"
    mesh = fabric.mesh.panel { size = W / n, grain = 34, quadrilaterals = kind, outline = { { 0, 0 }, { 30 * mm, 0, name = "low" },
      { arc = { through = { 35 * mm, H / 2 }, to = { 30 * mm, H } } }, { 0, H, name = "high" }, { arc = { through = { -5 * mm, H / 2 }, to = { 0, 0 } } } } }
  end
  local m = fabric.model { mesh = mesh, card = card, warp = 34 }
  m:fix("all", "z rotation"):fix(low, "x y"):fix(high, "x"):move(high, { y = fabric.ramp(pull, 1) })
  local run = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  local said = ""
  for _, w in ipairs(run.warnings) do said = said .. " " .. w.text end
  return select(2, run:reaction(high)), said, mesh:check().triangles
end

local along = fabric.lab.bias_extension { card = card, width = W, length = H, displacement = pull, cells = 8, steps = 10 }
local limit = along.curve[#along.curve].force
local coarse, silent = force(3, 45)
local fine = force(8, 45)
local pairs_of, no_word = force(6, 31, "pairs")
local quads = force(6, 31)
local locked, said, mesh = force(6, 31, "triangles")
print("45 degrees: limit", limit, "3 across", coarse, "8 across", fine, "full", force(3, 45, nil, "full"), "moved", force(8, 45, "moved"))
print("31 degrees: 6", quads, "12", force(12, 31), "pairs", pairs_of, "triangles", locked)
local rim, rim_said = of_panel(6, 45, 45)
local refined, refined_said = of_panel(3, 45, 45, true)
local usual, usual_said = of_panel(6, 31)
print("panel at 45 degrees: 6 across", rim, "refined", refined, "over quads", force(6, 45))
local barrel = of_barrel(10, "mapped")
local barrel4, barrel_said, none = of_barrel(4)
local locks, locks_said, some = of_barrel(4, false)
print("barrel: mapped", barrel, "4 across", barrel4, "8 across", of_barrel(8), "with", some, "triangles", locks)
local report = mesh:check(card, 31)
print(report)

fabric.expect {
  { "45 degrees, 3 across, over a mesh along the yarns", coarse / limit, 1, relative = 0.25 },
  { "45 degrees, 8 across", fine / limit, 1, relative = 0.08 },
  { "45 degrees, 8 across, nodes moved", force(8, 45, "moved") / limit, 1, relative = 0.10 },
  { "as interpolated it locks (1: yes)", force(3, 45, nil, "full") > 5 * limit and 1 or 0, 1, relative = 1e-12 },
  { "31 degrees: 6 across over 12", quads / force(12, 31), 1, relative = 0.10 },
  { "triangles in pairs are those quadrilaterals", pairs_of, quads, relative = 1e-6 },
  { "along the warp: as interpolated", force(4, 90), force(4, 90, nil, "full"), relative = 1e-12 },
  { "along the weft: as interpolated", force(4, 0), force(4, 0, nil, "full"), relative = 1e-12 },
  { "triangles lock (1: yes)", locked > 1.5 * quads and 1 or 0, 1, relative = 1e-12 },
  { "and the run says so (1: yes)", said:find "oblique" and 1 or 0, 1, relative = 1e-12 },
  { "the rim of a panel locks (1: yes)", rim > 1.2 * force(6, 45) and 1 or 0, 1, relative = 1e-12 },
  { "which is said, with a way out (1: yes)", rim_said:find("mesh:refine()", 1, true) and 1 or 0, 1, relative = 1e-12 },
  { "a refined panel keeps less than two fifths of the excess (1: yes)", refined - force(6, 45) < 0.4 * (rim - force(6, 45)) and 1 or 0, 1, relative = 1e-12 },
  { "and is silent (1: yes)", refined_said:find "lock" and 0 or 1, 1, relative = 1e-12 },
  { "a panel's rows are along its sides by default", usual, quads, relative = 1e-6 },
  { "and it is silent (1: yes)", usual_said:find "lock" and 0 or 1, 1, relative = 1e-12 },
  { "a panel with curved sides has no triangle", none, 0, absolute = 0 },
  { "barrel, 4 across, over a mapped mesh", barrel4 / barrel, 1, relative = 0.20 },
  { "barrel, 8 across", of_barrel(8) / barrel, 1, relative = 0.08 },
  { "with triangles it locks (1: yes)", some > 0 and locks > 1.5 * barrel and 1 or 0, 1, relative = 1e-12 },
  { "which is said, with that way out (1: yes)", locks_said:find("quadrilaterals=true", 1, true) and 1 or 0, 1, relative = 1e-12 },
  { "without it is silent (1: yes)", barrel_said:find "lock" and 0 or 1, 1, relative = 1e-12 },
  { "quadrilaterals say nothing (1: yes)", (silent .. no_word):find "oblique" and 0 or 1, 1, relative = 1e-12 },
  { "check: stiffness over shear", report.yarns.stiffness, 900 / 0.1, relative = 1e-9 },
  { "check: all triangles lock", report.yarns.locking, 1, relative = 1e-9 },
  { "check: own folds, m", report.folds.length, 2 * math.pi * (1e-5 / (900 * 0.3e-3 * 9.81)) ^ (1 / 3), relative = 1e-9 },
  { "check: element, m", report.folds.element, (W * H / #mesh.elements * 2) ^ 0.5, relative = 1e-9 },
}
