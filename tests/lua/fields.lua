-- The fields of a run: one list of names for a:field, a:mean, a:node, a:element, tables, files and help.
local fabric = require "fabric"
local registry = require "fabric.define".registry
local card = fabric.card "blend"
local width, height, steps = 0.0254, 0.0762, 4

-- Warp along y, the top edge moved; the sheet deforms alike everywhere.
local function strip(move, nx, ny)
  local mesh = fabric.mesh.rectangle { width = width, height = height, nx = nx, ny = ny }
  local m = fabric.model { mesh = mesh, card = card, warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "y"):fix(move.x and "bottom" or "left", "x")
  return fabric.static { model = m:move("top", move), duration = 1, step = 1 / steps }, mesh
end

-- Every name gives a number or a list per node or element, and all ways to it give the same.
local a, mesh = strip({ y = fabric.ramp(0.01, 1) }, 2, 3)
a:record("table.csv", { columns = { mean = "S11", part = { "E11", "all" }, edge = { "uy", "top" }, angle = "shear_angle", called = function(run) return run:mean "S11" end } })
a:vtk("all")
a:vtk("some", { fields = { "E12", "S11", "S22", "slack2", "shear_angle", "ux", "tension_warp" } })
a:solve()
local seen = {}
local touching = { gap = true, contact_pressure = true } -- of runs with contact: see contact.lua
for _, field in ipairs(registry.fields()) do
  if touching[field.name] then goto next end
  assert(field.sentence ~= "" and not seen[field.name])
  seen[field.name] = true
  local items = field.place == "node" and #mesh.nodes or #mesh.elements
  local whole = a:field(field.name)
  assert(#whole == items, field.name)
  for c, name in ipairs(field.components) do
    assert(name == field.name or not seen[name])
    seen[name] = true
    local values, sum = a:field(name), 0
    for i, value in ipairs(values) do
      assert(value == value and (field.shape == "number" and whole[i] or whole[i][c]) == value)
      assert(a[field.place == "node" and "node" or "element"](a, i)[name] == value)
      sum = sum + value
    end
    assert(a:mean(name) == sum / items)
  end
  ::next::
end
for _, name in ipairs { "E12", "S11", "slack1", "residual2", "stored", "ux", "vy", "nz", "tension_weft", "E", "S", "slack" } do assert(seen[name], name) end

-- The tension of the pulled yarns is what the grips hold, over the width.
local _, force = a:reaction "top"
fabric.expect {
  { "tension along the pull, N/m", a:mean "tension_warp", force / width, relative = 1e-9 },
  { "shear angle of a straight pull", a:mean "shear_angle", 0, absolute = 1e-9 },
  { "displacement of the moved edge, m", a:mean("uy", "top"), 0.01, relative = 1e-12 },
}

-- Simple shear by x = X + g Y. The warp lies along y, the weft along -x: the angle between them opens by atan(g).
local sheared = strip({ x = fabric.ramp(0.2 * height, 1), y = fabric.ramp(0, 1) }, 1, 1)
sheared:solve()
fabric.expect { { "shear angle, degrees", sheared:mean "shear_angle", -math.deg(math.atan(0.2)), relative = 1e-9 } }
assert(sheared:mean "E12" < 0)

-- The table's columns by name are the means.
local column = {}
for _, one in ipairs(fabric.table { file = "table.csv" }) do column[one.name] = one.values end
assert(#column.mean == steps + 1 and #column.part == steps + 1)
for i, value in ipairs(column.mean) do assert(value == column.called[i]) end
assert(math.abs(column.edge[steps + 1] - 0.01) < 1e-15)
assert(column.part[steps + 1] == a:mean "E11" and column.angle[steps + 1] == a:mean "shear_angle")

-- Files: whole fields as ever, chosen numbers in the array of their field.
local function arrays(path)
  local file <close> = assert(io.open(path, "rb"))
  local found = {}
  for tag in file:read "a":gmatch "<DataArray[^>]*>" do
    local name = tag:match 'Name="([^"]*)"'
    found[name] = { n = tonumber(tag:match 'NumberOfComponents="(%d+)"') or 1, words = {} }
    for word in tag:gmatch 'ComponentName%d="([^"]*)"' do table.insert(found[name].words, word) end
  end
  return found
end
local all, some = arrays "all_00004.vtu", arrays "some_00004.vtu"
local function is(found, name, n, words) return found[name] and found[name].n == n and table.concat(found[name].words, " ") == words end
assert(is(all, "E", 6, "E11 E22 E33 E12 E23 E13") and is(all, "S", 6, "S11 S22 S33 S12 S23 S13") and is(all, "slack", 2, "warp weft") and is(all, "energy", 2, "stored dissipated"))
assert(all.displacement and all.director and all.warp and all.weft and all.reference and all.reaction)
assert(all.top and all.corners and not all.all and not all.velocity and not all.shear_angle and not all.position)
assert(is(some, "E", 1, "E12") and is(some, "S", 2, "S11 S22") and is(some, "slack", 1, "weft") and is(some, "displacement", 3, ""))
assert(is(some, "reference", 3, "") and not some.reaction and some.top)
assert(is(some, "shear_angle", 1, "") and is(some, "tension_warp", 1, "") and not some.director and not some.residual)

-- Wrong names.
local function refused(words, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end
refused("vtk: field 'fields': unknown field 'shear_angel', did you mean 'shear_angle'?", a.vtk, a, "wrong", { fields = { "E", "shear_angel" } })
refused("record: field 'options.columns.x': unknown field 'S111'", a.record, a, "wrong.csv", { columns = { x = "S111" } })
refused("field 'options.columns.x': expected a field's name or {name, set}, got nil at place 2", a.record, a, "wrong.csv", { columns = { x = { "S11" } } })
-- ... columns that could never be read are refused before the run
refused("record: field 'options.columns.g': mean: nothing touches in this model, which the field 'gap' is of: expected m:contact{...} before the run", a.record, a,
  "wrong.csv", { columns = { g = "gap" } })
refused("record: field 'options.columns.S': mean: set 'top' holds no whole element", a.record, a, "wrong.csv", { columns = { S = { "S11", "top" } } })
refused("record: field 'options.columns.S': unknown set 'tip'", a.record, a, "wrong.csv", { columns = { S = { "S11", "tip" } } })
refused("mean: nothing touches in this model, which the field 'contact_pressure' is of", a.mean, a, "contact_pressure")
refused("did you mean 'S11'?", a.field, a, "S1")

-- Help knows them.
local heard = {}
local print_ = print
print = function(text) heard[#heard + 1] = text end
fabric.help "tension_warp"
fabric.help "S12"
print = print_
assert(heard[1]:find("tension_warp: a field of a run, number of every element, N/m", 1, true), heard[1])
assert(heard[2]:find("S: a field of a run, symmetric tensor of every element, Pa: S11 S22 S23 S13 S12", 1, true), heard[2])
