-- The loss of an export: the target's law compared with the card's own, path by path.
local sampled = require "fabric.export.sampled"
local registry = require("fabric.define").registry
local laws = require "fabric.export.laws"
local loss = {}

local function largest(list)
  local m = 0
  for _, v in ipairs(list or {}) do m = math.max(m, math.abs(v)) end
  return m
end

-- Work per volume along a path, J/m3 (trapezoidal rule); the strain conjugate to the shear stress is 2 E12.
local function work(path, first, second)
  local w, x0, s0, r0 = 0, 0, 0, 0
  for i, x in ipairs(path.values) do
    w = w + (x - x0) * ((first[i] + s0) / 2 + (second and (second[i] + r0) / 2 or 0))
    x0, s0, r0 = x, first[i], second and second[i] or 0
  end
  return path.drive == "shear" and 2 * w or w
end

local function compare(path, a1, a2, b1, b2)
  local peak = math.max(largest(a1), largest(a2))
  local worst, where, sum, n = 0, 0, 0, 0
  local function lay(a, b)
    for i = 1, #a do
      local d = math.abs(b[i] - a[i])
      if not (d <= worst) then worst, where = d, path.values[i] end
      sum, n = sum + d * d, n + 1
    end
  end
  lay(a1, b1)
  if a2 then lay(a2, b2) end
  local w, v = work(path, a1, a2), work(path, b1, b2)
  return { path = path.name, words = path.words, worst = 100 * worst / peak, rms = 100 * math.sqrt(sum / n) / peak, where = where,
    work = 100 * (v - w) / math.abs(w), peak = peak, strain = path.values, ours = { a1, a2 }, theirs = { b1, b2 } }
end

-- Rows {path, words, worst, rms, work (per cent), where (strain), peak (Pa), strain, ours, theirs} for the law of make().
function loss.rows(card, make)
  local rows = {}
  for i, path in ipairs(sampled.paths(card)) do
    local a1, a2 = sampled.along(card, path)
    local b1, b2 = laws.along(make(), path)
    rows[i] = compare(path, a1, a2, b1, b2)
  end
  return rows
end

-- The rows as lines of text.
function loss.lines(rows)
  local out = { ("%-14s %9s %9s %9s   %s"):format("path", "worst", "rms", "work", "per cent of the card's own peak stress, of its work") }
  for _, r in ipairs(rows) do
    out[#out + 1] = ("%-14s %9.2f %9.2f %+9.2f   %s, worst at E = %.4g"):format(r.path, r.worst, r.rms, r.work, r.words, r.where)
  end
  return out
end

-- The groups of a card of which other sentences speak, or of which nothing has to be said.
local already_reported = { warp = true, weft = true, shear = true, tested = true, biaxial = true, bending = true, bands = true, estimate = true }

-- The numbers of a group by its rows, such as "shear modulus 1e+05 Pa, shear time 10 s".
local function numbers(rows, group, before, out)
  for _, row in ipairs(rows) do
    local value = group[row.name]
    if type(value) == "table" then
      numbers(row.rows, value, before .. row.name .. " ", out)
    elseif value ~= nil then
      out[#out + 1] = (("%s%s %s %s"):format(before, row.name, type(value) == "number" and ("%.4g"):format(value) or tostring(value), row.unit or ""):gsub(" $", ""))
    end
  end
  return out
end

-- Elements beside the springs of a woven card: the groups that its constructor takes, whatever they are.
local function beside(card, add)
  for _, row in ipairs(registry.rows()) do
    if row.name == "fabric.woven" then
      for _, argument in ipairs(row.arguments) do
        local group = not already_reported[argument.name] and #argument.rows > 0 and card[argument.name]
        if group then
          add(("%s: %s, is lost (%s); what is written is the answer to a pull too quick for time to matter"):format(argument.name,
            argument.sentence:match "^[^,;]*", table.concat(numbers(argument.rows, group, "", {}), ", ")))
        end
      end
    end
  end
end

-- A rigidity in words; one that changes with the curvature by that of the flat sheet: its first coefficient, or its first measured slope.
local function rigidity(given)
  if type(given) == "number" then return ("%.3g"):format(given) end
  local first = given[1]
  if type(first) == "table" then first = given[2][2] / given[2][1] end
  return ("%.3g and changing with the curvature"):format(first)
end

-- Losses that the paths do not show, as sentences.
function loss.sentences(card, target)
  local out = {}
  local function add(text) out[#out + 1] = text end
  if card.kind == "woven" then
    if target.coupling then add(target.coupling)
    elseif card.warp.poisson > 0 then add "coupling: nothing ties warp to weft there, so the sheet does not contract across a pull and two axes do not stiffen each other" end
    add("hysteresis: " .. target.hysteresis)
    add("shear flips: " .. target.flips)
    if card.biaxial then add "biaxial stiffening: the card's fourth spring is lost" end
    local linear = target.measure ~= nil -- a law of constants, which takes secants at the tested strains and no curves
    for _, axis in ipairs(sampled.axes) do
      local l = card[axis].loop
      if l and target.elastic then
        add(("curved loops: the %s unloads along its loading curve there; the card's loop (friction %.4g, reach %.4g, curve %.4g) is lost"):format(axis, l.friction, l.reach, l.curve))
      elseif l and linear then
        add(("curved loops: the %s loads and unloads along one straight line there; the card's loop (friction %.4g, reach %.4g, curve %.4g) is lost"):format(axis, l.friction, l.reach, l.curve))
      elseif l then
        add(("curved loops: of the %s the card's curve from the tested strain to zero stress is written; its loop (friction %.4g, reach %.4g, curve %.4g), and those inside it, are lost: going up again is the target's")
          :format(axis, l.friction, l.reach, l.curve))
      end
    end
    local f = card.shear.friction
    if f then
      add(("shear friction: the card's loop, which slips at %.4g Pa, and by %.4g Pa more over a strain of 1, is lost; %s")
        :format(f.stress, f.growth, linear and "only the secant at the tested shear is written" or target.elastic and "only its way up is written" or "its ways up and down from the tested shear are written"))
    end
    beside(card, add)
    if card.law ~= "potential" then add(("law: the card's '%s' law was sampled; its path dependence beyond one axis at a time is lost"):format(card.law)) end
  end
  local bending = card.bending
  if bending then
    add("bending: " .. target.bending .. (" (the card's rigidity: warp %s, weft %s, twist %.3g N.m)"):format(rigidity(bending.warp), rigidity(bending.weft), bending.twist))
    if bending.friction_warp or bending.friction_weft then add "bending friction: lost" end
  else
    add("bending: " .. target.bending)
  end
  if card.compression then add "compression: how the cloth is pressed is lost; contact there presses by rules of its own" end
  if card.kind == "woven" and card.damage then add "damage: the softening of yarns that break is lost; nothing written breaks" end
  if card.kind == "woven" and card.bands then
    local parts = {}
    for _, part in ipairs { "warp", "weft", "shear", "bending", "biaxial" } do parts[#parts + 1] = card.bands[part] and part or nil end
    add(("bands%s: the values alone are written"):format(#parts > 0 and " of " .. table.concat(parts, ", ") or ""))
  end
  return out
end

return loss
