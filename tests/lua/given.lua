-- Supports, motions and bodies that cannot be as given are refused, or told.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })
local function says(words, chunk)
  local ok, e = pcall(chunk)
  assert(not ok and tostring(e):find(words, 1, true), tostring(e))
end

-- A plane of symmetry, wherever a run is made of it.
local function sheet(warp, set, normal)
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.04, height = 0.03, nx = 4, ny = 3 }, card = card, warp = warp }
  return m:symmetry(set or "left", normal or "x"):fix("right", "x y z")
end
for _, make in ipairs { function(m) return fabric.static { model = m, duration = 1 } end, function(m) return fabric.dynamic { model = m, duration = 1e-3 } end } do
  make(sheet(90))
  make(sheet({ 0, 1, 0 }))
  says("symmetry: set 'left': the cloth of element 1 is not symmetric about the plane, whose normal lies at 30 degrees to the warp: expected warp and weft along and across the plane; or the whole model", function() make(sheet(30)) end)
  says("symmetry: set 'bottom': expected nodes in a plane normal to x, got x from 0 to 0.04 m", function() make(sheet(0, "bottom")) end)
end

-- The messages of the program, run as a user does.
local function talk(name, deck)
  local file = assert(io.open(name .. ".lua", "w"))
  file:write("local fabric = require 'fabric'\nlocal mm = fabric.units.mm\nlocal card = fabric.card('blend', { bending='estimated' })\n", deck)
  file:close()
  local pipe = assert(io.popen(("'%s' --quiet %s.lua 2>&1"):format(arg[-1], name)))
  local text = pipe:read "a"
  pipe:close()
  return text
end

-- Bodies that their motion has moved at time 0, in each kind of run; once.
local moved = [[
local mesh = fabric.mesh.rectangle{ width=0.08, height=0.06, nx=4, ny=3, origin={ -0.04, -0.03 } }
local m = fabric.model{ mesh=mesh, card=card, points=1, warp=0 }
m:fix("boundary", "x y z rotation")
local b = fabric.rigid.sphere{ radius=8*mm, centre={ 0, 0, 20*mm } }
m:contact{ between={ b, "all" } }:move(b, { %s })
local a = %s
a:advance(a.duration / 2):solve()
]]
for i, make in ipairs { "fabric.static{ model=m, duration=1e-4 }", "fabric.dynamic{ model=m, duration=1e-4, scheme='implicit' }", "fabric.dynamic{ model=m, duration=1e-4 }" } do
  local kind = i == 1 and "static" or "dynamic"
  local text = talk("moved", moved:format("x=3*mm, z=-5*mm, turn={ axis={ 0, 0, 1 }, angle=20 }", make))
  local words = kind .. ": the motion of the sphere (x = 0.003 m), the motion of the sphere (z = -0.005 m) and the motion of the sphere (turn = 20 degrees) are not zero at time 0; the run starts with the bodies there\n"
  local from, to = text:find(words, 1, true)
  assert(from and not text:find(words, to, true), text)
  text = talk("moved", moved:format("z=fabric.ramp(-5*mm, 1e-4)", make))
  assert(not text:find("time 0", 1, true), text)
end

-- Cloth inside a closed solid, also where another sheet is outside of it; a hollow body may hold it.
local tetrahedron = { { 0, 0, -0.03 }, { 0.09, 0, -0.03 }, { 0, 0.08, -0.03 }, { 0.01, 0.01, 0.07 } }
local function solid(options, z)
  local file = os.tmpname() .. ".obj"
  local h = assert(io.open(file, "w"))
  for _, v in ipairs(tetrahedron) do h:write(("v %g %g %g\n"):format(table.unpack(v))) end
  h:write "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
  h:close()
  options.file = file
  local body = fabric.rigid.surface(options)
  os.remove(file)
  local function square(at)
    return fabric.mesh.rectangle { width = 0.01, height = 0.008, nx = 2, ny = 2 }:map(function(x, y) return x + 0.015, y + 0.012, at end)
  end
  local m = fabric.model { bodies = { { name = "high", mesh = square(0.2), card = card, warp = 0 }, { name = "low", mesh = square(z), card = card, warp = 0 } } }
  m:contact { between = { body, "all" } }
  return fabric.dynamic { model = m, duration = 1e-5 }
end
says("contact: node 10 starts inside the surface, which bounds a solid: expected the cloth outside of it (a hollow body has neither closed=true nor a mass)", function() solid({ closed = true }, -0.011) end)
says("contact: node 10 starts inside the surface", function() solid({ mass = 0.1 }, -0.011) end)
solid({}, -0.011)
solid({ closed = true }, -0.05)

-- Driven cloth and driven bodies that meet in a step, whatever its length; and such as pass each other.
local function traffic(kind, step, beside, turned)
  local mesh = fabric.mesh.rectangle { width = 0.012, height = 0.01, nx = 3, ny = 2, origin = { -0.036, -0.004 } }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  m:fix("all", "rotation"):move("all", { x = fabric.ramp(0.06, 1), y = 0, z = 0 })
  local b = fabric.rigid.cylinder { radius = 3 * mm, from = { 0, -0.03, -0.005 }, to = { 0, -0.03, 0.005 } }
  m:contact { between = { b, "all" } }:move(b, { x = beside or 0, y = fabric.ramp(0.06, 1) })
  local options = { model = m, duration = 1, step = step }
  if kind == "static" then return fabric.static(options):solve() end
  options.scheme, options.ledger_limit = "implicit", 1e9
  return fabric.dynamic(options):solve()
end
for _, kind in ipairs { "static", "implicit" } do
  for _, step in ipairs { 1, 0.3 } do
    says("parts of the cloth whose motion is given pass through what is fixed or driven", function() traffic(kind, step) end)
    assert(traffic(kind, step, 0.03).time == 1)
  end
end
-- A sheet that is turned round a post beside it passes it in steps that follow the turn.
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.01, nx = 2, ny = 1, origin = { 0.03, -0.005 } }
local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
local post = fabric.rigid.cylinder { radius = 6 * mm, from = { 0, 0, -0.01 }, to = { 0, 0, 0.01 } }
m:turn("all", { axis = { 0, 0, 1 }, angle = fabric.ramp(180, 1), centre = { 0, 0, 0 } }):contact { between = { post, "all" } }
local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
assert(a.time == 1 and #a.steps > 1 and math.abs(a:node(1).x + 0.03) < 1e-9)

-- However small a strain, it is a number; a large one is asked about.
assert(talk("small", "fabric.point(card):strain{ E11=0.02, E12=3e-17 }\nfabric.point(card):strain{ E22=-2e-300 }") == "")
assert(talk("large", "fabric.point(card):strain{ E12=12 }"):find("field 'E12': 12 is far from what cloth is: strains are numbers, not per cent", 1, true))

-- A name that is nil at the end of a call is what a misspelt variable is: asked about, and refused where a body is meant. Not so one that is left out, or in the modules.
do
  local sheet = "local mesh = fabric.mesh.rectangle{ width=0.07, height=0.05, nx=2, ny=2 }\nlocal m = fabric.model{ mesh=mesh, card=card, points=1, warp=0 }\n"
  local words = talk("nameless", sheet .. "local edge\nm:pressure(3, edge)")
  assert(words:find("nameless.lua:7: pressure: argument 'set': nil stands for none (or is it a misspelt variable?)", 1, true), words)
  assert(talk("left", sheet .. "m:pressure(3)\nm:tie('rigid', 'left')\nmesh:check()") == "")
  words = talk("unknown", sheet .. "local c\nprint(pcall(mesh.check, mesh, c))")
  assert(words:find("check: argument 'card': expected a card, or no value, got nil (a misspelt variable?)", 1, true), words)
end

-- An angle in radians, several numbers with one wrong unit, a card without tested strains, and a name out of a long list: one line each.
do
  local sheet = "local mesh = fabric.mesh.rectangle{ width=0.08, height=0.06, nx=4, ny=3 }\nlocal m = fabric.model{ mesh=mesh, card=card, points=1, warp=%s }\n"
  assert(talk("radians", sheet:format "math.rad(45)"):find("radians.lua:5: field 'warp': 0.7853981633974483 degrees are the radians of 45 degrees: is it an angle in degrees?", 1, true))
  for _, angle in ipairs { "1.5", "0", "45", "0.3", "math.rad(31.7)", "-90" } do assert(talk("degrees", sheet:format(angle)) == "") end
  local own = "fabric.woven{ name='own', density=%s, thickness=%s, warp={ loading={2e8}, unloading=%s, poisson=0 }, weft={ loading={5e7}, unloading=5e7, poisson=0 }, shear={ loading={2e6}, unloading=2e6 } }\n"
  local words = talk("unit", "local c = " .. own:format("0.6", "0.4", "2e8"))
  assert(select(2, words:gsub("\n", "\n")) == 1 and words:find("field 'density': 0.6 kg/m^3 is far from what cloth is", 1, true) and words:find("so are field 'thickness', 0.4 m", 1, true), words)
  words = talk("guards", "local mesh = fabric.mesh.rectangle{ width=0.08, height=0.06, nx=4, ny=3 }\nfabric.model{ mesh=mesh, warp=0, card=" .. own:format("600", "4e-4", "2e8"):gsub("\n", "") .. " }")
  assert(select(2, words:gsub("\n", "\n")) == 1 and words:find("guard.warp: range guard from E11 = 0.3 on", 1, true) and words:find("; likewise guard.weft, guard.shear", 1, true), words)
  -- The mass of a body is asked about by its density: grams for kilograms, and millimetres for metres.
  words = talk("grams", "fabric.rigid.sphere{ radius=0.03, centre={0, 0, 0}, mass=50 }")
  assert(words:find("sphere: field 'mass': 50 kg in 0.000113 m^3 is 4.42e+05 kg/m^3, far from what bodies are: is it in kg", 1, true), words)
  words = talk("tonnes", "fabric.rigid.cylinder{ radius=0.03, from={0, 0, 0}, to={0, 0, 0.3}, mass=1e-4 }")
  assert(words:find("cylinder: field 'mass': 0.0001 kg in 0.000961 m^3 is 0.104 kg/m^3", 1, true), words)
  assert(talk("usual", "fabric.rigid.sphere{ radius=0.02, centre={0, 0, 0}, mass=0.0027 }\nfabric.rigid.disc{ radius=0.05, edge=1e-3, centre={0, 0, 0}, normal={0, 0, 1}, mass=0.05 }") == "")
  words = talk("name", sheet:format "0" .. "m:fix('all', 'z rotation'):fix('left', 'x y'):move('right', { x=fabric.ramp(1e-4, 1) })\nlocal a = fabric.static{ model=m, duration=1, step=1 }:solve()\na:field 'S_11'")
  assert(words:find("field: argument 'name': got 'S_11', did you mean 'S11'? Expected one of", 1, true), words)
end
