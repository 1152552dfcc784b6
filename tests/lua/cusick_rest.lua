-- The drape tester's outline where the warp lies at 30 degrees, and what it takes for rest: a cloth that turns back, or is back at its place after a window, moves.
local fabric = require "fabric"
local checks = {}
local function check(name, got, want, how) checks[#checks + 1] = { name, got, want, relative = how.relative, absolute = how.absolute } end

-- A disc ten times as stiff along the warp hangs deeper across it. Its outline is the same turned by the warp's angle, and longest along the warp.
do
  local card = fabric.svk { name = "ribbed", young = 50e6, poisson = 0, density = 500, thickness = 0.4e-3, bending = { warp = 1.2e-3, weft = 0.12e-3, twist = 0.1e-3 } }
  local function draped(orientation)
    return fabric.lab.cusick { card = card, orientation = orientation, offset = 0, cells = 4, around = 36, by = "relaxation", steps = 2, contact = false }
  end
  local straight, turned = draped(0), draped(30)
  -- Where the outline is longest: half the phase of its second wave.
  local function axis(contour)
    local c, s = 0, 0
    for _, p in ipairs(contour) do
      local r2 = p[1] ^ 2 + p[2] ^ 2
      c, s = c + (p[1] ^ 2 - p[2] ^ 2) * r2, s + 2 * p[1] * p[2] * r2
    end
    return math.deg(math.atan(s, c) / 2)
  end
  check("outline at 0 degrees: longest at", axis(straight.contour), 0, { absolute = 0.02 }) -- rays half a degree apart, not on the axis
  check("outline at 30 degrees: longest at", axis(turned.contour), 30, { absolute = 0.02 }) -- rays half a degree apart, not on the axis
  check("the same share of shadow", turned.coefficient, straight.coefficient, { relative = 1e-6 })
  -- Point by point: ray k of the one is ray k + 60 of 720 of the other, turned by 30 degrees. 36 elements around are alike after each ten degrees.
  local worst, shape, c, s = 0, 0, math.cos(math.rad(30)), math.sin(math.rad(30))
  for k = 1, 720 do
    local p, q = straight.contour[k], turned.contour[(k + 59) % 720 + 1]
    worst = math.max(worst, math.abs(c * p[1] - s * p[2] - q[1]), math.abs(s * p[1] + c * p[2] - q[2]))
    shape = math.max(shape, 0.15 - math.sqrt(p[1] ^ 2 + p[2] ^ 2))
  end
  assert(shape > 2.5e-3, shape)
  check("outline at 30 degrees: every point, of what hangs", worst / shape, 0, { absolute = 1e-4 }) -- relaxed to 1e-5
end

-- The rule of rest, on motions that are known: in place of the run stands one whose rim moves as is told. It is looked at each window; it rests if within the last one no
-- place has moved by more than `still` of the overhang and its kinetic energy is below 1e-5 of the weight's work, and a window after the lowering at the earliest.
do
  local card = fabric.svk { name = "disc", young = 50e6, poisson = 0, density = 500, thickness = 0.4e-3, bending = { warp = 4e-3, weft = 4e-3, twist = 2e-3 } }
  local dynamic = fabric.dynamic
  -- move(t) -> sag of the whole rim, m; share of the kinetic energy of the weight's work. Returns whether and when it came to rest.
  local function rest(move, window, lowering, duration)
    fabric.dynamic = function(given)
      local nodes, look, every, stopped = #given.model.mesh.nodes, nil, nil, false
      local run = { time = 0, energy = { external = 1, kinetic = 0, error = 0 } }
      function run:every(interval, action) every, look = interval, action end
      function run:stop() stopped = true end
      function run:field(name)
        local out = {}
        for i = 1, nodes do
          local X = given.model.mesh.nodes[i]
          out[i] = name == "x" and X[1] or name == "y" and X[2] or X[3] - (move(run.time))
        end
        return out
      end
      function run:solve()
        for k = 0, math.floor(given.duration / every + 1e-9) do
          run.time = k * every
          run.energy.kinetic = select(2, move(run.time))
          look(run)
          if stopped then break end
        end
        return run
      end
      return run
    end
    local ok, r = pcall(fabric.lab.cusick, { card = card, cells = 3, around = 12, contact = false, window = window, lowering = lowering, duration = duration, still = 0.01 })
    fabric.dynamic = dynamic
    assert(ok, r)
    return r.at_rest, r.runs[1].time, r.runs[1].moved
  end
  local allowed = 0.01 * (0.3 - 0.18) / 2
  local function swing(size, period, phase)
    return function(t)
      local a = 2 * math.pi * t / period + phase
      return size * math.cos(a), 1e-2 * math.sin(a) ^ 2
    end
  end
  -- At every look it turns, without any velocity, on the other side of its swing.
  local at_rest, time, moved = rest(swing(5 * allowed, 0.8, 0), 0.4, 1, 10)
  assert(not at_rest)
  check("turning points: runs on, s", time, 10, { absolute = 1e-9 })
  check("turning points: how far it went", moved, 10 * allowed, { relative = 1e-9 })
  -- At every look it is where it was before, at full speed.
  at_rest, time, moved = rest(swing(5 * allowed, 0.4, math.pi / 2), 0.4, 1, 10)
  assert(not at_rest)
  check("back at its place: runs on, s", time, 10, { absolute = 1e-9 })
  check("back at its place: did not seem to move", moved, 0, { absolute = 1e-9 })
  -- At rest from 3.1 s on: the look at 3.2 s sees that it has moved since 2.8 s, the one at 3.6 s that it has not.
  local function stops(t)
    if t < 3.1 then return swing(5 * allowed, 0.9, 0.3)(t) end
    return -4 * allowed, 0
  end
  at_rest, time = rest(stops, 0.4, 1, 10)
  assert(at_rest)
  check("stopped at 3.1 s: told, s", time, 3.6, { absolute = 1e-9 })
  -- Never moved: not before a window has passed since the lowering, at 1.5 s with a window of 0.4 s.
  at_rest, time = rest(function() return 0, 0 end, 0.4, 1.5, 10)
  assert(at_rest)
  check("never moved: told, s", time, 2, { absolute = 1e-9 })
  -- Just within and just beyond what may still move, and the kinetic energy likewise.
  for _, case in ipairs { { 0.99, 0.9e-5, true }, { 1.01, 0.9e-5, false }, { 0.99, 1.1e-5, false } } do
    local side = 1
    at_rest = rest(function(t)
      side = math.floor(t / 0.4 + 0.5) % 2
      return side * case[1] * allowed, case[2]
    end, 0.4, 1, 6)
    assert(at_rest == case[3], case[1])
  end
end
fabric.expect(checks)
