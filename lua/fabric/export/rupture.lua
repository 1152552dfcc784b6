-- How a card's breaking yarns go to another solver: as a strain from which the stress of a family falls, and one at which it is gone.
--
-- An element of the length h that is pulled apart spends, per metre of the line across, h times the area under its whole curve of force per width over
-- nominal strain. That is to be the energy G of breaking, so that the strain at which the force is gone belongs to h, and an element that has spent more
-- than G before it begins to fail is too large for any.
local fabric = require "fabric"
local define = require "fabric.define"
local laws = require "fabric.export.laws"
local sampled = require "fabric.export.sampled"
local rupture = {}

local farthest, step = 4, 1e-3 -- nominal strain

-- Force per width (N/m) of a pull along the yarns with free edges, as a function of the nominal strain: of the card, or of the law that is written, which
-- finds its width step by step.
local function puller(card, axis, law)
  if not law then
    local point = fabric.point(card)
    return function(e) return point:uniaxial(axis, e + e * e / 2).S * (1 + e) * card.thickness end
  end
  local values, wide = {}, 5 * step
  for i = 1, math.floor((1 + farthest) / wide) + 1 do values[i] = i * wide + (i * wide) ^ 2 / 2 end
  local S = laws.along(law, { drive = "uniaxial", angle = axis == "warp" and 0 or 90, values = values })
  local function force(i) return i == 0 and 0 or S[i] * (1 + i * wide) * card.thickness end
  return function(e)
    local i = math.min(math.floor(e / wide), #values - 1)
    return force(i) + (force(i + 1) - force(i)) * (e / wide - i)
  end
end

-- Points {strain, force per width} of a pull until the force is `strength`; nil if it never is.
local function pull(force, strength)
  local out = { { 0, 0 } }
  for i = 1, math.floor(1 / step) do
    local ok, now = pcall(force, i * step)
    if not ok then return end
    out[#out + 1] = { i * step, now }
    if now >= strength then
      local a, b = out[#out - 1], out[#out]
      local share = (strength - a[2]) / (b[2] - a[2])
      out[#out] = { a[1] + share * (b[1] - a[1]), strength }
      return out
    end
  end
end

local function area(points)
  local sum = 0
  for i = 2, #points do sum = sum + (points[i][1] - points[i - 1][1]) * (points[i][2] + points[i - 1][2]) / 2 end
  return sum
end

-- Way beyond the strain `from` on which a force that goes on at its slope, and falls by 1 - x / w, spends `left`, J/m2: f w / 2 + slope w^2 / 6.
local function straight(_, _, f, slope, left)
  return slope > 0 and (math.sqrt(f * f / 4 + 2 * slope * left / 3) - f / 2) * 3 / slope or 2 * left / f
end

-- The same for the force of the law less the damage of /FAIL/ORTHSTRAIN, (to / e) (e - from) / (to - from).
local function damaged(force, from, _, _, left)
  local parts = 200
  local function spent(w)
    local sum, to = 0, from + w
    for i = 1, parts do
      local e = from + (i - 0.5) / parts * w
      sum = sum + force(e) * (1 - to / e * (e - from) / w) * w / parts
    end
    return sum
  end
  local low, high = 0, farthest
  if spent(high) < left then return high end
  for _ = 1, 60 do
    local w = (low + high) / 2
    if spent(w) < left then low = w else high = w end
  end
  return high
end

-- Nominal strains {from, to} between which the force falls on elements of h, m; `from` and the length at which there is none for too large an h; nil and
-- nothing for a strength that is not reached. law: the one that is written, where it is not the card's curve.
function rupture.strains(card, axis, h, law)
  local broken, force = card.rupture[axis], puller(card, axis, law)
  local points = pull(force, broken.strength)
  if not points then return end
  local before = area(points)
  local a, b = points[#points - 1], points[#points]
  local left = h and broken.energy / h - before
  if not left or left <= 0 then return nil, b[1], broken.energy / before end
  local w = (law and damaged or straight)(force, b[1], broken.strength, (b[2] - a[2]) / (b[1] - a[1]), left)
  return { b[1], b[1] + math.min(w, farthest) }, b[1], broken.energy / before
end

-- Sentences on what is lost, and the strains by axis if they can be written: into a target that takes `fail`, for elements of t.element. law: see
-- rupture.strains.
function rupture.prepare(t, target, law)
  local card, out, found = t.card, {}, {}
  local function add(...) out[#out + 1] = (...):format(select(2, ...)) end
  if not card.rupture then
    if t.element then define.fail(("card: field 'element': the card '%s' has no rupture: expected a card that says when its yarns break"):format(card.name or "")) end
    return out
  end
  local said = false
  for _, axis in ipairs(sampled.axes) do
    local broken = card.rupture[axis]
    if broken then
      local strains, from, most = rupture.strains(card, axis, t.element, law)
      if not from then
        add("rupture: the card does not reach the strength of the %s, %.4g N/m, at any strain: nothing written breaks along it", axis, broken.strength)
      elseif not target.fail then
        add("rupture: lost, nothing written breaks%s; the %s breaks at a nominal strain of %.4g (%.4g N/m) and takes %.4g J/m", target.no_fail or "", axis, from, broken.strength, broken.energy)
      elseif not t.element then
        add("rupture: lost, since it is a matter of the size of elements there: element=h (m) writes it; the %s breaks at a nominal strain of %.4g, on elements of at most %.3g m", axis,
          from, most)
      elseif not strains then
        define.fail(("card: field 'element': an element of %.4g m has spent more than the energy of the %s, %.4g J/m, when it begins to fail: expected at most %.3g m"):format(t.element, axis,
          broken.energy, most))
      else
        found[axis], said = strains, true
        add("rupture: %s: the stress of the %s falls from a nominal strain of %.4g to %.4g, which spends its %.4g J/m on elements of %.4g m along it, and another energy on others", target.fail,
          axis, strains[1], strains[2], broken.energy, t.element)
        if strains[2] - strains[1] >= farthest then
          add("rupture: what is written for the %s spends less than that: its strains are cut at %.4g", axis, strains[2])
        end
        if broken.scatter then add("rupture: the scatter of the %s is lost", axis) end
      end
    end
  end
  if said then
    add("rupture: what an element stored goes too, no tear has a tip between elements, and an element is removed when %s", law
      and "one family has failed, whose damage is that of the whole element" or "both families have failed")
  end
  return out, said and found or nil
end

return rupture
