-- Supports feel the damping of the cloth that they hold and move. A strip pulled at constant speed resists as Kelvin's and Voigt's bar,
-- F = EA e + b EA V/L at both of its ends, and loses b EA V^2/L a second; one that is dragged along by its edge, a M V^2. All that supports put in
-- is in the external work, and all that damping takes in energy.damping, whatever the mesh, the frame of the supports and the scheme.
local fabric = require "fabric"
local E, t, w, L, density = 1e7, 0.5e-3, 0.02, 0.05, 500
local card = fabric.svk { density = density, thickness = t, warp = E, weft = E, shear = 4e6, poisson = 0, bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 } }
local EA, M = E * t * w, density * t * w * L
local s = math.sqrt(0.5)
local frames = { plain = { { 1, 0, 0 }, { 0, 1, 0 } }, turned = { { s, 0.5, 0.5 }, { -s, 0.5, 0.5 } } }

local function sheet(o)
  local e1, e2 = table.unpack(frames[o.frame or "plain"])
  local mesh = fabric.mesh.rectangle { width = L, height = w, nx = o.nx, ny = 2, triangles = o.triangles }
  mesh:map(function(x, y) return x * e1[1] + y * e2[1], x * e1[2] + y * e2[2], x * e1[3] + y * e2[3] end)
  return fabric.model { mesh = mesh, card = card, warp = e1 }, { frame = { e1, e2 } }, e1
end
local function along(a, set, e)
  local x, y, z = a:reaction(set)
  return x * e[1] + y * e[2] + z * e[3]
end
local function text(what, o)
  return ("%s, %d %s, %s%s, %s: "):format(what, o.nx, o.triangles and "triangles" or "quads", o.scheme or "implicit", o.slow and " slow" or "", o.frame or "plain")
end

-- way: m, of the edge; its speed; and the integral of the speed's square.
local T, V = 0.1, 0.005
local constant = { way = fabric.ramp(V * T, T), speed = V, squares = V ^ 2 * T }
local from_rest = {
  way = function(time) return V * T * math.sin(2 * math.pi * time / (4 * T) / 2) ^ 2 end,
  speed = V * T * math.pi / 4 / T, -- at the end
  squares = (V * T * math.pi / 4 / T) ^ 2 * T / 2,
  stretch = 0.5,
}
-- K_M is that of the stretched strip: (1 + stretch)^2 EA/L, and about its mean in what is lost.
local function pulled(o)
  local m, frame, e1 = sheet(o)
  m:fix("all", "y z rotation", frame):fix("left", "x", frame):move("right", { x = o.drive.way }, frame)
  local a = fabric.dynamic { model = m, duration = T, scheme = o.scheme or "implicit", step = o.step, slow = o.slow, damping = { stiffness = o.b } }:solve()
  local stretch = (o.drive.stretch or 1) * V * T / L
  local e = stretch + stretch ^ 2 / 2
  local want, lost = EA * (e * (1 + stretch) + o.b * (1 + stretch) ^ 2 * o.drive.speed / L), o.b * EA / L * (1 + stretch) * o.drive.squares
  local what = text(("pulled %s, b = %g s"):format(o.drive == constant and "at once" or "from rest", o.b), o)
  print(what, along(a, "right", e1) / want, along(a, "left", e1) / -want, a.energy.damping / lost, a.energy.external, a.energy.error)
  fabric.expect {
    { what .. "force", along(a, "right", e1) / want, 1, relative = o.force or 2e-3 },
    { what .. "force of the other end", along(a, "left", e1) / -want, 1, relative = o.force or 2e-3 },
    { what .. "damping", a.energy.damping / lost, 1, relative = o.loss or 1e-2 },
    { what .. "work", a.energy.external / (EA * L * e ^ 2 / 2 + lost + a.energy.kinetic), 1, relative = o.loss or 1e-2 },
    { what .. "ledger", a.energy.error, 0, absolute = 2e-3 },
  }
end
for _, triangles in ipairs { false, true } do
  for _, nx in ipairs { 1, 5, 20 } do
    for _, drive in ipairs { constant, from_rest } do
      local frame = nx == 5 and "turned" or "plain"
      pulled { nx = nx, triangles = triangles, drive = drive, b = 5e-2, step = 1e-3, frame = frame }
      pulled { nx = nx, triangles = triangles, drive = drive, b = 5e-2, step = 1e-3, frame = frame, slow = true, loss = 2e-2 } -- Euler's rule loses more, by the step
      pulled { nx = nx, triangles = triangles, drive = drive, b = 2e-3, step = 5e-3, frame = frame, slow = true, loss = 2 }
    end
  end
  for _, nx in ipairs { 1, 5 } do
    for _, drive in ipairs { constant, from_rest } do
      pulled { nx = nx, triangles = triangles, drive = drive, b = 1e-4, scheme = "explicit" }
    end
  end
end

-- The edge is brought to its speed within 0.1 s, and keeps it for as long.
local function dragged(o)
  local m, frame, e1 = sheet(o)
  local speed, a0, start, duration = 0.5, 50, 0.1, 0.2
  m:fix("all", "y z rotation", frame):move("right", { x = function(time) return speed * (time < start and time ^ 2 / 2 / start or time - start / 2) end }, frame)
  local a = fabric.dynamic { model = m, duration = duration, scheme = o.scheme or "implicit", step = o.step, slow = o.slow, damping = { mass = a0 } }:solve()
  local lost, kinetic = a0 * M * speed ^ 2 * (start / 3 + duration - start), M * speed ^ 2 / 2
  local what = text("dragged", o)
  print(what, along(a, "right", e1) / (a0 * M * speed), a.energy.damping / lost, a.energy.external / (lost + kinetic), a.energy.error)
  fabric.expect {
    { what .. "force", along(a, "right", e1) / (a0 * M * speed), 1, relative = o.slow and 1e-6 or 0.2 }, -- the strip swings on
    { what .. "damping", a.energy.damping / lost, 1, relative = 5e-3 },
    { what .. "work", a.energy.external / (lost + kinetic), 1, relative = 5e-3 },
    { what .. "ledger", a.energy.error, 0, absolute = 2e-3 },
  }
end
for _, nx in ipairs { 1, 2, 8 } do
  dragged { nx = nx, step = 1e-3, triangles = nx == 2, frame = "turned" }
  dragged { nx = nx, step = 1e-3, slow = true, triangles = nx == 8 }
  dragged { nx = nx, scheme = "explicit", triangles = nx == 1 }
end

-- A pull of 1e-3 s sets a held strip swinging along its length; once it rests, its support has taken the whole impulse. Back at an earlier state the
-- run gives the same bits.
for _, slow in ipairs { false, true } do
  local m, frame = sheet { nx = 8, triangles = slow }
  m:fix("all", "y z rotation", frame):fix("left", "x", frame):force("right", { x = fabric.history { { 0, 0 }, { 1e-3, 0.2 }, { 2e-3, 0 }, { 1, 0 } } })
  local a = fabric.dynamic { model = m, duration = 0.02, scheme = "implicit", step = 2e-5, slow = slow, damping = { stiffness = 1e-4 } }
  local impulse, time, before = 0, 0, 0
  a:every("step", function(run)
    local f = (run:reaction "left")
    impulse, time, before = impulse + (f + before) / 2 * (run.time - time), run.time, f
  end)
  a:advance(0.004)
  local state, now = a:snapshot(), (a:reaction "left")
  a:solve()
  fabric.expect { { "impulse of the support" .. (slow and ", slow" or ""), impulse, -2e-4, relative = 1e-5 } }
  local lost, put_in, last = a.energy.damping, a.energy.external, (a:reaction "left")
  a:restore(state)
  assert((a:reaction "left") == now)
  a:solve()
  assert(a.energy.damping == lost and a.energy.external == put_in and (a:reaction "left") == last)
end
