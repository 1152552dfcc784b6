-- fabric.lab.cantilever, heart_loop and twist: bending of cloth under its own weight, as in laboratory tests [astm_d1388].
local fabric = require "fabric"
local define = require "fabric.define"
local lists = require "fabric.lists"

local gravity, tolerance = 9.80665, 1e-9 -- m/s^2; of the steps

-- Initial rigidity B in a direction (degrees from the warp), N.m: the card's own, or that of its thickness; off the yarns that of a
-- sheet bent to a cylinder.
local function rigidity(card, direction)
  local function along(name)
    local own = card.bending and card.bending[name]
    if type(own) == "table" then return type(own[1]) == "table" and own[2][2] / own[2][1] or own[1] end
    if own then return own end
    local e = 1e-6
    return fabric.point(card):uniaxial(name, e).S / e * card.thickness ^ 3 / 12
  end
  local warp, weft = along "warp", along "weft"
  local twist = card.bending and card.bending.twist or math.sqrt(warp * weft) / 2
  local c, s = math.cos(math.rad(direction)) ^ 2, math.sin(math.rad(direction)) ^ 2
  return c * c * warp + s * s * weft + 4 * c * s * twist
end

local names = { warp = 0, weft = 90 }
local function degrees(direction) return names[direction] or direction end

-- A strip from x = 0 to its length; its yarns are rotated so that x is the direction of the test.
local function strip(t, length)
  local direction = degrees(t.direction)
  local along = math.abs(math.sin(math.rad(2 * direction))) < 1e-9
  local across = along and 1 or math.max(2, math.ceil(t.cells * t.width / length))
  local mesh = fabric.mesh.rectangle { width = length, height = t.width, nx = t.cells, ny = across }
  local options = { mesh = mesh, card = t.card, warp = -direction }
  return mesh, fabric.model(options)
end

-- The middle line of a strip: { x, z } from the held end.
local function line(a, t, mesh)
  local out, across = {}, #mesh.nodes // (t.cells + 1)
  for i = 1, t.cells + 1 do
    local x, z = 0, 0
    for j = 0, across - 1 do
      local p = a:node(i + j * (t.cells + 1))
      x, z = x + p.x, z + p.z
    end
    out[i] = { x / across, z / across }
  end
  return out
end

local function areal(t) return t.card.density * t.card.thickness end

-- The angle (degrees) of the chord from the edge to the tip of an overhang.
local function hang(t, overhang)
  local mesh, model = strip(t, overhang)
  model:fix("left", "x y z rotation"):gravity { 0, 0, fabric.ramp(-gravity, 1) }
  local a = fabric.static { model = model, duration = 1, step = 1 / t.steps, tolerance = tolerance, max_cuts = 12 }:solve()
  local shape = line(a, t, mesh)
  local tip = shape[#shape]
  return math.deg(math.atan(-tip[2], tip[1])), shape, a
end

local shared = {
  { name = "card", of = "card", sentence = "the fabric" },
  { name = "direction", kind = "text|number", unit = "degrees", choices = { "warp", "weft" }, default = "warp",
    sentence = "of the strip: warp, weft or an angle from the warp" },
}
local rest = {
  { name = "cells", kind = "integer", low = 4, optional = true, sentence = "along the strip; default: 40, of a loop 80" },
  { name = "steps", kind = "integer", low = 1, default = 5, sentence = "steps in which the weight is applied, at least" },
}
local retired = { "gravity", "tolerance" }

define {
  name = "fabric.lab.cantilever",
  arguments = lists.joined(shared, {
    { name = "width", kind = "number", unit = "m", above = 0, default = 0.025, sentence = "of the strip" },
    { name = "angle", kind = "number", unit = "degrees", above = 0, high = 80, default = 41.5, sentence = "of the plane that the tip is to touch" },
    { name = "overhang", kind = "number", unit = "m", above = 0, optional = true, sentence = "one overhang, in place of the one whose tip touches the plane" },
  }, rest),
  retired = retired,
  sentence = "Cantilever test [astm_d1388]: a strip is pushed over an edge until its tip touches a plane below. Returns overhang and bending_length "
    .. "(half of it), m, rigidity (weight times its cube, N.m), angle (of the chord, degrees), shape (the middle line, {x, z}), analysis.",
  example = "local card = fabric.card 'blend':with{ bending={ warp=15e-6, weft=12e-6, twist=7e-6 } }\n"
    .. "local r = fabric.lab.cantilever{ card=card, cells=10 }\nassert(math.abs(r.rigidity / 15e-6 - 1) < 0.02 and math.abs(r.angle - 41.5) < 0.01)",
  run = function(t)
    t.cells = t.cells or 40
    local weight = areal(t) * gravity
    local function result(overhang, angle, shape, a)
      return { overhang = overhang, bending_length = overhang / 2, rigidity = weight * (overhang / 2) ^ 3, angle = angle, shape = shape, analysis = a }
    end
    if t.overhang then return result(t.overhang, hang(t, t.overhang)) end
    -- The angle is almost linear in the logarithm of the overhang: secant method, starting from the solution of the elastica.
    local wanted = t.angle
    local function off(log)
      local angle, shape, a = hang(t, math.exp(log))
      return angle - wanted, shape, a
    end
    local x0 = math.log((rigidity(t.card, degrees(t.direction)) / weight) ^ (1 / 3) * 2 * (wanted / 41.5) ^ (1 / 3))
    local y0, shape, a = off(x0)
    local slope = 75 -- degrees per unit of the logarithm, near 41.5
    for _ = 1, 12 do
      if math.abs(y0) < 1e-3 then return result(math.exp(x0), y0 + wanted, shape, a) end
      local x1 = x0 - math.max(-0.4, math.min(0.4, y0 / slope))
      local y1
      y1, shape, a = off(x1)
      if math.abs(x1 - x0) > 1e-9 then slope = math.max(10, (y1 - y0) / (x1 - x0)) end
      x0, y0 = x1, y1
    end
    define.fail(("cantilever: no overhang found whose tip touches the plane at %g degrees: the last one, %.4g m, hangs at %.4g"):format(wanted,
      math.exp(x0), y0 + wanted))
  end,
}

-- Half of a loop. During the first second it is rolled to an arc with its root upright and its end face down, which needs no force;
-- during the second one the end is moved below the root and the weight is applied.
--
--        __            root at x = 0, upright; end at x = 0, horizontal: the other half is its mirror image
--       /  \
--      |    |          height: from the grip down to the end; without weight 0.1337 of the whole strip
--   ---'   /
--      \__/
local function loop(t)
  local half = t.length / 2
  local mesh, model = strip(t, half)
  -- Held in its plane, as by the two grips; it would otherwise rotate out of it.
  mesh:set("inside", function(x) return x > 0 and x < half * (1 - 1e-9) end)
  model:fix("left", "x y z"):fix("all", "y"):fix("inside", "rx")
  local function turned(set, angle) model:turn(set, { axis = { 0, 1, 0 }, angle = fabric.ramp(angle, 1) }) end
  turned("left", -90)
  turned("right", 180)
  local function place(time) -- of the end, relative to half the length
    if time == 0 then return 1 end
    local turn = 1.5 * math.pi * math.min(time, 1)
    local arc = (math.sin(turn / 3) + math.sin(turn * 2 / 3)) / turn
    return time <= 1 and arc or arc * math.max(0, 2 - time)
  end
  model:move("right", { x = function(time) return half * (place(time) - 1) end })
  model:gravity { 0, 0, fabric.history { { 0, 0 }, { 1, 0 }, { 2, -gravity } } }
  local a = fabric.static { model = model, duration = 2, step = 1 / math.max(t.steps, 10), tolerance = tolerance, max_cuts = 16 }
  local shape = line(a:solve(), t, mesh)
  return -shape[#shape][2], shape, a
end

define {
  name = "fabric.lab.heart_loop",
  arguments = lists.joined(shared, {
    { name = "length", kind = "number", unit = "m", above = 0, default = 0.15, sentence = "of the strip, between the grips" },
    { name = "width", kind = "number", unit = "m", above = 0, default = 0.025, sentence = "of the strip" },
  }, rest),
  retired = retired,
  sentence = "Heart loop test [astm_d1388]: a strip's ends are held together, upright, and it hangs down as a heart. Returns height (from the grip to "
    .. "the lowest point, m), bending_length (of the standard's formula, m), rigidity (N.m), shape (one half, {x, z}), "
    .. "analysis.",
  example = "local card = fabric.card 'blend':with{ bending={ warp=15e-6, weft=12e-6, twist=7e-6 } }\n"
    .. "local r = fabric.lab.heart_loop{ card=card, cells=16, length=0.1 }\nassert(r.height > 0.1337 * 0.1 and r.height < 0.5 * 0.1)",
  run = function(t)
    if math.abs(math.sin(math.rad(2 * degrees(t.direction)))) > 1e-9 then
      define.fail "heart_loop: field 'direction': expected warp or weft (0 or 90 degrees): off the yarns a loop twists out of its plane"
    end
    t.cells = t.cells or 80
    local height, shape, a = loop(t)
    -- c = l0 f(theta), theta = 32.85 degrees d / l0, where d is the height less l0 = 0.1337 L.
    local l0 = 0.1337 * t.length
    local angle = math.rad(32.85 * (height - l0) / l0)
    local c = angle > 0 and l0 * (math.cos(angle) / math.tan(angle)) ^ (1 / 3) or math.huge
    return { height = height, bending_length = c, rigidity = areal(t) * gravity * c ^ 3, shape = shape, analysis = a }
  end,
}

-- The rigidity that a strip cut at 45 degrees from cloth with these rigidities shows in the cantilever test, N.m.
local function shown_at_45(t, twist)
  local thickness, mass = 0.4e-3, t.areal_mass or 0.2
  local card = fabric.svk { name = "strip", warp = 50e6, weft = 50e6, shear = 1e6, poisson = 0, density = mass / thickness, thickness = thickness,
    bending = { warp = t.warp, weft = t.weft, twist = twist } }
  return fabric.lab.cantilever { card = card, direction = 45, width = t.width, cells = 20 }.rigidity
end

-- Statistics of the strips of one direction: their mean, the variance of it and its degrees of freedom; nil for one strip, which does not show how others differ.
local function shown_by(list, convert)
  local sum, squares, n = 0, 0, #list
  for _, x in ipairs(list) do sum = sum + convert(x) / n end
  for _, x in ipairs(list) do squares = squares + (convert(x) - sum) ^ 2 end
  return { mean = sum, n = n, variance = n > 1 and squares / (n - 1) / n or nil }
end

-- The band of warp, weft and twist, whose variances are those of the strips and of what is common to all of them; of the twist the degrees of freedom are the effective ones [satterthwaite1946].
-- A band ends at zero, which no rigidity passes.
local function band_of_bending(shown, bending, common, level)
  local warp, weft, bias = shown.warp, shown.weft, shown.bias
  for _, one in pairs(shown) do
    if not one.variance then return end
  end
  local values = { bending.warp, bending.weft, bending.twist }
  local variances, freedom = { warp.variance, weft.variance, 0 }, { warp.n - 1, weft.n - 1 }
  local covariance = { warp.variance, 0, 0, 0, weft.variance, 0, 0, 0, 0 }
  if bias then
    local parts = { { bias.variance, bias.n }, { warp.variance / 16, warp.n }, { weft.variance / 16, weft.n } }
    local whole = 0
    for _, part in ipairs(parts) do variances[3], whole = variances[3] + part[1], whole + part[1] ^ 2 / (part[2] - 1) end
    freedom[3] = whole > 0 and variances[3] ^ 2 / whole or 1e6
    covariance[3], covariance[7], covariance[6], covariance[8], covariance[9] = -warp.variance / 4, -warp.variance / 4, -weft.variance / 4, -weft.variance / 4, variances[3]
  end
  local low, high = {}, {}
  local normal = fabric.lab.normal((1 + level) / 2)
  for i, x in ipairs(values) do
    local own = freedom[i] and fabric.lab.student((1 + level) / 2, freedom[i]) ^ 2 * variances[i] or 0
    local half = freedom[i] and math.sqrt(own + (normal * common * x) ^ 2) or 0 -- a twist that no strip shows is not in the band
    low[i], high[i] = math.max(0, x - half), x + half
    for j, y in ipairs(values) do
      if freedom[i] and freedom[j] then covariance[(i - 1) * 3 + j] = covariance[(i - 1) * 3 + j] + common ^ 2 * x * y end
    end
  end
  return { low = low, high = high, covariance = covariance, level = level }
end

define {
  name = "fabric.lab.twist",
  arguments = {
    { name = "warp", kind = "number|numbers", unit = "N.m", above = 0, sentence = "rigidity of the strip along the warp, or of each of several strips; with areal_mass its bending length, m" },
    { name = "weft", kind = "number|numbers", unit = "N.m", above = 0, sentence = "likewise" },
    { name = "bias", kind = "number|numbers", unit = "N.m", above = 0, optional = true, sentence = "likewise, of the strip at 45 degrees; without it the twist is assumed, half of the geometric mean of warp and weft" },
    { name = "areal_mass", kind = "number", unit = "kg/m^2", above = 0, optional = true, sentence = "then the three are bending lengths c, B = 9.80665 areal_mass c^3" },
    { name = "simulate", kind = "boolean", default = false, sentence = "fits the twist until a simulated cantilever of that width shows the bias; takes some seconds" },
    { name = "width", kind = "number", unit = "m", above = 0, default = 0.025, sentence = "of the strips" },
    { name = "common", kind = "number", low = 0, default = 0, sentence = "relative standard uncertainty of all rigidities together: areal mass, angle of the plane" },
    { name = "level", kind = "number", above = 0, high = 1, default = 0.95, sentence = "of confidence" },
  },
  sentence = "The twisting rigidity of cloth from cantilevers in three directions: that of a sheet bent to a cylinder, bias = (warp + weft) / 4 + twist. "
    .. "Returns bending (warp, weft, twist, N.m, as cards take it), bias (what that shows, N.m), reached (false where the twist would have to be zero or less; nil without bias), strips (how many along each) and words; "
    .. "with two strips and more along each also band {low, high, covariance, level} of the three, by Student's t. fabric.lab.card takes the result as bending=.",
  example = "local r = require 'fabric'.lab.twist{ warp=16e-6, weft=8e-6, bias=10e-6 }\nassert(r.reached and math.abs(r.bending.twist - 4e-6) < 1e-15)",
  run = function(t)
    local shown, strips = {}, {}
    for _, name in ipairs { "warp", "weft", "bias" } do
      local list = type(t[name]) == "number" and { t[name] } or t[name]
      if list then
        shown[name] = shown_by(list, function(x) return t.areal_mass and gravity * t.areal_mass * x ^ 3 or x end)
        t[name], strips[name] = shown[name].mean, #list
      end
    end
    local function result(twist, bias, reached, words)
      local bending = { warp = t.warp, weft = t.weft, twist = twist }
      return { bending = bending, bias = bias, reached = reached, words = words, strips = strips, band = band_of_bending(shown, bending, t.common, t.level) }
    end
    if not t.bias then
      if t.simulate then define.fail "twist: field 'bias': expected a strip at 45 degrees, which simulate=true fits the twist to, got nil" end
      local twist = math.sqrt(t.warp * t.weft) / 2
      return result(twist, (t.warp + t.weft) / 4 + twist, nil, ("twist %.4g uN.m, assumed: half of the geometric mean of warp and weft; a strip at 45 degrees would show it"):format(twist * 1e6))
    end
    local least = 0.02 * math.sqrt(t.warp * t.weft) -- for a sheet with hardly any twisting stiffness
    local without = (t.warp + t.weft) / 4
    local twist, reached = t.bias - without, true
    if twist <= 0 and not t.simulate then twist, reached = least, false end
    local bias = without + twist
    if t.simulate then
      twist = math.max(twist, least)
      bias = shown_at_45(t, twist)
      for _ = 1, 8 do -- the shown rigidity increases a little less than the twist
        if math.abs(bias / t.bias - 1) < 1e-3 or not reached then break end
        reached = twist > least or bias < t.bias
        twist = math.max(least, twist + t.bias - bias)
        bias = shown_at_45(t, twist)
      end
      if not reached then without = bias - twist end
    end
    local words = ("twist %.4g uN.m, so that a strip at 45 degrees shows %.4g (given %.4g)"):format(twist * 1e6, bias * 1e6, t.bias * 1e6)
    if not reached then
      words = words .. (": the yarns alone, with no resistance to twisting, would show %.4g; a positive twist cannot bring it below that"):format(without * 1e6)
    end
    return result(twist, bias, reached, words)
  end,
}
