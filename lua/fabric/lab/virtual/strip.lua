-- The strip of the tensile and bias tests [williams2010, sections 3.3 and 7.2]: pulled along y and unloaded.
--
--          top: moved up            warp at 90 - angle degrees from x, so that the pull is `angle`
--        +--+--+--+                 away from the warp (weft: 90)
--        |  |  |  |
--        +--+--+--+                 S = force / (width thickness stretch), E = e + e^2/2  (eqs. 3.1, 3.2)
--        |  |  |  |
--        +--+--+--+
--          bottom: held
local fabric = require "fabric"
local sheet = require "fabric.lab.virtual.sheet"
local mesh_error = require "fabric.lab.virtual.mesh_error"
local u = fabric.units
local strip = {}

-- Conditions common to all grips: the motion of the ends along y, lateral support, the plane.
local function hold(t, mesh, model)
  local ends = { "bottom", "top" }
  if t.out_of_plane == "held" then
    model:fix("all", "z rotation")
  else
    for _, set in ipairs(ends) do model:fix(set, "z rotation") end
  end
  model:fix("bottom", "y")
  if type(t.grips) == "table" then
    for _, set in ipairs(ends) do model:spring(set, { x = t.grips.lateral * t.width }) end
  elseif t.grips == "clamped" then
    for _, set in ipairs(ends) do model:fix(set, "x") end
  else
    mesh:set("held", { 1 }) -- a single held point prevents rigid motion; the ends can contract freely
    model:fix("held", "x")
  end
end

-- Zones of a bias test [williams2010, fig. 3-52], from the yarns through each element's centre: 1 both yarns end in the same
-- grip, 3 neither ends in a grip, 2 all others. Each is a list of element numbers.
function strip.zones(t, places)
  local zones = { {}, {}, {} }
  local warp = math.rad(90 - t.angle)
  local function grips_of(p, direction)
    local bottom, top = false, false
    for _, sign in ipairs { 1, -1 } do
      local dx, dy = sign * math.cos(direction), sign * math.sin(direction)
      local sx = dx > 0 and (t.width - p[1]) / dx or dx < 0 and -p[1] / dx or math.huge
      local sy = dy > 0 and (t.length - p[2]) / dy or dy < 0 and -p[2] / dy or math.huge
      if sy < sx * (1 - 1e-9) then
        if dy > 0 then top = true else bottom = true end
      end
    end
    return bottom, top
  end
  for i, p in ipairs(places) do
    local b1, t1 = grips_of(p, warp)
    local b2, t2 = grips_of(p, warp + math.pi / 2)
    local held = (b1 and b2) or (t1 and t2)
    local zone = held and 1 or (b1 or t1 or b2 or t2) and 2 or 3
    table.insert(zones[zone], i)
  end
  return zones
end

-- The quantities recorded at the present time.
local function reading(a, t, last, centre)
  local _, force = a:reaction "top"
  local displacement = a:node(last).uy
  local e = displacement / t.length
  local E, S = sheet.mean(a, "E"), sheet.mean(a, "S")
  local Ec, Sc = sheet.mean(a, "E", centre), sheet.mean(a, "S", centre)
  local E_average, E_lateral = sheet.along(E, t.angle)
  return {
    displacement = displacement,
    force = force,
    E = e + e * e / 2,
    S = force / (t.width * t.thickness * (1 + e)),
    E_lateral = E_lateral,
    E_average = E_average,
    S_average = sheet.along(S, t.angle),
    E_centre = sheet.along(Ec, t.angle),
    S_centre = sheet.along(Sc, t.angle),
    E12_average = E[3],
    E12_centre = Ec[3],
    S12_centre = Sc[3],
  }
end
strip.columns = { "displacement", "force", "E", "S", "E_lateral", "E_average", "S_average", "E_centre", "S_centre",
                  "E12_average", "E12_centre", "S12_centre" }

-- The strip is released where the force is zero. It then stays there until the grip returns to that position.
local function release(a, t, points, state)
  local function held_open() return sheet.value(points, a.time) <= state.floor end
  a:event {
    value = function() return held_open() and 1 or select(2, a:reaction "top") end,
    tolerance = 1e-6, -- over the largest force
    action = function()
      local now = sheet.value(points, a.time)
      for _, p in ipairs(points) do
        if p[1] > a.time and p[2] > now then
          state.floor = now
          return
        end
      end
      a:stop "the grip lets go"
    end,
  }
end

local function make_mesh(t)
  local nx, ny = table.unpack(t.cells or { 3, 9 })
  local mesh = fabric.mesh.rectangle { width = t.width, height = t.length, nx = nx, ny = ny }
  if t.out_of_plane == "free" then -- an initial bow of a tenth of the thickness gives the buckle its direction
    local bow = 0.1 * t.thickness
    mesh:map(function(x, y) return x, y, bow * (1 - math.cos(2 * math.pi * y / t.length)) / 2 end)
  end
  return mesh
end

local function build(t, points, state)
  local mesh = make_mesh(t)
  local model = fabric.model { mesh = mesh, card = t.card, thickness = t.thickness, warp = 90 - t.angle, yarns = t.yarns }
  hold(t, mesh, model)
  -- If the strip can be released, the motion waits at the release: a function of time that takes it into account.
  local plain = #t.path <= 2 or not t.unilateral
  model:move("top", { y = plain and fabric.history(points) or function(time)
    return math.max(sheet.value(points, time), state.floor)
  end })
  return mesh, model
end

local function numbers(result)
  local peak = sheet.peak(result.curve, "displacement")
  return { S = peak.S, S_average = peak.S_average, S_centre = peak.S_centre, E_centre = peak.E_centre, E_lateral = peak.E_lateral,
           E12_centre = peak.E12_centre, dissipated = result.analysis.energy.dissipated }
end

-- Runs the test. t: the fields of strip.arguments, with `angle` (degrees from the warp), `displacement` and `test`, its name.
function strip.run(t)
  t.thickness = t.thickness or t.card.thickness
  t.path = t.path or (t.unload and { 1, 0 } or { 1 })
  local points, duration = sheet.history(t.path, t.displacement)
  local state = { floor = -math.huge }
  local mesh, model = build(t, points, state)
  local a = fabric.static { model = model, duration = duration, step = duration / t.steps, stabilise = t.stabilise,
                            max_iterations = t.max_iterations, max_cuts = t.max_cuts, method = t.method, tolerance = t.tolerance }
  local centre, places = sheet.centre(mesh)
  local last = #mesh.nodes
  local curve = sheet.observe(a, strip.columns, t.out, "strip", function(run) return reading(run, t, last, centre) end,
    t.rows and duration / t.rows)
  a:every(1, function() end) -- steps end at the corners of the path
  if t.unilateral then release(a, t, points, state) end
  a:solve()
  local result = { curve = curve, analysis = a, model = model, mesh = mesh, displacement = t.displacement,
                   volume = t.width * t.length * t.thickness, zones = strip.zones(t, places), peak = sheet.peak(curve, "displacement") }
  result.mesh_error = mesh_error(result, t, strip.run, numbers, { 3, 9 })
  return result
end

-- The displacement for a given Green-Lagrange strain between the grips.
function strip.displacement(length, E) return length * (math.sqrt(1 + 2 * E) - 1) end

strip.arguments = {
  { name = "grips", kind = "text|fields", choices = { "clamped", "free" }, default = "clamped",
    rows = { { name = "lateral", kind = "number", unit = "N/m^2", above = 0, sentence = "stiffness across, per metre of edge" } },
    sentence = "clamped ends keep their width, free ends contract, {lateral=k}: springs across, k in N/m per metre of edge" },
  { name = "path", kind = "numbers", optional = true,
    sentence = "displacements visited in turn, as parts of the largest; default {1, 0}" },
  { name = "unload", kind = "boolean", default = true, sentence = "without a path: back again" },
  { name = "unilateral", kind = "boolean", default = true,
    sentence = "the grip lets go where the pull is zero; false: it pushes beyond that" },
  { name = "out_of_plane", kind = "text", choices = { "held", "free" }, default = "held",
    sentence = "free: the strip, bowed by a tenth of its thickness, may buckle" },
  { name = "stabilise", kind = "boolean|number", default = false, sentence = "as for fabric.static: a buckling strip needs it" },
  { name = "cells", kind = "numbers", low = 1, optional = true, sentence = "{across, along}; default {3, 9}" },
  { name = "steps", kind = "integer", low = 2, default = 80, sentence = "for the whole history" },
  { name = "rows", kind = "integer", low = 1, optional = true,
    sentence = "of the curve, at equal times, besides the first; default: one for each step" },
  { name = "tolerance", kind = "number", above = 0, default = 1e-10, sentence = "as for fabric.static" },
  { name = "max_iterations", kind = "integer", low = 1, default = 200, sentence = "as for fabric.static" },
  { name = "max_cuts", kind = "integer", low = 0, default = 12, sentence = "as for fabric.static" },
  { name = "method", kind = "text", choices = { "newton", "relaxation", "either" }, default = "newton", sentence = "as for fabric.static" },
  { name = "width", kind = "number", unit = "m", above = 0, default = 25.4 * u.mm, sentence = "of the strip" },
  { name = "length", kind = "number", unit = "m", above = 0, default = 76.2 * u.mm, sentence = "between the grips" },
  { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: the card's" },
  { name = "yarns", kind = "text", choices = { "eased", "full" }, default = "eased", sentence = "as for fabric.model" },
  { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv and the VTK series strip.pvd" },
}
strip.returns = "Returns curve (a list of time, displacement, force, E, S = force over area, E_lateral, and E and S along the pull as "
  .. "_average over the elements and at the _centre, E12_average, E12_centre, S12_centre), peak (its row of largest displacement), "
  .. "zones (element numbers of the bias test's three zones), analysis, model, mesh, displacement, volume, and the method mesh_error()."

return strip
