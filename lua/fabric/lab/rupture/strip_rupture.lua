-- fabric.lab.strip_rupture and .grab: a strip pulled until it breaks, and a wide one that is held in its middle alone.
--
--     strip, ISO 13934-1       grab, ISO 13934-2
--        +------+               +----+====+----+
--        | top  |               |    |jaw |    |
--        |      |               |    +----+    |     pulled along y, the yarns of `yarn` along the pull
--        |      |               |              |
--        |bottom|               |    +----+    |
--        +------+               +----+====+----+
local fabric = require "fabric"
local define = require "fabric.define"
local rupture = require "fabric.lab.rupture.rupture"
local lists = require "fabric.lists"
local mm = fabric.units.mm

local transits = 100 -- of a wave over the length until the yarns break: how slow a test is
local start = 10     -- of these, until the grips have their speed
local ended = 0.02    -- a test is over when the force has fallen below this share of the largest

-- Times and speed of a pull to one and a half times the elongation at which yarns break, and the wave speed.
local function pace(t, call)
  rupture.check_lengths(call, t)
  local broken = rupture.of(call, t.card, t.yarn)
  local strain, c = rupture.strain(t.card, t.yarn, broken.strength)
  local transit = t.length / c
  t.speed = t.speed or strain * t.length / (transits * transit)
  t.damping = t.damping or 1 / (4 * transit)
  return { from = start * transit, to = start * transit / 2 + 1.5 * strain * t.length / t.speed, transit = transit }
end

local function analysis(t, model, time)
  local points = rupture.way(time.from, time.to, t.speed)
  local history = fabric.history(points)
  model:move("top", { y = history })
  return fabric.dynamic { model = model, duration = time.to, damping = { mass = t.damping }, ledger_limit = t.ledger_limit }, history
end

local function finish(t, model, mesh, time, stem)
  local a, history = analysis(t, model, time)
  local result = rupture.run(t, a, function(now) return history:value(now) end, {
    stem = stem, model = model, mesh = mesh, every = time.to / (t.rows or 400),
    ends = function(row, peak) return row.fracture > 0 and row.force < ended * peak end,
  })
  if not result.whole then return result end
  result.strain = (result.elongation or 0) / t.length
  result.strength = result.peak / t.width
  return result
end

local function strip(t)
  local time = pace(t, "strip_rupture")
  local nx, ny = math.max(1, math.floor(t.width / t.h + 0.5)), 2 * math.max(1, math.floor(t.length / t.h / 2 + 0.5))
  local mesh = fabric.mesh.rectangle { width = t.width, height = t.length, nx = nx, ny = ny }
  local model = fabric.model { mesh = mesh, card = t.card, warp = t.yarn == "warp" and 90 or 0, points = 1, membrane = true }
  model:fix("all", "z"):fix("bottom", "x y"):fix("top", "x")
  -- Yarns that are all alike would break everywhere at once: then they do so in the middle.
  if t.card.rupture[t.yarn].scatter then
    model:tearable("all", { coarse = t.coarse, seed = t.seed })
  else
    local h = t.length / ny
    mesh:set("band", function(_, y) return math.abs(y - t.length / 2) < 1.01 * h end)
    mesh:set("middle", function(_, y) return math.abs(y - t.length / 2) < 0.01 * h end)
    model:tearable("band", { coarse = t.coarse, seed = t.seed, path = "middle" })
  end
  return finish(t, model, mesh, time, "strip_rupture")
end

local function grab(t)
  local time = pace(t, "grab")
  local function cells(size) return math.max(1, math.floor(size / t.h + 0.5)) end
  local side, jaw, behind, free = (t.width - t.jaw) / 2, cells(t.jaw), cells(t.jaw), cells(t.length)
  if side <= 0 then define.fail(("grab: field 'jaw': expected jaws narrower than the specimen of %g m, got %g m"):format(t.width, t.jaw)) end
  local function lines(parts)
    local out, at = { 0 }, 0
    for _, part in ipairs(parts) do
      for i = 1, part[2] do out[#out + 1] = at + part[1] * i / part[2] end
      at = at + part[1]
    end
    return out
  end
  local whole = t.length + 2 * t.jaw
  local mesh = fabric.mesh.rectangle { width = t.width, height = whole, grading = {
    x = lines { { side, cells(side) }, { t.jaw, jaw }, { side, cells(side) } }, y = lines { { t.jaw, behind }, { t.length, free }, { t.jaw, behind } } } }
  local near = 0.01 * t.h
  local function held(x) return math.abs(x - t.width / 2) < t.jaw / 2 + near end
  mesh:set("bottom", function(x, y) return held(x) and y < t.jaw + near end)
  mesh:set("top", function(x, y) return held(x) and y > whole - t.jaw - near end)
  local model = fabric.model { mesh = mesh, card = t.card, warp = t.yarn == "warp" and 90 or 0, points = 1, membrane = true }
  model:fix("all", "z"):fix("bottom", "x y"):fix("top", "x"):tearable("all", { coarse = t.coarse, seed = t.seed })
  local result = finish(t, model, mesh, time, "grab")
  result.strength = result.peak and result.peak / t.jaw
  return result
end

local function rows(width, length, h, coarse, more)
  local all = {
    { name = "card", of = "card", sentence = "the fabric, with rupture" },
    { name = "yarn", kind = "text", choices = { "warp", "weft" }, default = "warp", sentence = "that is pulled" },
    { name = "width", kind = "number", unit = "m", above = 0, default = width, sentence = "of the specimen" },
    { name = "length", kind = "number", unit = "m", above = 0, default = length, sentence = "between the jaws" },
    { name = "h", kind = "number", unit = "m", above = 0, default = h, sentence = "size of the elements" },
    { name = "ledger_limit", kind = "number", above = 0, default = 0.05, sentence = "as for fabric.dynamic" },
  }
  if more then table.insert(all, 5, more) end
  return lists.map(rupture.rows(all), function(row) return row.name == "coarse" and lists.copy(row, { default = coarse }) or row end)
end

local returns = "Returns peak (N, the largest force), elongation (m) and strain there, strength (N/m), curve (a list of time, displacement, force: N, work over way from "
  .. "row to row, open: joints, and the energies of analysis.energy), energy (J, of the whole record), fracture (J), kinetic (kinetic energy over work at the peak), series "
  .. "(VTK), analysis, model and mesh. There are no peaks to take a mean of."

local sample = "local fabric = require 'fabric'\n"
  .. "local card = fabric.card 'blend':with{ rupture={ warp={ strength=15e3, energy=20 } } }\n"

define {
  name = "fabric.lab.strip_rupture",
  arguments = rows(50 * mm, 200 * mm, 5 * mm, "keep"),
  sentence = "A strip is pulled until it breaks, as in ISO 13934-1 [iso_13934_1]. Yarns whose strength scatters break where they are weakest, others in the middle. " .. returns,
  example = sample .. "local test = fabric.lab.strip_rupture{ card=card, width=0.01, length=0.02, h=0.0025 }\n"
    .. "assert(math.abs(test.strength / 15e3 - 1) < 0.03)",
  run = strip,
}

define {
  name = "fabric.lab.grab",
  arguments = rows(100 * mm, 100 * mm, 5 * mm, "keep", { name = "jaw", kind = "number", unit = "m", above = 0, default = 25 * mm, sentence = "width and depth of the jaws" }),
  sentence = "A wide specimen is held in its middle by narrow jaws and pulled until it breaks, as in ISO 13934-2 [iso_13934_2]. strength is over the width of the jaws. " .. returns,
  example = sample .. "local test = fabric.lab.grab{ card=card, width=0.03, jaw=0.01, length=0.02, h=0.005 }\n"
    .. "assert(test.peak > 0.9 * 15e3 * 0.01)",
  run = grab,
}
