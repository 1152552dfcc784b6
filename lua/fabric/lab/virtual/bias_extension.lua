-- fabric.lab.bias_extension: the bias test on a mesh with edges along the yarns, on which each yarn is a line of edges.
--
--      /\/\/\        squares on their tips, halved at the rim;   warp at 45 degrees from x, pull along y,
--      \/\/\/        `cells` of them across the width            both ends clamped
--      /\/\/\
local curves = require "fabric.columns"
local fabric = require "fabric"
local define = require "fabric.define"

-- Nodes (i, j) with even i + j are at (i w, j h); every (i, j) with odd i + j is the middle of an element.
local function lattice(columns, rows, w, h)
  local lines, number, count = {}, {}, 0
  for j = 0, rows do
    for i = j % 2, columns, 2 do
      count = count + 1
      number[j * (columns + 1) + i] = count
      lines[count] = ("v %.17g %.17g 0"):format(i * w, j * h)
    end
  end
  for j = 0, rows do
    for i = (j + 1) % 2, columns, 2 do
      local face = { "f" }
      for _, step in ipairs { { 0, -1 }, { 1, 0 }, { 0, 1 }, { -1, 0 } } do
        local a, b = i + step[1], j + step[2]
        if a >= 0 and a <= columns and b >= 0 and b <= rows then face[#face + 1] = number[b * (columns + 1) + a] end
      end
      lines[#lines + 1] = table.concat(face, " ")
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

local function mesh_of(t)
  local columns = 2 * t.cells
  local rows = 2 * math.max(1, math.floor(t.length / (2 * t.width / columns) + 0.5))
  local name = os.tmpname()
  os.remove(name)
  local path = name .. ".obj"
  do
    local f <close> = assert(io.open(path, "w"))
    f:write(lattice(columns, rows, t.width / columns, t.length / rows))
  end
  local mesh = fabric.mesh.read(path)
  os.remove(path)
  local near = 1e-9 * t.length
  mesh:set("bottom", function(_, y) return y < near end)
  mesh:set("top", function(_, y) return y > t.length - near end)
  return mesh
end

local function run(t)
  local thickness = t.thickness or t.card.thickness
  local mesh = mesh_of(t)
  local model = fabric.model { mesh = mesh, card = t.card, thickness = thickness, warp = 45 }
  model:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
  model:move("top", { y = fabric.ramp(t.displacement, 1) })
  local a = fabric.static { model = model, duration = 1, step = 1 / t.steps, tolerance = t.tolerance }
  local curve = curves.made()
  a:every(1 / t.steps, function() -- at equal displacements, whatever the steps
    local _, force = a:reaction "top"
    local d = a.time * t.displacement
    local e = d / t.length
    curve[#curve + 1] = { time = a.time, displacement = d, force = force, E = e + e * e / 2, S = force / (t.width * thickness * (1 + e)) }
  end)
  a:solve()
  return { curve = curve, analysis = a, model = model, mesh = mesh }
end

define {
  name = "fabric.lab.bias_extension",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "width", kind = "number", unit = "m", above = 0, sentence = "of the specimen" },
    { name = "length", kind = "number", unit = "m", above = 0, sentence = "between the grips" },
    { name = "displacement", kind = "number", unit = "m", above = 0, sentence = "largest displacement" },
    { name = "cells", kind = "integer", low = 1, default = 10, sentence = "squares across the width" },
    { name = "steps", kind = "integer", low = 2, default = 60, sentence = "of the displacement, at each of which the curve has a row" },
    { name = "tolerance", kind = "number", above = 0, default = 1e-8, sentence = "as for fabric.static" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: the card's" },
  },
  sentence = "A strip at 45 degrees, clamped and pulled, on a mesh along its yarns: for yarns that hardly stretch. Returns curve (a list of time, "
    .. "displacement, force, E, S), analysis, model, mesh.",
  example = "local t = fabric.lab.bias_extension{ card=fabric.card 'blend', width=0.05, length=0.15, displacement=0.01, cells=2, steps=4 }\n"
    .. "assert(t.curve[5].force > t.curve[3].force)",
  run = run,
}
