-- Fields of single plies, by number and by name, and of all together where their axes differ.
local fabric = require "fabric"
local width, height, u = 0.06, 0.09, 0.0027
local fields = { warp = 9e6, weft = 7e5, shear = 3e5, poisson = 0, density = 400, thickness = 0.4e-3, through_thickness = true }
local stiff = fabric.svk(fields)
fields.warp, fields.weft, fields.shear = 3e6, 2e6, 8e5
local soft = fabric.svk(fields)

-- Pulled along x, its width held: Exx alone is not zero, and the shear that turned plies want is held, too.
local function pull(layers, warp)
  local mesh = fabric.mesh.rectangle { width = width, height = height, nx = 2, ny = 3 }
  -- Straight edges, but no parallelograms.
  mesh:map(function(x, y) return x + 40 * y * (height - y) * x * (width - x), y + 4 * x * y * (height - y), 0 end)
  local m = fabric.model { mesh = mesh, layers = layers, warp = warp or 0, points = 2 }
  m:fix("all", "y z rotation"):fix("left", "x")
  local l = 1 + u / width
  for i, n in ipairs(mesh.nodes) do
    mesh:set("n" .. i, { i })
    if n[1] > 1e-9 then m:move("n" .. i, { x = fabric.ramp((l - 1) * n[1], 1) }) end
  end
  return fabric.static { model = m, duration = 1, step = 1 }, mesh
end
local l = 1 + u / width
local Exx = (l * l - 1) / 2

-- Second Piola-Kirchhoff stress along x of a ply at an angle, with E of x alone and no Poisson effect.
local function along(card, angle)
  local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
  return (card.warp * c ^ 4 + card.weft * s ^ 4 + 4 * card.shear * c * c * s * s) * Exx
end

local a = pull { { card = stiff, warp = 0, thickness = 0.2e-3 }, { card = soft, warp = 35, thickness = 0.5e-3, name = "core" }, { card = stiff, warp = 90, thickness = 0.3e-3, name = "face" } }
a:record("plies.csv", { columns = { all = "tension_warp", core = "core.E12", set = { "ply3.S22", "all" } } })
a:vtk("plies", { fields = { "E", "face.E", "ply2.S11", "core.warp", "core.shear_angle" } })
a:solve()
local right = 0
for i, n in ipairs(a.mesh.nodes) do if math.abs(n[1] - width) < 1e-9 then right = right + a:reaction("n" .. i) end end
local want = { along(stiff, 0) * 0.2e-3, along(soft, 35) * 0.5e-3, along(stiff, 90) * 0.3e-3 }
local c, s = math.cos(math.rad(35)), math.sin(math.rad(35))
fabric.expect {
  { "force of the closed form, N", right, height * l * (want[1] + want[2] + want[3]), relative = 1e-9 },
  { "tension of all plies over the width, N/m", a:mean "tension_warp", right / height, relative = 1e-9 },
  { "tension of the lowest ply, N/m", a:mean "ply1.tension_warp", l * want[1], relative = 1e-9 },
  { "tension of the ply across, N/m", a:mean "face.tension_weft", l * want[3], relative = 1e-9 },
  { "E along x, all", a:mean "E11", Exx, relative = 1e-9 },
  { "E across, all", a:mean "E22", 0, absolute = 1e-12 },
  { "E12, all", a:mean "E12", 0, absolute = 1e-12 },
  { "E11 of the core", a:mean "core.E11", c * c * Exx, relative = 1e-9 },
  { "E22 of the core", a:mean "ply2.E22", s * s * Exx, relative = 1e-9 },
  { "E12 of the core", a:mean "core.E12", -c * s * Exx, relative = 1e-9 },
  { "E22 of the face", a:mean "face.E22", Exx, relative = 1e-9 },
  { "nominal strain of the face's weft", a:mean "face.nominal_strain_weft", l - 1, relative = 1e-9 },
  { "S11 of the core", a:mean "core.S11", soft.warp * c * c * Exx, relative = 1e-9 },
  { "shear angle of the core", a:mean "core.shear_angle", math.deg(math.asin(-2 * c * s * Exx / math.sqrt((1 + 2 * c * c * Exx) * (1 + 2 * s * s * Exx)))), relative = 1e-9 },
  { "shear angle along and across the model's warp", a:mean "shear_angle", 0, absolute = 1e-9 },
}
-- The energy of all is that of the plies, by their volumes.
local t = { 0.2, 0.5, 0.3 }
local stored = 0
for i = 1, 3 do stored = stored + t[i] * a:mean("ply" .. i .. ".stored") end
fabric.expect { { "stored energy", a:mean "stored", stored, relative = 1e-12 } }
for e, w in ipairs(a:field "core.warp") do
  local x, y = l * c, s
  local n = math.sqrt(x * x + y * y)
  assert(math.abs(w[1] - x / n) < 1e-12 and math.abs(w[2] - y / n) < 1e-12, e)
  assert(math.abs(a:field "warp"[e][1] - 1) < 1e-12)
end

-- Columns and files have the same names and numbers.
local column = {}
for _, one in ipairs(fabric.table { file = "plies.csv" }) do column[one.name] = one.values end
assert(column.all[2] == a:mean "tension_warp" and column.core[2] == a:mean "core.E12" and column.set[2] == a:mean "face.S22")
local file = assert(io.open("plies_00001.vtu", "rb"))
local names = {}
for name in file:read "a":gmatch '<DataArray[^>]*Name="([^"]*)"' do names[name] = true end
file:close()
for _, name in ipairs { "E", "face.E", "ply2.S", "core.warp", "core.shear_angle" } do assert(names[name], name) end
assert(not names["ply2.E"] and not names["core.displacement"] and not names["slack"])

-- Yarns' own strains have no mean over plies with different axes; one ply has them.
local function says(words, chunk) local ok, e = pcall(chunk) assert(not ok and tostring(e):find(words, 1, true), tostring(e)) end
says("field 'residual1': the plies of this model have different axes, so each has yarns of its own: expected the field of a ply, as in 'ply1.residual1'", function() a:mean "residual1" end)
says("field 'slack': the plies", function() a:field "slack" end)
assert(a:mean "core.residual1" == 0 and a:element(1).residual1 == nil and a:element(1).E11)
says("field 'faec.E11': unknown ply 'faec', did you mean 'face'? (known: ply1 ply2 ply3 core face)", function() a:mean "faec.E11" end)
says("field 'face.ux': 'ux' is not of single plies: expected it alone", function() a:mean "face.ux" end)
says("unknown ply 'ply4'", function() a:field "ply4.E" end)
says("unknown ply 'top'", function() a:record("x.csv", { columns = { q = "top.E11" } }) end)
says("unknown ply 'top'", function() a:write("x.vtu", { fields = { "top.E11" } }) end)

-- Plies with the same axes share them, whatever their angle to the model's warp.
local same = pull({ { card = stiff, warp = 20 }, { card = stiff, warp = 20 } }, -20)
same:solve()
fabric.expect { { "E11 in common axes", same:mean "E11", Exx, relative = 1e-9 }, { "of a ply", same:mean "ply2.E11", Exx, relative = 1e-9 } }
assert(same:mean "residual1" == 0)

-- Without layers the sheet is its one ply; where only some bodies have a ply, the others have no number.
local function square(x)
  return fabric.mesh.rectangle { width = 0.01, height = 0.01, nx = 1, ny = 1, origin = { x, 0 } }
end
local m = fabric.model { bodies = {
  { name = "one", mesh = square(0), card = stiff },
  { name = "two", mesh = square(1), layers = { { card = stiff }, { card = soft, warp = 90, name = "face" } } },
} }
m:fix("all", "z rotation"):fix("one.left", "x y"):fix("two.left", "x y"):move("one.right", { x = fabric.ramp(2e-4, 1) }):move("two.right", { x = fabric.ramp(2e-4, 1) })
local b = fabric.static { model = m, duration = 1, step = 1 }:solve()
assert(b:field "ply1.E11"[1] == b:field "E11"[1])
local face = b:field "face.E22"
assert(face[1] ~= face[1] and math.abs(face[2] - 0.0202) < 1e-12)
for _, name in ipairs { "warp", "cauchy_11", "nominal_strain_warp", "tension_warp", "shear_angle", "stored" } do
  local v = b:field("face." .. name)[1]
  v = type(v) == "table" and v[1] or v
  assert(v ~= v, name)
end
assert(math.abs(b:mean("face.E22", "two.all") - 0.0202) < 1e-12)
says("mean: element 1 of body one of set 'all' has no ply 'face'", function() b:mean "face.E22" end)
