-- fabric.lab.biaxial: a square pulled along warp and weft at once and unloaded [williams2010, section 7.3.1].
--
--            ^ top                  Edges stay straight and slide along themselves, so that the strain is uniform:
--      +--+--+--+                   E = d / size + (d / size)^2 / 2 with d the distance that a pair of edges parts,
--    <-|  |  |  |-> right           S = force / (size thickness stretch) on each axis. Warp along x.
--      +--+--+--+
local fabric = require "fabric"
local sheet = require "fabric.lab.virtual.sheet"
local define = require "fabric.define"
local mesh_error = require "fabric.lab.virtual.mesh_error"
local u = fabric.units

local columns = { "displacement", "E11", "E22", "S11", "S22", "S11_average", "S22_average", "S11_centre", "S22_centre", "force_x", "force_y" }

local function reading(a, t, last, centre)
  local corner, first = a:node(last), a:node(1)
  local x, _, _ = a:reaction "right"
  local _, y = a:reaction "top"
  local dx, dy = corner.ux - first.ux, corner.uy - first.uy
  local e1, e2 = dx / t.size, dy / t.size
  local area = t.size * t.thickness
  local S, Sc = sheet.mean(a, "S"), sheet.mean(a, "S", centre)
  return { displacement = math.abs(dx) > math.abs(dy) and dx or dy, E11 = e1 + e1 * e1 / 2, E22 = e2 + e2 * e2 / 2,
           S11 = x / (area * (1 + e1)), S22 = y / (area * (1 + e2)), force_x = x, force_y = y,
           S11_average = S[1], S22_average = S[2], S11_centre = Sc[1], S22_centre = Sc[2] }
end

local function scaled(points, factor)
  local out = {}
  for i, p in ipairs(points) do out[i] = { p[1], p[2] * factor } end
  return fabric.history(out)
end

local function numbers(result)
  local peak = sheet.peak(result.curve, "displacement")
  return { S11 = peak.S11, S22 = peak.S22, S11_average = peak.S11_average, S11_centre = peak.S11_centre,
           dissipated = result.analysis.energy.dissipated }
end

local function build(t, points)
  local mesh = fabric.mesh.rectangle { width = t.size, height = t.size, nx = t.cells, ny = t.cells }
  local model = fabric.model { mesh = mesh, card = t.card, thickness = t.thickness, warp = 0 }
  model:fix("all", "z rotation")
  local half = { left = { "x", -0.5 }, right = { "x", 0.5 }, bottom = { "y", -0.5 * t.ratio }, top = { "y", 0.5 * t.ratio } }
  for set, motion in pairs(half) do model:move(set, { [motion[1]] = scaled(points, motion[2]) }) end
  return mesh, model
end

local function run(t)
  t.thickness = t.thickness or t.card.thickness
  local points, duration = sheet.history(t.path or { 1, 0 }, t.displacement)
  local mesh, model = build(t, points)
  local a = fabric.static { model = model, duration = duration, step = duration / t.steps }
  local centre, last = sheet.centre(mesh), #mesh.nodes
  local curve = sheet.observe(a, columns, t.out, "square", function(run_) return reading(run_, t, last, centre) end)
  for i, set in ipairs { "right", "top" } do
    if i == 1 or t.ratio > 0 then
      a:event { value = function() return (select(i, a:reaction(set))) end, tolerance = t.release,
                action = function() a:stop("the " .. (i == 1 and "warp" or "weft") .. " has no pull left") end }
    end
  end
  a:solve()
  local result = { curve = curve, analysis = a, model = model, mesh = mesh, peak = sheet.peak(curve, "displacement"),
                   volume = t.size ^ 2 * t.thickness }
  result.mesh_error = mesh_error(result, t, run, numbers)
  return result
end

define {
  name = "fabric.lab.biaxial",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "displacement", kind = "number", unit = "m", above = 0, default = 30 * u.mm, sentence = "by which left and right edges move apart" },
    { name = "ratio", kind = "number", low = 0, default = 1, sentence = "displacement of bottom and top over that of left and right" },
    { name = "path", kind = "numbers", optional = true, sentence = "displacements visited in turn, as parts of the largest; default {1, 0}" },
    { name = "release", kind = "number", above = 0, default = 1e-6, sentence = "the test ends at this force, over the largest" },
    { name = "cells", kind = "integer", low = 1, default = 3, sentence = "along an edge" },
    { name = "steps", kind = "integer", low = 2, default = 80, sentence = "for the whole history" },
    { name = "size", kind = "number", unit = "m", above = 0, default = 254 * u.mm, sentence = "of the square" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: the card's" },
    { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv and the VTK series square.pvd" },
  },
  sentence = "A square pulled along both yarns and let go until one has no pull left. Returns curve (a list of time, displacement, E11, "
    .. "E22, S11, S22 from the forces, and both as _average and _centre, force_x, force_y), peak (its row of largest displacement), "
    .. "analysis, model, mesh, volume, and the method mesh_error().",
  example = "local test = fabric.lab.biaxial{ card=fabric.card 'denim', steps=8 }\n"
    .. "assert(math.abs(test.peak.S11 / test.peak.S11_average - 1) < 1e-8)",
  run = run,
}
