-- Fields of a card as a deck reads them: cheap, and not to be changed.
local fabric = require "fabric"
local blend = fabric.card "blend"
local points = {}
for i = 1, 2000 do points[i] = { (i - 1) * 1e-4, (i - 1) * 1e3 + (i - 1) ^ 2 } end
local measured = blend:with { name = "measured", warp = { loading = points, unloading = 1e9 } }

-- Reading makes nothing: with the collector at rest no memory is taken, whatever else the card holds.
local function taken(read)
  read()
  collectgarbage()
  collectgarbage "stop"
  local before = collectgarbage "count"
  for _ = 1, 1e4 do read() end
  local after = collectgarbage "count"
  collectgarbage "restart"
  return 1024 * (after - before) / 1e4
end
for _, card in ipairs { blend, measured } do
  fabric.expect {
    { "bytes of reading density", taken(function() return card.density end), 0, absolute = 0.01 },
    { "bytes of reading a field that is not there", taken(function() return card.bending end), 0, absolute = 0.01 },
    { "bytes of reading warp.poisson", taken(function() return card.warp.poisson end), 0, absolute = 0.01 },
    { "bytes of reading warp.loading", taken(function() return card.warp.loading end), 0, absolute = 0.01 },
  }
end

-- As fast as a few reads of a plain table, whatever else the card holds. A ratio of two loops in one run, the best of several, with
-- room for a busy machine: building the tables anew was 100 to 5,000 times a plain read.
local plain = { warp = { poisson = 0.25 } }
local function seconds(read)
  local best = math.huge
  for _ = 1, 7 do
    local start = os.clock()
    for _ = 1, 2e4 do read() end
    best = math.min(best, os.clock() - start)
  end
  return best
end
local reference = seconds(function() return plain.warp.poisson end)
for _, card in ipairs { blend, measured } do
  local ratio = seconds(function() return card.warp.poisson end) / reference
  assert(ratio < 30, ("%s: a read costs %.0f reads of a plain table"):format(card.name, ratio))
end

-- They read as any table.
local warp, loading = blend.warp, blend.warp.loading
assert(type(warp) == "table" and type(loading) == "table")
assert(#loading == 2 and loading[1] == 8e6 and loading[2] == 826e6 and loading[3] == nil)
assert(table.concat(loading, " ") == "8000000.0 826000000.0" and select(2, table.unpack(loading)) == 826e6)
local sum, names = 0, {}
for i, d in ipairs(loading) do sum = sum + i * d end
assert(sum == 8e6 + 2 * 826e6)
for name in pairs(warp) do names[#names + 1] = name end
table.sort(names)
assert(table.concat(names, " ") == "loading poisson unloading" and next(warp) ~= nil and rawget(blend.warp, "poisson") == 0.25 and rawlen(blend.warp.loading) == 2)
assert(#measured.warp.loading == 2000 and measured.warp.loading[2000][1] == 1999 * 1e-4 and measured.warp.loading[2001] == nil)
local seen = 0
for i, point in pairs(measured.warp.loading) do
  seen = seen + 1
  assert(i == seen and point[1] == points[i][1] and point[2] == points[i][2])
end
assert(seen == 2000 and blend.bending == nil and blend.shear.measure == "tensor" and blend.kind == "woven")

-- A field that was read is the same table until it is written to; then it is the deck's own, and the card is as before.
warp, loading = blend.warp, blend.warp.loading
assert(blend.warp == warp and blend.warp.loading == loading)
warp.poisson, loading[1], warp.new = 0.4, 0, true
assert(blend.warp ~= warp and blend.warp.loading ~= loading)
assert(warp.poisson == 0.4 and warp.new and warp.unloading == 864e6 and warp.loading == loading and loading[1] == 0 and loading[2] == 826e6 and #loading == 2)
table.insert(loading, 3)
assert(#loading == 3 and #blend.warp.loading == 2 and blend.warp.poisson == 0.25 and blend.warp.new == nil)
local curve = measured.warp.loading
curve[1], curve[2][1] = { 0, 0 }, 7
assert(curve[2][1] == 7 and #curve == 2000 and measured.warp.loading[2][1] == 1e-4)
local raw = rawset(blend.warp, "poisson", 0.5)
assert(raw.poisson == 0.5 and raw.loading[1] == 8e6 and blend.warp.poisson == 0.25)
local nested = blend.weft
nested.loading[1] = 1
measured.warp.loading[2][1] = 7
assert(nested.loading[1] == 1 and blend.weft.loading[1] == 37e6 and measured.warp.loading[2][1] == 1e-4 and not pcall(function() blend.thickness = 1 end))
local mine = rawset({}, "a", 1)
assert(mine.a == 1 and rawget(mine, "a") == 1 and next(mine) == "a" and rawlen { 1, 2 } == 2)

-- Parts of a card go into calls as plain tables do.
local again = fabric.woven { name = blend.name, source = blend.source, density = blend.density, thickness = blend.thickness, warp = blend.warp,
  weft = { loading = blend.weft.loading, unloading = blend.weft.unloading, poisson = blend.weft.poisson }, shear = blend.shear, tested = blend.tested,
  estimate = blend.estimate, provenance = blend.provenance }
assert(again == blend and blend:with { warp = measured.warp } == blend:with { warp = { loading = points, unloading = 1e9 } })
assert(blend:with { weft = { loading = measured.warp.loading, unloading = 1e9 } }.weft.loading[2000][1] == 1999 * 1e-4)
assert(#fabric.poly(blend.warp.loading, 1e-6) == 2)
local registry = require "fabric.define".registry
assert(registry.show(blend.warp):find("poisson = 0.25", 1, true) and registry.show(blend.warp.loading) == "{8000000, 8.26e+08}",
  registry.show(blend.warp.loading))
