-- Relaxation: yarns that unload far more stiffly than they load; "either" in front of a load that jumps; fields without effect are told.
local fabric = require "fabric"
local checks = {}
local function check(name, got, wanted, more)
  checks[#checks + 1] = { name, got, wanted, relative = more.relative, absolute = more.absolute }
end
local function below(name, got, bound) check(("%s: %g, less than %g (1: yes)"):format(name, got, bound), got < bound and 1 or 0, 1, { absolute = 0 }) end

-- The warp of 'wool' unloads 165 times as stiffly as it loads. Shortened steps take 130 iterations a share; steps that only become more viscous never end.
do
  local r = fabric.lab.cusick { card = fabric.card "wool", cells = 3, steps = 2, by = "relaxation", contact = false }
  for i, step in ipairs(r.analysis.steps) do
    below(("wool, share %d: iterations"):format(i), step.iterations, 1000)
    below(("wool, share %d: residual"):format(i), step.residuals[#step.residuals], 1e-4)
  end
end

-- A ring whose weight comes at once in the middle of the run: a shorter step has no less of it. "either" leaves it to relaxation after three halvings, and
-- does not halve the way there again and again.
do
  local function hung(method)
    local card = fabric.card("blend"):with { bending = { warp = 15e-6, weft = 15e-6, twist = 7e-6 } }
    local mesh = fabric.mesh.annulus { inner = 0.09, outer = 0.15, around = 28, across = 3 }
    mesh:map(function(x, y, z)
      local r = math.sqrt(x * x + y * y)
      return x, y, z + 1e-3 * ((r - 0.09) / 0.06) ^ 2 * math.cos(7 * math.atan(y, x))
    end)
    local model = fabric.model { mesh = mesh, card = card, warp = 0 }
    model:fix("inner", "x y z rotation"):gravity { 0, 0, function(t) return t > 0.1 and -9.81 or 0 end }
    local a = fabric.static { model = model, duration = 0.3, step = 0.03, method = method, tolerance = 1e-6 }:solve()
    local sunk = 0
    for _, n in ipairs(mesh:set "outer") do sunk = sunk - a:node(n).uz / #mesh:set "outer" end
    return a, sunk
  end
  local relaxed, relaxed_sunk = hung "relaxation"
  local either, either_sunk = hung "either"
  below("either: steps", #either.steps, 16)
  -- 1e-4: both stop at a residual of 1e-6 in a shape that is ten thousand times as soft as its yarns
  check("either: as relaxation, energy", either.energy.stored, relaxed.energy.stored, { relative = 1e-4 })
  check("either: as relaxation, the rim", either_sunk, relaxed_sunk, { relative = 1e-4 })
end

-- Loads that are there at time 0 and others that come later: dynamic relaxation does not get through the jump, the overdamped motion does, in later steps too.
do
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.06, nx = 6, ny = 6 }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "thickness" }), warp = 0 }
  m:fix("left", "x y z rotation"):gravity { 0, 0, -9.81 }:force("right", { x = fabric.history { { 0, 1e-4 }, { 1, 10 } } })
  local a = fabric.static { model = m, duration = 1, step = 0.25, method = "relaxation" }:solve()
  assert(#a.steps == 4, #a.steps)
end

-- A strip pinned along one edge, whose weight turns it: Newton's method has no first step from the flat sheet, and the run goes by itself to where it hangs.
for _, ramped in ipairs { false, true } do
  for _, triangles in ipairs { false, true } do
    local card = fabric.card("blend", { bending = "estimated" })
    local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.05, nx = 8, ny = 2, triangles = triangles }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }
    m:fix("left", "x y z"):gravity { 0, 0, ramped and fabric.ramp(-9.81, 1) or -9.81 }
    local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
    local corner = a:node(#mesh.nodes)
    check("a pinned strip hangs", corner.z, -0.2, { relative = 1e-3 })
    check("below its edge", corner.x, 0, { absolute = 1e-6 })
  end
end

-- Options without effect are reported, in one line a reason; values that are the usual ones are not.
do
  local function talk_of(deck)
    local file = assert(io.open("idle.lua", "w"))
    file:write([[
local fabric = require "fabric"
local card = fabric.svk { name = "sheet", young = 5e6, poisson = 0, density = 500, thickness = 0.3e-3, bending = { warp = 4e-3, weft = 4e-3, twist = 2e-3 } }
]] .. deck)
    file:close()
    local pipe = assert(io.popen(("'%s' idle.lua 2>&1"):format(arg[-1])))
    local talk = pipe:read "a"
    assert(pipe:close(), talk)
    return talk
  end
  local function told(name, deck, words, not_told)
    local talk = talk_of(deck)
    check(name .. " (1: yes)", talk:find(words, 1, true) and not (not_told and talk:find(not_told, 1, true)) and 1 or 0, 1, { absolute = 0 })
  end
  local disc = "fabric.lab.cusick{ card=card, cells=3, around=24, contact=false, by='relaxation', steps=1, "
  told("cusick says what relaxation does not use", disc .. "lowering=0.3, damping=5, window=0.2 }",
    'cusick: lowering, window: no effect with by = "relaxation", which knows no time', "damping")
  told("cusick says what does nothing without contact", disc .. "edge=0.06, friction=0.2, side=0.1 }",
    "cusick: edge, side, friction: no effect with contact = false")
  told("cusick says that one seed is not shared out", disc .. "processes=2 }", "cusick: processes: no effect with one seed")
  told("a duration that has no effect is not checked", disc .. "duration=0.5 } print 'done'", "done", "expected more than")
  told("but told", disc .. "duration=0.5 }", 'cusick: duration: no effect with by = "relaxation"')
  told("cusick says nothing without cause", disc .. "lowering=1.5 } print 'done'", "done", "no effect")
  local strip = "local model = fabric.model{ mesh=fabric.mesh.rectangle{ width=0.02, height=0.02, nx=1, ny=1 }, card=card, warp=0 }:fix('bottom', 'x y z rotation')\n"
    .. "fabric.static{ model=model, duration=1, step=1, "
  told("static says that relaxation has no max_iterations", strip .. "method='relaxation', max_iterations=9 }:solve()",
    "static: field 'max_iterations': no effect with method \"relaxation\"")
  told("and Newton's method has", strip .. "max_iterations=9 }:solve() print 'done'", "done", "no effect")
end

fabric.expect(checks)

-- --- after a first step that was relaxed, the cloth is at rest under constant loads: the steps stay whole ---
do
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.01, nx = 6, ny = 1 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 0 }:fix("left", "x y z rotation"):gravity { 0, 0, -9.81 }
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  assert(#a.steps == 4, #a.steps)
end

-- --- loads that are there at time 0 strain the cloth no less in a shorter step: limit="stop" ends with the step as planned ---
do
  local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.05, nx = 4, ny = 4 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 0 }:fix("left", "x y z"):fix("all", "z"):force("right", { x = 1000 })
  local a = fabric.static { model = m, duration = 1, step = 0.25, limit = "stop" }:solve()
  assert(a.time == 0.25, a.time)
end
