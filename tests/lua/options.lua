-- Options that are given with their defaults change no bit of a result; an implicit run without line search ends where one with it does.
local fabric = require "fabric"

local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.08, nx = 2, ny = 3 }
local function model()
  return fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), warp = 90 }
    :fix("bottom", "x y z rotation"):force("top", { y = fabric.ramp(0.4, 0.01), z = fabric.ramp(0.002, 0.01) }):pressure(fabric.ramp(2, 0.01))
end

local function ends(call, options)
  options.model, options.duration = model(), 0.01
  local a = call(options):solve()
  local top = a:node(#mesh.nodes)
  return ("%a %a %a %a"):format(top.ux, top.uy, top.uz, a.energy.stored), top.uz
end

local static, plain = fabric.static, ends(fabric.static, {})
local given = ends(static, { step = 0.01 / 20, tolerance = 1e-10, max_iterations = 200, max_cuts = 12, line_search = true,
  ledger_limit = 0.05, linear = "auto", control = "load", method = "auto", limit = "tell", stabilise = false })
local coarse = ends(static, { step = 0.005 })

local motion = fabric.dynamic
local moved = ends(motion, { scheme = "implicit", step = 5e-4 })
local as_default = ends(motion, { scheme = "implicit", step = 5e-4, slow = false, linear = "auto", force = false, ledger_limit = 0.05,
  tolerance = 1e-8, max_iterations = 30, max_cuts = 12, line_search = true, limit = "tell", damping = {} })
local explicit = ends(motion, {})
local auto = ends(motion, { step = "auto", scheme = "explicit", inertia = "scaled" })
local _, searched = ends(motion, { scheme = "implicit", step = 5e-4, slow = true })
local _, unsearched = ends(motion, { scheme = "implicit", step = 5e-4, slow = true, line_search = false })

local function same(a, b) return a == b and 1 or 0 end

fabric.expect {
  { "static, with its defaults", same(given, plain), 1, absolute = 1e-12 },
  { "static, in two steps", same(coarse, plain), 0, absolute = 1e-12 },
  { "implicit, with its defaults", same(as_default, moved), 1, absolute = 1e-12 },
  { "explicit, with its defaults", same(auto, explicit), 1, absolute = 1e-12 },
  -- Without line search other steps fail and are cut, and Euler's backward rule damps longer steps more.
  { "without line search, another way", unsearched == searched and 1 or 0, 0, absolute = 1e-12 },
  { "to the same place", unsearched, searched, relative = 0.01 },
}
