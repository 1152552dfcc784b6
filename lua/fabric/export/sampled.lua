-- Samples of a card's law by fabric.point: the curves for a target, and the paths by which it is judged.
local fabric = require "fabric"
local sampled = {}

sampled.axes = { "warp", "weft" }

-- Largest tested strain of an axis or of shear (E12); these values are used if the card states none.
local untested = { warp = 0.10, weft = 0.10, shear = 0.20 }
sampled.untested = untested
function sampled.tested(card)
  local out = {}
  for name, default in pairs(untested) do
    local known = card.kind == "woven" and card.tested[name] or 0
    out[name] = known > 0 and known or default
  end
  return out
end

-- {E, S} of virgin uniaxial loading along an axis with zero lateral and shear stress, from zero to `reach`; S: second
-- Piola-Kirchhoff stress, Pa.
function sampled.uniaxial(card, axis, reach, n)
  local p, E, S = fabric.point(card), { 0 }, { 0 }
  for i = 1, n do
    E[i + 1] = reach * i / n
    S[i + 1] = p:uniaxial(axis, E[i + 1]).S
  end
  return E, S
end

-- {E12, S12} of virgin shear with E11 = E22 = 0.
function sampled.shear(card, reach, n)
  local p, E, S = fabric.point(card), { 0 }, { 0 }
  for i = 1, n do
    E[i + 1] = reach * i / n
    S[i + 1] = p:strain({ E12 = E[i + 1] }).S12
  end
  return E, S
end

-- A point of the card loaded to a strain in many steps, since the comparison laws follow their path; its stress; and what drives it on.
local function loaded(card, part, from)
  local p, S = fabric.point(card), nil
  local function drive(E) return part == "shear" and p:strain({ E12 = E }).S12 or p:uniaxial(part, E).S end
  for i = 1, 64 do S = drive(from * i / 64) end
  return S, drive
end

-- The strain at which the stress has come to zero on the way down, which of the potential law is one straight line (of a curved loop: its chord).
local function residual_of(card, part, from)
  local value, drive = loaded(card, part, from)
  local loop = part ~= "shear" and card.kind == "woven" and card[part].loop
  if loop then return from - value / card[part].unloading end
  if card.kind ~= "woven" or card.law == "potential" then
    local probe = 1e-4 * from
    return from - value * probe / (value - drive(from - probe))
  end
  local steps, before = 400, value
  for i = 1, steps do
    local S = drive(from * (1 - i / steps))
    if S <= 0 then return from * (1 - (i - 1 + before / (before - S)) / steps) end
    before = S
  end
  return 0
end

-- {E, S} of unloading from the virgin strain `from` to zero stress, in descending strain, down to the residual strain.
function sampled.unloading(card, part, from, n)
  local residual = residual_of(card, part, from)
  local value, drive = loaded(card, part, from)
  local E, S = { from }, { value }
  for i = 1, n do
    E[i + 1] = from + (residual - from) * i / n
    S[i + 1] = i == n and 0 or drive(E[i + 1])
  end
  return E, S, residual
end

-- Paths: name, words, driven component, list of values. Strains are Green-Lagrange, tensor components.
local steps = 60
local function visit(corners)
  local out, last = {}, 0
  local length = 0
  for _, c in ipairs(corners) do length, last = length + math.abs(c - last), c end
  last = 0
  for _, c in ipairs(corners) do
    local n = math.max(4, math.ceil(steps * math.abs(c - last) / length * (#corners > 1 and 3 or 1)))
    for i = 1, n do
      local x = last + (c - last) * i / n
      out[#out + 1] = math.abs(x) > 1e-12 * length and x or 0
    end
    last = c
  end
  return out
end

function sampled.paths(card)
  local t = sampled.tested(card)
  local both = math.min(t.warp, t.weft)
  local function cycle(x) return visit { 0.6 * x, 0.3 * x, x, 0.6 * x } end
  return {
    { name = "warp", words = "tension along the warp", drive = "uniaxial", direction = "warp", angle = 0, values = visit { t.warp } },
    { name = "weft", words = "tension along the weft", drive = "uniaxial", direction = "weft", angle = 90, values = visit { t.weft } },
    { name = "biaxial", words = "1:1 biaxial, E11 = E22", drive = "biaxial", values = visit { both } },
    { name = "bias", words = "tension at 45 degrees", drive = "uniaxial", direction = 45, angle = 45, values = visit { t.shear } },
    { name = "cyclic warp", words = "warp, pulled and let go twice", drive = "uniaxial", direction = "warp", angle = 0, values = cycle(t.warp) },
    { name = "cyclic weft", words = "weft, pulled and let go twice", drive = "uniaxial", direction = "weft", angle = 90, values = cycle(t.weft) },
    { name = "cyclic shear", words = "shear to and fro, E11 = E22 = 0", drive = "shear", values = visit { t.shear, -t.shear, t.shear } },
  }
end

-- The stresses of the card along a path: one list, or two for the biaxial path.
function sampled.along(card, path)
  local p, first, second = fabric.point(card), {}, path.drive == "biaxial" and {} or nil
  for i, x in ipairs(path.values) do
    if path.drive == "uniaxial" then
      first[i] = p:uniaxial(path.direction, x).S
    elseif path.drive == "shear" then
      first[i] = p:strain({ E12 = x }).S12
    else
      local s = p:strain { E11 = x, E22 = x }
      first[i], second[i] = s.S11, s.S22
    end
  end
  return first, second
end

return sampled
