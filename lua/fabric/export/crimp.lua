-- LAW58 with crimped yarns: a pull first straightens the yarns, so that the sheet's curve is not that of its yarns. Here the law of the deck is pulled
-- along each yarn, free across, and what it answers takes the place of the yarn's curves.
local laws = require "fabric.export.laws"
local crimp = {}

local least = 1e-3 -- crimp below which a yarn counts as straight

-- The nominal stress at each sheet elongation in a list, which may come back.
local function pull(p, angle, elongations)
  local values, out = {}, {}
  for i, x in ipairs(elongations) do values[i] = x + x * x / 2 end
  local S = laws.along(laws.law58(p), { drive = "uniaxial", angle = angle, values = values })
  for i, x in ipairs(elongations) do out[i] = S[i] * (1 + x) end
  return out
end

-- The points of a curve that rise in both measures from {0, 0}, in ascending order.
local function rising(xs, ys, first, last, step)
  local out = { x = { 0 }, y = { 0 } }
  for i = first, last, step do
    local n = #out.x
    if xs[i] > out.x[n] and ys[i] > out.y[n] then out.x[n + 1], out.y[n + 1] = xs[i], ys[i] end
  end
  return out
end

local function ramp(from, to, n, list)
  for i = 1, n do list[#list + 1] = from + (to - from) * i / n end
  return list
end

local steps = 120

-- The curves of the sheet along a yarn with crimp S; those of the unloading from the sheet's elongation at which the file lets the yarn go.
local function sheet(p, part, angle, S)
  local up = ramp(0, S + part.loading.x[#part.loading.x], steps, {})
  local out = { loading = rising(up, pull(p, angle, up), 1, #up, 1), elastic = part.elastic, ended = part.ended }
  local top = S + part.meet[1]
  out.meet = { top, laws.value(out.loading, top) }
  out.unloading = out.loading
  if not part.elastic then
    local path = ramp(top, 0, steps, ramp(0, top, steps, {}))
    local y = pull(p, angle, path)
    local back = rising(path, y, #path, steps, -1)
    if #back.x > 2 then out.unloading, out.meet = back, { back.x[#back.x], back.y[#back.y] } end
  end
  out.slope = out.loading.y[2] / out.loading.x[2]
  return out
end

-- The parameters with the curves of the sheet for those of its yarns; the same ones where the yarns are straight.
function crimp.straightened(p)
  if math.max(p.S1, p.S2) <= least then return p end
  local out = {}
  for key, value in pairs(p) do out[key] = value end
  out.warp, out.weft = sheet(p, p.warp, 0, p.S1), sheet(p, p.weft, 90, p.S2)
  return out
end

return crimp
