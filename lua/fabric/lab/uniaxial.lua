-- fabric.lab.uniaxial: a strip pulled along y and let go again, the test of [williams2010, sections 3.3 and 7.2].
--
--          top: moved up            warp at 90 - angle degrees from x, so that the pull is `angle`
--        +--+--+--+                 away from the warp (weft: 90)
--        |  |  |  |
--        +--+--+--+                 S = force / (width thickness stretch), E = e + e^2/2  (eqs. 3.1, 3.2)
--        |  |  |  |
--        +--+--+--+
--          bottom: held
local fabric = require "fabric"
local define = require "fabric.define"
local u = fabric.units

local function angle_of(direction)
  if direction == "warp" then return 0 end
  if direction == "weft" then return 90 end
  return direction
end

-- Displacement up to which the card was measured along the direction; an error when it says none.
local function tested_displacement(t, angle)
  local axis = angle == 0 and "warp" or angle == 90 and "weft"
  local strain = axis and t.card.tested and t.card.tested[axis] or 0
  if strain == 0 then
    define.fail("uniaxial: field 'displacement': expected a positive number in m (the card states no tested strain here), got nil")
  end
  return t.length * (math.sqrt(1 + 2 * strain) - 1)
end

local function hold(t, mesh, model)
  model:fix("all", "z rotation")
  model:fix("bottom", "y")
  if t.grips == "clamped" then
    model:fix("bottom", "x")
    model:fix("top", "x")
  else
    mesh:set("held", { 1 }) -- one point stops the rigid motion; the ends are free to contract
    model:fix("held", "x")
  end
end

-- Strain across the pull, from the averages over the strip.
local function lateral_strain(a, angle)
  local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
  if angle == 90 then c, s = 0, 1 end
  return a:mean "E11" * s * s + a:mean "E22" * c * c - 2 * a:mean "E12" * s * c
end

-- What the grips show at the analysis' present time.
local function reading(a, t, mesh, angle)
  local _, force = a:reaction "top"
  local displacement = a:node(#mesh.nodes).uy
  local e = displacement / t.length
  return {
    time = a.time,
    displacement = displacement,
    force = force,
    E = e + e * e / 2,
    S = force / (t.width * t.thickness * (1 + e)),
    E_lateral = lateral_strain(a, angle),
  }
end

local quantities = { "displacement", "force", "E", "S", "E_lateral" }

-- Keeps every step in `curve`, and in curve.csv and a VTK series when there is a folder for them.
local function observe(a, t, mesh, angle, curve)
  local latest
  local function now()
    if not latest or latest.time ~= a.time then latest = reading(a, t, mesh, angle) end
    return latest
  end
  a:every("step", function() curve[#curve + 1] = now() end)
  if not t.out then return end
  local columns = {}
  for _, name in ipairs(quantities) do
    columns[name] = function() return now()[name] end
  end
  a:record(t.out .. "/curve.csv", { columns = columns, order = quantities })
  a:vtk(t.out .. "/strip")
end

local function run(t)
  local angle = angle_of(t.direction)
  t.thickness = t.thickness or t.card.thickness
  t.displacement = t.displacement or tested_displacement(t, angle)
  local nx, ny = table.unpack(t.cells or { 3, 9 })
  local mesh = fabric.mesh.rectangle { width = t.width, height = t.length, nx = nx, ny = ny }
  local model = fabric.model { mesh = mesh, card = t.card, thickness = t.thickness, warp = 90 - angle }
  hold(t, mesh, model)
  local pull = t.unload and { { 0, 0 }, { 1, t.displacement }, { 2, 0 } } or { { 0, 0 }, { 1, t.displacement } }
  model:move("top", { y = fabric.history(pull) })
  local duration = t.unload and 2 or 1
  local a = fabric.static { model = model, duration = duration, step = duration / t.steps }
  local curve = {}
  observe(a, t, mesh, angle, curve)
  a:event {
    value = function() return select(2, a:reaction "top") end,
    tolerance = t.release,
    action = function() a:stop "the grip lets go" end,
  }
  a:solve()
  return { curve = curve, analysis = a, model = model, mesh = mesh, displacement = t.displacement,
           volume = t.width * t.length * t.thickness }
end

define {
  name = "fabric.lab.uniaxial",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "direction", kind = "number|text", unit = "degrees", choices = { "warp", "weft" }, default = "warp",
      sentence = "of the pull: warp, weft, or its angle from the warp" },
    { name = "displacement", kind = "number", unit = "m", above = 0, optional = true,
      sentence = "largest displacement; default: up to where the card was tested" },
    { name = "grips", kind = "text", choices = { "clamped", "free" }, default = "clamped",
      sentence = "clamped ends keep their width, free ends contract" },
    { name = "cells", kind = "numbers", low = 1, optional = true, sentence = "{across, along}; default {3, 9}" },
    { name = "steps", kind = "integer", low = 2, default = 80, sentence = "for the whole history" },
    { name = "unload", kind = "boolean", default = true, sentence = "back until the force is zero" },
    { name = "release", kind = "number", above = 0, default = 1e-6, sentence = "that zero, over the largest force" },
    { name = "width", kind = "number", unit = "m", above = 0, default = 25.4 * u.mm, sentence = "of the strip" },
    { name = "length", kind = "number", unit = "m", above = 0, default = 76.2 * u.mm, sentence = "between the grips" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: the card's" },
    { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv and the VTK series strip.pvd" },
  },
  sentence = "A strip pulled and let go. Returns curve (a list of time, displacement, force, E, S, E_lateral), analysis, model, "
    .. "mesh, displacement and volume.",
  example = "local fabric = require 'fabric'\n"
    .. "local test = fabric.lab.uniaxial{ card=fabric.card 'denim', grips='free', steps=8 }\n"
    .. "assert(test.analysis.stopped == 'the grip lets go')",
  run = run,
}
