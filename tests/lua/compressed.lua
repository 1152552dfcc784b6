-- Elements that are compressed far beyond what folds are told where their compression is much of the energy, and not where it is a crease's.
local fabric = require "fabric"
local mm, MPa = fabric.units.mm, fabric.units.MPa

local function said(run)
  for _, w in ipairs(run.warnings) do
    if w.code == "compressed" then return w end
  end
end

-- One of two discs of film that are sewn and blown up: its rim is drawn in, and has nothing but elements to fold with.
local yarn = { loading = { 700 * MPa }, unloading = 700 * MPa, poisson = 0.3 }
local film = fabric.woven { name = "film", density = 1100, thickness = 0.08 * mm, warp = yarn, weft = yarn, shear = { loading = { 530 * MPa }, unloading = 530 * MPa },
  bending = { warp = 2e-7, weft = 2e-7, twist = 1e-7 }, tested = { warp = 0.3, weft = 0.3, shear = 0.3 } }
local function blown(folds)
  local m = fabric.model { mesh = fabric.mesh.disk { radius = 90 * mm, cells = 6 }, card = film, warp = 0, folds = folds }
  m:fix("boundary", "z"):fix("centre", "x y"):pressure(fabric.ramp(150, 1))
  return fabric.static { model = m, duration = 1, step = 0.1, method = "either" }:solve()
end
local w = said(blown "resolved")
assert(w and w.serious and w.text:find("% of the energy is compression of such elements", 1, true), w and w.text)
assert(not said(blown "within elements"))

-- A sheet that falls over a ball: creases beside it are compressed, and the sheet moves and bends all the same.
local function fallen(n)
  local card = fabric.card("muslin", { bending = "estimated" })
  local mesh = fabric.mesh.rectangle { width = 0.24, height = 0.2, nx = n, ny = n, origin = { -0.12, -0.1 } }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  m:gravity { 0, 0, -9.81 }
  local ball = fabric.rigid.sphere { radius = 50 * mm, centre = { 0, 0, -52 * mm }, name = "ball" }
  m:contact { between = { ball, "all" }, friction = 0.3, thickness = 2 * mm }
  local run = fabric.dynamic { model = m, duration = 0.22, damping = { mass = 6 } }
  run:solve()
  return run
end
local run = fallen(7)
assert(not said(run) and run.energy.error < 1e-2)
