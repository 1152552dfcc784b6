-- A seam that a rod holds apart when its time is over closes later, when its edges have come near: they are not moved together through the rod,
-- which gave infinite energies, or more impact than the motion had.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })
local radius, over, length, width, size = 5 * mm, 0.05, 60 * mm, 40 * mm, 20 * mm

-- Two strips beside a rod, held at their far ends, are drawn over it, tight.
local function drawn(o)
  local z, start = 0.5 * radius + card.thickness / 2, math.sqrt(0.75) * radius + 3 * mm
  local function strip(x)
    local mesh = fabric.mesh.rectangle { width = length, height = width, nx = length // size, ny = width // size, triangles = o.triangles, origin = { x, -width / 2, 0 } }
    mesh:map(function(X, Y) return X, Y, z end)
    return mesh
  end
  local m = fabric.model {
    bodies = { { name = "r", mesh = strip(start), card = card, warp = 0 }, { name = "l", mesh = strip(-start - length), card = card, warp = 0 } },
    points = o.scheme == "explicit" and 1 or nil,
  }
  local rod = fabric.rigid.cylinder { name = "rod", radius = radius, from = { 0, -60 * mm, 0 }, to = { 0, 60 * mm, 0 } }
  m:seam { "r.left", "l.right", over = over }:contact { between = { rod, "all" }, friction = 0.2 }
  m:fix("r.right", "y z rotation"):fix("l.left", "y z rotation")
  local nearer = start - o.apart * radius
  m:move("r.right", { x = fabric.ramp(-nearer, over) }):move("l.left", { x = fabric.ramp(nearer, over) })
  local a
  if o.scheme == "static" then
    a = fabric.static { model = m, duration = 2 * over, step = o.step }
  else
    a = fabric.dynamic { model = m, duration = 1.5 * over, scheme = o.scheme, slow = o.slow, step = o.step, damping = not o.slow and { mass = 20 } or nil }
  end
  a:solve()
  local name = ("%s%s, %s, steps of %s ms"):format(o.scheme, o.slow and " slow" or "", o.triangles and "triangles" or "quads", o.step and o.step / 1e-3 or "its own")
  print(("%s: %d of %d closed, impact %.2g J of %.2g J of work, %d steps"):format(name, a.joints.closed, a.joints.stitches, a.energy.impact or 0, a.energy.external, #a.steps))
  assert(a.joints.closed == a.joints.stitches, name)
  assert(a.energy.stored < a.energy.external and (a.energy.impact or 0) < 1e-3 * a.energy.external, name)
  assert(a:gap() > 0)
  for _, w in ipairs(a.warnings) do assert(w.code ~= "seam", w.text) end
end

local long = os.getenv "FABRICSH_TEST_LONG"
for _, triangles in ipairs { false, true } do
  for _, apart in ipairs { 2.4, 2.8 } do
    for _, step in ipairs { 2e-3, 5e-4 } do
      if long or step == 2e-3 then
        drawn { scheme = "implicit", slow = true, step = step, triangles = triangles, apart = apart }
        drawn { scheme = "implicit", step = step, triangles = triangles, apart = apart }
      end
    end
  end
  if long then drawn { scheme = "explicit", triangles = triangles, apart = 2.4 } end
  drawn { scheme = "static", step = 5e-3, triangles = triangles, apart = 2.4 }
end
