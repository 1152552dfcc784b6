-- Motion from a start that has strain: energies, agreement of the schemes, snapshots, a run that goes on from it, and one that is
-- killed and restarted.
local fabric = require "fabric"
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end
local beside = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))

-- A strip cut 3 % too short is let go at one end, and springs back along its length.
local thickness, E = 0.5e-3, 4e6
local card = fabric.svk { density = 500, thickness = thickness, warp = E, weft = E, shear = 1.5e6, poisson = 0 }
local function strip(length, tri) return fabric.mesh.rectangle { width = length, height = 0.02, nx = 10, ny = 2, triangles = tri } end
local function model(tri)
  return fabric.model { mesh = strip(0.1, tri), card = card, reference = strip(0.097, tri) }:fix("all", "z rotation"):fix("left", "x y")
end
local strain = ((0.1 / 0.097) ^ 2 - 1) / 2
local energy = E * strain ^ 2 / 2 * thickness * 0.097 * 0.02
local period = 4 * 0.097 / math.sqrt(E / 500) -- of the slowest wave along it

for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  local ends = {}
  for _, scheme in ipairs { "implicit", "explicit" } do
    local a = fabric.dynamic { model = model(tri), duration = period / 2, scheme = scheme, step = scheme == "implicit" and period / 400 or "auto" }
    -- The strain across is that of the place: 0 in y, so the energy is that of warp and of nothing else.
    check("stored at the start, " .. scheme .. of, a.energy.stored, energy, 1e-9)
    check("work at the start, " .. scheme .. of, 1 + a.energy.external, 1, 0)
    local half
    a:advance(period / 4)
    half = a:snapshot()
    a:solve()
    local tip = a:node(33).x
    check("energy, " .. scheme .. of, a.energy.kinetic + a.energy.stored, energy, scheme == "implicit" and 1e-3 or 0.015)
    check("half a period, " .. scheme .. of, tip, 0.094, 0.005)
    a:restore(half)
    a:solve()
    check("the same bits from a snapshot, " .. scheme .. of, a:node(33).x, tip, 0)
    ends[scheme] = tip
    if scheme == "implicit" then
      local onward = fabric.dynamic { from = a, duration = period / 2, scheme = "implicit", step = period / 400 }:solve()
      check("a run that goes on" .. of, onward:node(33).x, 0.1, 0.005)
    end
  end
  check("explicit as implicit" .. of, ends.explicit, ends.implicit, 2e-3)
  -- Statics of the same finds the length without stress.
  local still = fabric.static { model = model(tri), duration = 1, step = 0.5 }:solve()
  check("at rest" .. of, still:node(33).x, 0.097, 1e-9)
  check("energy at rest" .. of, 1 + still.energy.stored / energy, 1, 1e-9)
end

-- A sheet with prestress in motion is killed and restarted: the same bytes.
local deck = [[
local fabric = require "fabric"
local steps = 0
local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.05, nx = 4, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 20, prestress = { warp = 300, weft = 150 } }
m:crease { line = { { 0.03, 0, 0 }, { 0.03, 0.05, 0 } }, angle = 30 }:fix("left", "x y z rotation"):fix("top", "z")
local a = fabric.dynamic { model = m, duration = 2e-4, scheme = SCHEME, step = SCHEME == "implicit" and 1e-5 or "auto" }
a:every("step", function()
  steps = steps + 1
  if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
end)
a:record("work/run.csv", { columns = { z = function(run) return run:node(10).z end, e = function(run) return run.energy.stored end } })
a:checkpoint("work/run.ckpt", { every = "step" }):solve()
fabric.write("work/said.txt", ("%.17g %.17g"):format(a.energy.stored, a.energy.error))
]]
for _, scheme in ipairs { "implicit", "explicit" } do
  fabric.write("taut.lua", (deck:gsub("SCHEME", "'" .. scheme .. "'")))
  local wanted = beside.whole "taut.lua"
  check("energies of the whole, " .. scheme, 1 + tonumber(wanted["said.txt"]:match " (%S+)"), 1, 2e-2)
  local got = beside.restarted("taut.lua", 7, "run.ckpt")
  for file, bytes in pairs(wanted) do check(file .. ", restarted, " .. scheme, got[file] == bytes and 1 or 0, 1, 0) end
end
fabric.expect(checks)
