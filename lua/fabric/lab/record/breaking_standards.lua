-- Demands of ISO 13934-1 [iso_13934_1] and ASTM D5035 [astm_d5035] on strips that are pulled until they break, and which breaks at the jaws they leave out.
local lists = require "fabric.lists"
local standards = {}

local mm = 1e-3

local function near(value, wanted, tolerance) return math.abs(value - wanted) <= tolerance + 1e-9 end
local function one_of(value, list, tolerance)
  for _, wanted in ipairs(list) do
    if near(value, wanted, tolerance) then return true end
  end
  return false
end

-- To the nearest multiple of the step that belongs to the size: steps { {below, step}, ... }.
local function rounded(value, steps)
  for _, s in ipairs(steps) do
    if value < s[1] then return math.floor(value / s[2] + 0.5) * s[2] end
  end
end

-- --- ISO 13934-1 ---

local iso = { name = "ISO 13934-1", near_jaw = 5 * mm, slip = 2 * mm, specimens = 5 }

-- Strips of 50 mm, 200 mm between the jaws (100 mm of cloth that stretches by more than 75 %), at 20 mm/min below 8 % of elongation, else 100 mm/min.
-- elongation: the mean at the largest force, as a number; speed: m/s or nil.
function iso.departures(width, gauge_length, elongation, speed)
  local out = {}
  if not near(width, 50 * mm, 0.5 * mm) then out[#out + 1] = ("strips 50 mm wide, got %.4g mm"):format(1e3 * width) end
  if not one_of(gauge_length, { 200 * mm, 100 * mm }, 1 * mm) then
    out[#out + 1] = ("200 mm between the jaws, or 100 mm for more than 75 %% of elongation, got %.4g mm"):format(1e3 * gauge_length)
  end
  local wanted = elongation < 0.08 and 20 or 100
  if speed and not near(speed * 60e3, wanted, 0.1 * wanted) then
    out[#out + 1] = ("%d mm/min at an elongation of %.3g %%, got %.3g mm/min"):format(wanted, 100 * elongation, speed * 60e3)
  end
  return out
end

-- A break at a jaw counts unless it is below the lowest other one. Without another one there are single values only.
-- breaks: { {force=, jaw=}, ... }; returns for each the words why it is left out, or false, and whether there is a mean.
function iso.left_out(breaks)
  local lowest, out = math.huge, {}
  for _, b in ipairs(breaks) do lowest = b.jaw and lowest or math.min(lowest, b.force) end
  for i, b in ipairs(breaks) do
    out[i] = b.jaw and lowest < math.huge and b.force < lowest and ("below the lowest of the others, %.4g N"):format(lowest)
  end
  return out, lowest < math.huge, "every break is at a jaw, so there are single values only"
end

function iso.rounded_force(F) return rounded(F, { { 100, 1 }, { 1000, 10 }, { math.huge, 100 } }) end
function iso.rounded_elongation(percent) return rounded(percent, { { 8, 0.2 }, { 75, 0.5 }, { math.huge, 1 } }) end

-- --- ASTM D5035 ---

local astm = { name = "ASTM D5035", near_jaw = 5 * mm, specimens = 5, specimens_weft = 8 }

-- Strips of 25 or 50 mm (1 or 2 in), 75 mm (3 in) between the jaws, 300 mm/min.
function astm.departures(width, gauge_length, _, speed)
  local out = {}
  if not one_of(width, { 25 * mm, 25.4 * mm, 50 * mm, 50.8 * mm }, 1 * mm) then out[#out + 1] = ("strips 25 or 50 mm wide, got %.4g mm"):format(1e3 * width) end
  if not one_of(gauge_length, { 75 * mm, 76.2 * mm }, 1 * mm) then out[#out + 1] = ("75 mm between the jaws, got %.4g mm"):format(1e3 * gauge_length) end
  if speed and not near(speed * 60e3, 300, 10) then out[#out + 1] = ("300 mm/min, got %.3g mm/min"):format(speed * 60e3) end
  return out
end

-- A break at a jaw is left out if it is below half of the mean of all others.
function astm.left_out(breaks)
  local out = {}
  for i, b in ipairs(breaks) do
    local others = lists.collect(breaks, function(other, k) if k ~= i then return other.force end end)
    local half = #others > 0 and lists.mean(others) / 2
    out[i] = b.jaw and half and b.force < half and ("below half of the mean of the others, %.4g N"):format(half)
  end
  return out, true
end

standards["ISO 13934-1"], standards["ASTM D5035"] = iso, astm
return standards
