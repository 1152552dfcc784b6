-- Details that a mesh can show, before a run: folds by weight and on flesh beside the elements, and what it means for a sheet that is held flat, pulled,
-- hung, or pressed by a body.
local fabric = require "fabric"
local mm, MPa = fabric.units.mm, fabric.units.MPa
local yarn = { loading = { 60 * MPa }, unloading = 60 * MPa, poisson = 0 }
local B = 7e-6
local card = fabric.woven { name = "sheet", density = 500, thickness = 0.4 * mm, warp = yarn, weft = yarn, shear = { loading = { 4 * MPa }, unloading = 4 * MPa },
  bending = { warp = B, weft = 2 * B, twist = B }, tested = { warp = .1, weft = .1, shear = .3 } }
local mesh = fabric.mesh.rectangle { width = 120 * mm, height = 60 * mm, nx = 6, ny = 3 }
local own, flesh, k = 2 * math.pi * (B / (500 * 0.4e-3 * 9.81)) ^ (1 / 3), 2 * math.pi * (B / 3e6) ^ 0.25, 3e6

local function model(tell)
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  tell(m)
  return m:check()
end
local function has(text, ...)
  for _, words in ipairs { ... } do assert(text:find(words, 1, true), words .. " is not in: " .. text) end
  assert(select(2, text:gsub("\n", "")) == 1, text) -- two lines
end
local function body(stiffness)
  return function(m)
    m:fix("left", "x y z"):gravity { 0, 0, -9.81 }
    local floor = fabric.rigid.plane { point = { 0, 0, -20 * mm }, normal = { 0, 0, 1 } }
    m:contact { between = { floor, "all" }, thickness = 12 * mm, stiffness = stiffness }
  end
end

local report, without = mesh:check(card, 0, k), mesh:check(card, 0)
assert(report.text:find(("folds on what gives way under it about %.3g mm from one to the next"):format(flesh / mm), 1, true), report.text)
assert(not without.text:find "gives way" and without.text:find("pulls in the plane do not need that", 1, true), without.text)
local small = ("elements of %.3g mm"):format(flesh / 8 / mm)

has(model(function(m) m:fix("all", "z"):fix("left", "x y") end), "the cloth is held in its plane, where none can form")
has(model(function(m) m:fix("left", "x y z"):force("right", { x = 1 }) end), "a pull does not need them", ("elements of %.3g mm"):format(own / 8 / mm))
local hung = model(function(m) m:fix("left", "x y z"):gravity { 0, 0, -9.81 } end)
has(hung, "for draping and crumpling elements of")
assert(not hung:find "pulls in the plane", hung)
has(model(body(k)), "pressures where it folds need " .. small .. ' or folds="within elements"')
has(model(body(nil)), "for draping and crumpling elements of") -- a hard body
local fine = fabric.mesh.rectangle { width = 8 * mm, height = 4 * mm, nx = 10, ny = 5 }
assert(fine:check(card, 0, k).text:find("the mesh shows them", 1, true))

fabric.expect {
  { "folds by weight, m", report.folds.length, own, relative = 1e-9 },
  { "folds on flesh, m", report.folds.flesh, flesh, relative = 1e-9 },
  { "without flesh there are none", without.folds.flesh, 0, absolute = 0 },
  { "elements, m", report.folds.element, 20 * mm, relative = 1e-9 },
}
