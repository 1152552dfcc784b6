-- Means over windows in implicit motion: each step has one force of a body, in records as in a:reaction(body, { window= }).
local fabric = require "fabric"
local card = fabric.card("denim", { bending = "estimated" })
local side, name = 0.06, os.tmpname()
os.remove(name)

-- A sheet is pressed on a plane, up to 500 Pa in 50 ms, and by nothing else: its forces are those of the pressure.
local function pressed(options, restored)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = 2, ny = 2, origin = { 0, 0, card.thickness / 2 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local plane = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:contact { between = { plane, "all" } }:pressure(function(t) return -500 * math.min(1, t / 0.05) end)
  local o = { model = m, duration = 0.08, scheme = "implicit" }
  for key, value in pairs(options) do o[key] = value end
  local a = fabric.dynamic(o)
  local function force(r) return select(3, r:reaction(plane)) / side ^ 2 end
  local calls = 0
  local columns = {
    own = function(r) return select(3, r:reaction(plane, { window = 0.02 })) / side ^ 2 end,
    column = { force, window = 0.02 },
    both = { function(r) return 3 * force(r) + 1e3 * r.time end, window = 0.02 }, -- with what goes straight from end to end
    time = { function(r) calls = calls + 1 return r.time end, window = 0.02 },
  }
  a:record(name, { every = 0.02, columns = columns, order = { "own", "column", "both", "time" } })
  a:advance(0.03)
  if restored then a:restore(a:snapshot()) end
  a:solve()
  assert(calls == #a.steps + 1, "called once a step, where no force of a body is asked for")
  local rows, file = {}, io.open(name)
  local text = file:read "a"
  file:close()
  for line in text:gmatch "[^\n]+" do
    local row = {}
    for cell in line:gmatch "[^,]+" do row[#row + 1] = tonumber(cell) end
    if #row == 5 then rows[#rows + 1] = row end
  end
  os.remove(name)
  assert(#rows == 5)
  for i = 2, #rows do
    local t, own, column, both, time = table.unpack(rows[i])
    local mean = 0
    for k = 1, 1000 do mean = mean + 500 * math.min(1, (t - 0.02 + (k - 0.5) * 2e-5) / 0.05) / 1000 end
    fabric.expect {
      { ("%g s: mean pressure"):format(t), column, mean, relative = 0.05 }, -- the rule has it within the step at the kink
      { "as the reaction has it", column, own, relative = 1e-12 },
      { "in a sum", both, 3 * own + 1e3 * time, relative = 1e-9 },
      { "time", time, t - 0.01, relative = 1e-9 },
    }
  end
  return text
end
for _, options in ipairs { { step = 1e-2 }, { step = 5e-3 }, { step = 1e-2, slow = true }, { step = 1e-2, spectral_radius = 0.4 }, { step = 1e-2, spectral_radius = 1 } } do
  local text = pressed(options)
  assert(pressed(options, true) == text)
end
