-- fabric.lab.shear: a square in cyclic simple shear [williams2010, section 7.2.2, figs. 7-27, 7-28].
--
--      +--+--+--+  -> gamma = 2 E12     x = X + gamma Y, so E12 = gamma / 2 and also E22 = gamma^2 / 2.
--      |  |  |  |                       Warp along x. First Piola-Kirchhoff stress on the top edge:
--      +--+--+--+                       P_xY = S12 + gamma S22, P_yY = S22, so that the grips show
--      |  |  |  |                       S12 = (force_x - gamma force_y) / area.
--      +--+--+--+
local fabric = require "fabric"
local define = require "fabric.define"
local sheet = require "fabric.lab.virtual.sheet"
local mesh_error = require "fabric.lab.virtual.mesh_error"
local u = fabric.units

local columns = { "E12", "force_x", "force_y", "S12", "S12_average", "S12_centre", "S22_average", "S_uncorrected" }

local function reading(a, t, last, centre)
  local x, y = a:reaction "top"
  local gamma, area = a:node(last).ux / t.size, t.size * t.thickness
  local S = sheet.mean(a, "S")
  return { E12 = gamma / 2, force_x = x, force_y = y, S12 = (x - gamma * y) / area, S_uncorrected = x / area,
           S12_average = S[3], S22_average = S[2], S12_centre = sheet.mean(a, "S", centre)[3] }
end

-- Moves the nodes held at the edges, each in proportion to its height.
local function drive(t, n, mesh, model, points)
  model:fix("all", "z rotation")
  model:fix("bottom", "x y")
  for row = 1, n do
    local ids, first, last = {}, row * (n + 1) + 1, (row + 1) * (n + 1)
    if row == n then
      for i = first, last do ids[#ids + 1] = i end
    else
      ids = { first, last }
    end
    if row == n or t.sides == "driven" then
      local name, own = "row " .. row, {}
      for i, p in ipairs(points) do own[i] = { p[1], p[2] * row / n } end
      mesh:set(name, ids)
      model:fix(name, "y")
      model:move(name, { x = fabric.history(own) })
    end
  end
end

local function numbers(result)
  local peak = sheet.peak(result.curve, "E12")
  return { S12 = peak.S12, S12_average = peak.S12_average, S12_centre = peak.S12_centre, dissipated = result.analysis.energy.dissipated }
end

local function run(t)
  t.thickness = t.thickness or t.card.thickness
  t.E12 = t.E12 or (t.card.tested and t.card.tested.shear)
  if not t.E12 or t.E12 <= 0 then
    define.fail("shear: field 'E12': expected a positive number (the card states no tested shear), got " .. tostring(t.E12))
  end
  local points, duration = sheet.history(t.path or { 1, -1, 1 }, 2 * t.E12 * t.size)
  local mesh = fabric.mesh.rectangle { width = t.size, height = t.size, nx = t.cells, ny = t.cells }
  local model = fabric.model { mesh = mesh, card = t.card, thickness = t.thickness, warp = 0 }
  drive(t, t.cells, mesh, model, points)
  local a = fabric.static { model = model, duration = duration, step = duration / t.steps }
  local centre, last = sheet.centre(mesh), #mesh.nodes
  local curve = sheet.observe(a, columns, t.out, "square", function(run_) return reading(run_, t, last, centre) end)
  a:solve()
  local result = { curve = curve, analysis = a, model = model, mesh = mesh, E12 = t.E12, volume = t.size ^ 2 * t.thickness }
  result.mesh_error = mesh_error(result, t, run, numbers)
  return result
end

define {
  name = "fabric.lab.shear",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "E12", kind = "number", above = 0, optional = true, sentence = "largest shear strain (tensor); default: up to where the card was tested" },
    { name = "path", kind = "numbers", optional = true, sentence = "strains visited in turn, as parts of the largest; default {1, -1, 1}" },
    { name = "sides", kind = "text", choices = { "driven", "free" }, default = "driven",
      sentence = "driven: all four edges move, the shear is uniform; free: bottom and top alone" },
    { name = "cells", kind = "integer", low = 1, default = 3, sentence = "along an edge" },
    { name = "steps", kind = "integer", low = 2, default = 90, sentence = "for the whole history" },
    { name = "size", kind = "number", unit = "m", above = 0, default = 25.4 * u.mm, sentence = "of the square" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: the card's" },
    { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv and the VTK series square.pvd" },
  },
  sentence = "A square in cyclic simple shear, warp along the shear. Returns curve (a list of time, E12, force_x, force_y, S12 from the "
    .. "forces, S12_average, S12_centre, S22_average, S_uncorrected = force_x over area), analysis, model, mesh, E12, volume, and the "
    .. "method mesh_error().",
  example = "local test = fabric.lab.shear{ card=fabric.card 'blend', E12=0.2, steps=12 }\n"
    .. "assert(math.abs(test.curve[#test.curve].S12 / test.curve[#test.curve].S12_average - 1) < 1e-8)",
  run = run,
}
