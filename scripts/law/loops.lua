-- One yarn whose unloading is curved, with loops inside loops, beside the straight law; at one material point.
--
--   fabricsh scripts/law/loops.lua [folder]
--
-- The warp of the blend is pulled to 0.1, let go to rest, pulled again to 0.12 and back in loops that turn on the way.
local fabric = require "fabric"
local MPa = fabric.units.MPa
local folder = arg[1] or "out/law"

local straight = fabric.card "blend"
local friction, reach, bend = 0.35, 0.7, 0.6
local card = straight:with { warp = { unloading = 250 * MPa, loop = { friction = friction, reach = reach, curve = bend } } }
straight = straight:with { warp = { unloading = 250 * MPa } }
local yarn = card.warp
local function P(E) return yarn.loading[1] * E + yarn.loading[2] * E ^ 2 / 2 end
local function way(m, x) return m - (1 - x) * P(m) / yarn.unloading end

-- Turning points; each leg in n steps.
local first, top = 0.1, 0.12
local turns = { first, way(first, 0), top, way(top, 0.35), way(top, 0.75), way(top, 0.5), way(top, 0.75), way(top, 0.15), way(top, 0.6), way(top, 0), top, 0.135 }
local function path(n)
  local list, from = {}, 0
  for _, to in ipairs(turns) do
    for i = 1, n do list[#list + 1] = from + (to - from) * i / n end
    from = to
  end
  return list
end
local function walk(of, n) return fabric.point(of):uniaxial("warp", path(n)) end
local fine, coarse, line = walk(card, 150), walk(card, 1), walk(straight, 150)

fabric.plot {
  file = folder .. "/law_loops.svg",
  xlabel = "Green-Lagrange strain E11",
  ylabel = "second Piola-Kirchhoff stress S11",
  yunit = "MPa",
  curves = {
    { rows = line, x = "E", y = "S", label = "straight law", colour = "grey" },
    { rows = fine, x = "E", y = "S", label = "curved loop" },
  },
}

-- By hand: the elastic part, and the friction lost at the distance y from a peak or built up over y from rest. Strands end at sixths of the
-- reach, where it is friction (1 - (1 - y/reach)^2).
local strands = 6
local function elastic(x) return (1 - friction) * x * (1 - bend + bend * x) end
local function rubbed(y)
  local z = math.min(y / reach, 1) * strands
  local low = math.min(z // 1, strands - 1)
  local function parabola(k) return friction * (1 - (1 - k / strands) ^ 2) end
  return parabola(low) + (z - low) * (parabola(low + 1) - parabola(low))
end
local function down(x) return elastic(x) + friction - rubbed(1 - x) end

local rows = {}
local function check(name, got, want, relative) rows[#rows + 1] = { name, got, want, relative = relative or 1e-11 } end
for i, run in ipairs { fine, coarse } do
  local n = #run // #turns
  local function at(k) return run[k * n] end
  local name = i == 1 and "150 steps a leg: " or "1 step a leg: "
  check(name .. "S at the first peak", at(1).S, P(first), 1e-13)
  rows[#rows + 1] = { name .. "S at rest", at(2).S, 0, absolute = 1e-6 * P(first) }
  check(name .. "S at the second peak: the measured curve", at(3).S, P(top), 1e-13)
  check(name .. "S let go to 0.35", at(4).S, P(top) * down(0.35))
  check(name .. "from there up to 0.75", at(5).S - at(4).S, P(top) * (elastic(0.75) - elastic(0.35) + rubbed(0.4)))
  check(name .. "down to 0.5", at(5).S - at(6).S, P(top) * (elastic(0.75) - elastic(0.5) + rubbed(0.25)))
  check(name .. "the inner loop closes", at(7).S, at(5).S)
  check(name .. "and leaves nothing behind", at(8).S, P(top) * down(0.15))
  check(name .. "the second peak again", at(11).S, P(top))
  check(name .. "and on along the measured curve", at(12).S, P(0.135), 1e-13)
  for k = 2, #turns do assert(at(k).dissipated >= at(k - 1).dissipated, "energy out of nothing") end
  check(name .. "lost, in any number of steps", at(12).dissipated, fine[#fine].dissipated)
end
-- The whole loop from a peak to rest and back loses a fixed share of P^2 / Du; the straight law loses nothing there.
local share = friction * (1 - reach * (2 * strands ^ 2 + 1) / (3 * strands ^ 2))
local point = fabric.point(card)
local a = point:uniaxial("warp", { top })[1]
local b = point:uniaxial("warp", { way(top, 0), top })[2]
check("lost in the whole loop", b.dissipated - a.dissipated, share * P(top) ^ 2 / yarn.unloading)
print(("a whole loop loses %.1f %% of what is let go along its lower curve"):format(100 * share / ((1 - friction) * (1 / 2 - bend / 6) + friction * reach
  * (2 * strands ^ 2 + 1) / (6 * strands ^ 2))))

-- Why not one friction that fades with the way (as in bending): dF = (+-Y - F)/w dx with Y half of the friction and w half of the reach, which
-- gives a loop as wide and as steep after a turn. It has no turning points to come back to.
local Y, w = friction / 2, reach / 2
local function faded(F, dx)
  local side = dx > 0 and Y or -Y
  return side + (F - side) * math.exp(-math.abs(dx) / w)
end
local short = Y - faded(faded(Y, -0.25), 0.25) -- from the peak to x = 3/4 and back to the peak
local before = faded(Y, -0.5)
local F = before
for _ = 1, 100 do F = faded(faded(F, 0.25), -0.25) end
local e = math.exp(-0.25 / w)
check("fading: short of the measured curve", short, 2 * Y * e * (1 - e), 1e-12)
check("fading: where an inner loop settles", F, -Y * (1 - e) / (1 + e), 1e-12)
print(("a fading friction would come back to the peak %.1f %% below the measured stress, and an inner loop would move by %.1f %% of the peak"):format(
  100 * short, 100 * (F - before)))
rows[#rows + 1] = { "fading: short of the peak, %", 100 * short, 9, absolute = 0.5 } -- share/doc/law.md
rows[#rows + 1] = { "fading: an inner loop moves, %", 100 * (F - before), 3, absolute = 0.5 }
fabric.expect(rows)
