-- Laws that remember their path: a step against two halves. path= cuts what errs; without it a warning says so.
-- Of triangles the short form has a sheet that wrinkles less.
-- warns: the steps are long: in two halves they end
-- warns: the steps are long: in four parts they end
-- warns: relaxation has taken
-- warns: the card was tested to
-- warns: folds there, and results are too stiff
-- warns: the shape has become unstable
local fabric = require "fabric"
local mm = fabric.units.mm

local function said(a, code)
  for _, w in ipairs(a.warnings) do if w.code == code then return w end end
end
local function largest(a)
  local most = 0
  for _, s in ipairs(a.steps) do if s.path ~= "unchecked" then most = math.max(most, s.path) end end
  return most
end

-- A sheet held flat whose edge goes out and halfway back within a step: its yarns are left slack by what loading them has taken.
local function pulled(name, o)
  local mesh = fabric.mesh.rectangle { width = 120 * mm, height = 60 * mm, nx = 4, ny = 3, triangles = o.triangles }
  local card = fabric.card(name)
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("all", "z rotation"):fix("left", "x y")
  m:move("right", { x = function(t) return 1.5 * mm * math.sin(math.pi * (t - 0.1 * t * t)) end, y = function(t) return 3 * mm * t * t end })
  local a = fabric.static { model = m, duration = 1, step = o.step, path = o.path }:solve()
  local x, y = a:reaction "right"
  return x, y, a
end
for _, triangles in ipairs { false, true } do
  for _, name in ipairs { "worsted", "denim", "glass" } do
    local fx, fy = pulled(name, { step = 1 / 160, triangles = triangles })
    local size = math.abs(fx) + math.abs(fy)
    for _, step in ipairs { 1, 0.5, 0.25 } do
      local x, y, a = pulled(name, { step = step, triangles = triangles, path = 0.01 })
      fabric.expect {
        { ("%s, %s, steps of %g cut: force x"):format(name, triangles and "triangles" or "quads", step), x, fx, absolute = 0.01 * size },
        { "force y", y, fy, absolute = 0.01 * size },
        { "each step within its part", largest(a) <= 0.01 and 1 or 0, 1, absolute = 0 },
      }
      assert(not said(a, "path"), name)
    end
    local x, y, a = pulled(name, { step = 1, triangles = triangles }) -- as it was: wrong, and said
    assert(math.abs(x - fx) + math.abs(y - fy) > 0.1 * size, "the deck shows nothing")
    assert(said(a, "path") and said(a, "path").serious, name)
  end
end

-- Straight ways need no cuts, whatever the step, and nothing is said.
local function ramp(step, path)
  local mesh = fabric.mesh.rectangle { width = 100 * mm, height = 30 * mm, nx = 3, ny = 2 }
  local m = fabric.model { mesh = mesh, card = fabric.card "worsted", warp = 0 }
  m:fix("all", "z rotation"):fix("left", "x y"):move("right", { x = fabric.ramp(2 * mm, 1) })
  return fabric.static { model = m, duration = 1, step = step, path = path }:solve()
end
for _, step in ipairs { 1, 0.5, 0.05 } do
  local asked, default = ramp(step, 0.001), ramp(step)
  assert(#asked.steps == math.floor(1 / step + 0.5) and #default.steps == #asked.steps)
  assert(largest(asked) < 1e-6 and not said(default, "path"))
  assert(not said(default, "relaxed"), "a stiffening law has not fallen")
  fabric.expect { { "looking does not change the run", default:reaction "right", asked:reaction "right", absolute = 0 } }
end

-- An elastic sheet remembers nothing.
local mesh = fabric.mesh.rectangle { width = 100 * mm, height = 30 * mm, nx = 3, ny = 2 }
local m = fabric.model { mesh = mesh, card = fabric.svk { young = 5e6, poisson = 0.2, density = 600, thickness = 0.4 * mm }, warp = 0 }
m:fix("all", "z rotation"):fix("left", "x y"):move("right", { x = function(t) return 2 * mm * math.sin(math.pi * t) end })
local a = fabric.static { model = m, duration = 1, step = 1, path = 0.01 }:solve()
assert(#a.steps == 1 and a.steps[1].path == "unchecked")

-- A sheet of glass at 30 degrees, pulled and blown, wrinkles: two steps have another shape than eight; that is said.
local function blown(step, path)
  local sheet = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 8, ny = 8 }
  local model = fabric.model { mesh = sheet, card = fabric.card "glass", warp = 30 }
  model:fix("left", "x y z rotation"):fix("right", "y z rotation"):force("right", { x = fabric.ramp(20, 1) }):pressure(fabric.ramp(3, 1))
  local run, w = fabric.static { model = model, duration = 1, step = step, path = path }:solve(), 0
  for i = 1, #sheet.nodes do w = math.max(w, math.abs(run:node(i).z)) end
  return w, run
end
local w2, long = blown(0.5)
local w20, short = blown(0.05)
assert(math.abs(w2 / w20 - 1) > 0.1 and said(long, "path"))
assert(not said(short, "path"))
fabric.expect { { "cut by path=", (blown(0.5, 0.01)), w20, relative = 0.01 } }

-- Of several stable patterns a single step and its halves may both find the second best: whatever is not that of short steps is said, and nothing else.
local wrong = 0
local cut = os.getenv "FABRICSH_TEST_LONG" and { 42, 25, 4, triangles = true } or { 38, 15, 4, triangles = true }
for _, case in ipairs { { 30, 22, 5 }, { 30, 35, 4 }, { 20, 18, 4 }, { 38, 15, 4 }, cut } do
  local function drawn(step)
    local sheet = fabric.mesh.rectangle { width = 0.18, height = 0.18, nx = 8, ny = 8, triangles = case.triangles }
    local model = fabric.model { mesh = sheet, card = fabric.card "glass", warp = case[1] }
    model:fix("left", "x y z rotation"):fix("right", "y z rotation"):force("right", { x = fabric.ramp(case[2], 1) }):pressure(fabric.ramp(case[3], 1))
    local run, w = fabric.static { model = model, duration = 1, step = step }:solve(), 0
    for i = 1, #sheet.nodes do w = math.max(w, math.abs(run:node(i).z)) end
    return w, run
  end
  local at_once, one = drawn(1)
  local slowly, many = drawn(0.05)
  local differs = math.abs(at_once / slowly - 1) > 0.05
  wrong = wrong + (differs and 1 or 0)
  assert(differs == (said(one, "path") ~= nil), "said where another shape was found, and there alone")
  assert(not said(many, "path"))
end
assert(wrong >= 2, "the deck shows nothing")

-- Runs continue with the same bits, and the errors of the steps are in the state.
local _, _, whole = pulled("denim", { step = 0.1, path = 0.02 })
local part
do
  local sheet = fabric.mesh.rectangle { width = 120 * mm, height = 60 * mm, nx = 4, ny = 3 }
  local model = fabric.model { mesh = sheet, card = fabric.card "denim", warp = 0 }
  model:fix("all", "z rotation"):fix("left", "x y")
  model:move("right", { x = function(t) return 1.5 * mm * math.sin(math.pi * (t - 0.1 * t * t)) end, y = function(t) return 3 * mm * t * t end })
  part = fabric.static { model = model, duration = 1, step = 0.1, path = 0.02 }
  for _ = 1, 3 do part:step() end
  local there = part:snapshot()
  part:solve()
  part:restore(there)
  part:solve()
end
fabric.expect { { "after a snapshot, as without", part:reaction "right", whole:reaction "right", absolute = 0 } }
assert(#part.steps == #whole.steps)

-- Where nothing moves there is nothing to compare: neither rounding nor loads below the tolerance of the forces count as displacements,
-- in cloth that is taut from the start or curved without a load. A load that moves taut cloth is compared as ever.
local function taut(name, warp, weft, step, load)
  local mesh = fabric.mesh.rectangle { width = 150 * mm, height = 90 * mm, nx = 5, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card(name), warp = 21, prestress = { warp = warp, weft = weft } }
  mesh:set("one", { 9 })
  m:fix("boundary", "x y z rotation"):force("one", { x = fabric.ramp(load, 1), z = fabric.ramp(load / 3, 1) })
  return fabric.static { model = m, duration = 1, step = step }:solve()
end
for _, step in ipairs { 1, 0.25 } do
  for _, load in ipairs { 0, 2e-9, 1e-4 } do
    assert(not said(taut("denim", 500, 100, step, load), "path"))
    assert(not said(taut("muslin", 200, 200, step, load), "path"))
  end
end
do
  local mesh = fabric.mesh.cylinder { radius = 40 * mm, length = 150 * mm, around = 14, along = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "worsted", warp = { 0, 0, 1 } }:fix("bottom", "x y z")
  assert(not said(fabric.static { model = m, duration = 1, step = 0.5 }:solve(), "path"))
end
do -- a taut sheet whose edge goes out and halfway back within a step
  local mesh = fabric.mesh.rectangle { width = 120 * mm, height = 60 * mm, nx = 4, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "denim", warp = 0, prestress = { warp = 400, weft = 100 } }
  m:fix("all", "z rotation"):fix("left", "x y")
  m:move("right", { x = function(t) return 0.15 * mm * math.sin(math.pi * (t - 0.1 * t * t)) end, y = function(t) return 0.3 * mm * t * t end })
  assert(said(fabric.static { model = m, duration = 1, step = 1 }:solve(), "path"))
end

-- A virtual test is advised by its own fields: `path` of fabric.lab.bias is another one.
local test = fabric.lab.bias { card = fabric.card "worsted", steps = 2, cells = { 2, 4 } }
assert(said(test, "path").text:find "Expected at most 5 %%: more steps=$", said(test, "path").text)
