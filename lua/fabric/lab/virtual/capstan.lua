-- fabric.lab.capstan: a strip over a rigid cylinder, held by a tension T1 on one side and pulled on the other.
--
--            _____        T2 / T1 = exp(friction * wrap) of a thread; of n corners that turn by d = wrap/n each
--          /  ___  \      ((1 + friction tan(d/2)) / (1 - friction tan(d/2)))^n
--         |  /   \  |     Facets touch with their middles, see scripts/contact/capstan.lua.
--      T1 v |     | v T2
local define = require "fabric.define"
local curves = require "fabric.columns"
local fabric = require "fabric"

-- Facets that touch the cylinder's surface: corners a little outside, leads along the tangents. They begin pressed in by a hair, since
-- contact has no stiffness where it begins, and a limp strip would be free to swing.
local pressed = 0.005 -- of the thickness
local function strip(t)
  local half = math.rad(t.wrap) / 2
  local turn = 2 * half / t.around
  local r = (t.radius + (0.5 - pressed) * t.card.thickness) / math.cos(turn / 2)
  local facet = 2 * r * math.sin(turn / 2)
  local n = t.around + 2 * t.lead
  local mesh = fabric.mesh.rectangle { width = n * facet, height = t.width, nx = n, ny = 1 }
  mesh:map(function(s, y)
    local k = s / facet - t.lead
    local inside = math.max(0, math.min(t.around, k))
    local angle, beyond = inside * turn - half, (k - inside) * facet
    -- A straight end continues the middle line of its first bend.
    return r * math.sin(angle) + beyond * math.cos(angle), y, r * math.cos(angle) - beyond * math.sin(angle)
  end)
  local function along(x, _, z)
    local angle = math.max(-half, math.min(half, math.atan(x, z)))
    return { math.cos(angle), 0, -math.sin(angle) }
  end
  return mesh, along, half
end

-- The elements that are drawn onto the cylinder have to be of the straight part: beyond it the held edge would leave its tangent.
local function enough(t)
  local drawn = t.draw < 0.5 and math.ceil(t.draw * t.around / (1 - 2 * t.draw) - 1e-9) or math.huge
  if not t.lead and drawn < math.huge then return math.max(2, drawn) end
  if t.lead and t.lead >= drawn then return t.lead end
  if drawn == math.huge then define.fail(("capstan: field 'draw': expected less than 0.5, got %g: the held edge comes onto the cylinder"):format(t.draw)) end
  define.fail(("capstan: field 'lead': expected at least %d, got %d: the held edge comes onto the cylinder"):format(drawn, t.lead))
end

local function run(t)
  t.lead = enough(t)
  local mesh, along, half = strip(t)
  local model = fabric.model { mesh = mesh, card = t.card, warp = along, points = t.card.bending and 1 or 3 }
  local first, last = { math.cos(half), 0, math.sin(half) }, { math.cos(half), 0, -math.sin(half) }
  local length = (t.around + 2 * t.lead) * 2 * (t.radius + t.card.thickness / 2) * math.tan(half / t.around)
  local drum = fabric.rigid.cylinder { radius = t.radius, from = { 0, -t.width, 0 }, to = { 0, 2 * t.width, 0 }, name = "drum" }
  model:contact { between = { drum, "all" }, friction = t.friction, stiffness = t.stiffness }
  local inner, n = {}, t.around + 2 * t.lead
  for i = 1, #mesh.nodes do
    if (i - 1) % (n + 1) > 0 and i % (n + 1) > 0 then inner[#inner + 1] = i end
  end
  mesh:set("inner", inner)
  model:fix("inner", "y")
  model:fix("left", "y z", { frame = { first, { 0, 1, 0 } } }):fix("right", "y z", { frame = { last, { 0, 1, 0 } } })
  model:force("left", { x = fabric.history { { 0, 0 }, { 1, -t.tension * t.width } } }, { frame = { first, { 0, 1, 0 } } })
  model:move("right", { x = fabric.history { { 0, 0 }, { 1, 0 }, { 2, t.draw * length } } }, { frame = { last, { 0, 1, 0 } } })
  local a = fabric.static { model = model, duration = 2, step = t.step, max_cuts = 20 }
  local curve = curves.made()
  a:every("step", function(r)
    local x, _, z = r:reaction "right"
    curve[#curve + 1] = { time = r.time, drawn = math.max(0, r.time - 1) * t.draw * length,
                          ratio = (x * last[1] + z * last[3]) / (t.tension * t.width) }
  end)
  a:solve()
  if fabric.checking() then curve[1] = { time = 0, drawn = 0, ratio = 1 } end
  return { curve = curve, ratio = curve[#curve].ratio, analysis = a, model = model, mesh = mesh, drum = drum }
end

define {
  name = "fabric.lab.capstan",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric; its warp lies along the strip" },
    { name = "radius", kind = "number", unit = "m", above = 0, default = 0.03, sentence = "of the cylinder" },
    { name = "wrap", kind = "number", unit = "degrees", above = 0, high = 180, default = 90, sentence = "of the strip about it" },
    { name = "friction", kind = "number", low = 0, default = 0.3, sentence = "of strip and cylinder" },
    { name = "tension", kind = "number", unit = "N/m", above = 0, default = 10, sentence = "T1, that the strip is held by" },
    { name = "width", kind = "number", unit = "m", above = 0, default = 0.01, sentence = "of the strip" },
    { name = "around", kind = "integer", low = 4, default = 16, sentence = "elements of the wrap" },
    { name = "lead", kind = "integer", low = 1, optional = true,
      sentence = "elements of the straight part on either side; default: 2, or as many as are drawn onto the cylinder" },
    { name = "draw", kind = "number", above = 0, high = 1, default = 0.05, sentence = "of the strip's length: how far it is drawn" },
    { name = "step", kind = "number", unit = "s", above = 0, default = 0.05, sentence = "largest step: 1 s is the tension, 1 s more the drawing" },
    { name = "stiffness", kind = "number", unit = "Pa/m", above = 0, optional = true, sentence = "of contact, as for model:contact" },
  },
  sentence = "A strip over a rigid cylinder is held by a tension T1 on one side and drawn over it on the other. Returns ratio (T2 / T1 at the end), curve "
    .. "(a list of time, drawn, m, and ratio), analysis, model, mesh and drum.",
  example = "local card = fabric.svk{ young=1e8, poisson=0, density=500, thickness=0.4e-3 }\n"
    .. "local test = fabric.lab.capstan{ card=card, around=8, draw=0.01, step=0.25 }\n"
    .. "assert(test.ratio > 1)",
  retired = { "across", "points" },
  run = run,
}
