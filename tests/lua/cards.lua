-- The shipped cards: each loads, checks, pulls to the strains to which it was tested and hangs as its rigidity says; what is not measured
-- is marked; and the page of them is up to date.
local fabric = require "fabric"
local gravity = 9.80665
local home = arg[0]:gsub("[^/]*$", "") .. "../../"
local function text_of(path)
  local file <close> = assert(io.open(home .. path))
  return file:read "a"
end

-- Warnings of check(), which the card's comment or, for the thesis' four, the page explains.
local warned = {
  aramid = "guard.shear", blend = "bending.weft", cloth049 = "bending.weft", cloth440 = "bending.warp", denim = "bending.warp bending.weft",
  duck = "bending.warp bending.weft", glass = "guard.warp guard.weft", tarpaulin = "guard.shear bending.warp bending.weft",
}
local thesis = { blend = true, denim = true, duck = true, muslin = true }

local function warnings(card)
  local out = {}
  for line in tostring(card:check()):gmatch "[^\n]+" do
    out[#out + 1] = line:match "^%s*warning (%S+)"
  end
  return table.concat(out, " ")
end

-- Stress rises over the whole tested range, along warp and weft.
local function pulls(card, name)
  for angle, yarn in pairs { [0] = "warp", [90] = "weft" } do
    local reach, strains = card.tested[yarn], {}
    for i = 1, 20 do strains[i] = reach * i / 20 end
    local S = reach > 0 and fabric.point(card):uniaxial(angle, strains, { "S" }).S or {}
    for i, s in ipairs(S) do assert(s > (S[i - 1] or 0), ("%s, %s: stress %g after %g"):format(name, yarn, s, S[i - 1] or 0)) end
  end
end

-- Angle of the chord of a strip that overhangs an edge by twice its bending length, cut at `angle` degrees to the warp; degrees.
local function chord(card, length, angle, slenderness)
  local mesh = fabric.mesh.rectangle { width = 2 * length, height = 2 * length / slenderness, nx = 12, ny = 1 }
  local weight = card.density * card.thickness * gravity
  local model = fabric.model { mesh = mesh, card = card, warp = -angle }
  model:fix("left", "x y z rotation"):traction("all", { z = fabric.ramp(-weight, 1) })
  local tip = fabric.static { model = model, duration = 1, step = 0.1 }:solve():node(13)
  return math.deg(math.atan(-tip.z, tip.x))
end

local function bending_length(card, yarn) return (card.bending[yarn] / (card.density * card.thickness * gravity)) ^ (1 / 3) end

local count, rows = 0, {}
for _, name in ipairs(fabric.cards()) do
  local card, file = fabric.card(name), text_of("share/cards/" .. name .. ".lua")
  assert(card.name == name and card:check().ok, name)
  assert(warnings(card) == (warned[name] or ""), ("%s: %s"):format(name, warnings(card)))
  pulls(card, name)
  if not thesis[name] then
    count = count + 1
    local explained = file:find("check() warns", 1, true) ~= nil
    assert(explained == (warned[name] ~= nil), name .. ": a warning without a word in the card's comment, or a word too much")
    assert(card.source:find "%d%d%d%d" or card.source:find "MIT", name .. ": no year in the source")
    for _, field in ipairs { "warp.loading", "weft.loading", "shear.loading", "warp.unloading", "weft.unloading", "shear.unloading", "warp.poisson",
      "weft.poisson", "bending", "thickness", "density" } do
      assert(card.provenance[field], name .. ": where does " .. field .. " come from?")
    end
    local b = card.bending
    local free = b.friction_warp and card:with { bending = { friction_warp = { moment = 1e-12 }, friction_weft = { moment = 1e-12 } } } or card
    for _, yarn in ipairs { "warp", "weft" } do
      local length = bending_length(card, yarn)
      local angle = chord(free, length, yarn == "weft" and 90 or 0, 8)
      rows[#rows + 1] = { ("%s, cantilever of 2 c along the %s, degrees"):format(name, yarn), angle, 41.5, absolute = 0.25 }
      -- friction holds a strip up
      if b["friction_" .. yarn] then assert(chord(card, length, yarn == "weft" and 90 or 0, 8) < angle - 5, name) end
    end
  end
end
assert(count >= 12, "cards of cloths besides the thesis' four: " .. count)

-- statements of the sources besides the numbers that the cards were made of
local worsted = fabric.card "worsted"
rows[#rows + 1] = { "worsted: bending length along the warp, mm", 1e3 * bending_length(worsted, "warp"), 15.0, absolute = 0.05 }
rows[#rows + 1] = { "worsted: bending length along the weft, mm", 1e3 * bending_length(worsted, "weft"), 14.5, absolute = 0.05 }
local function fast(angle)
  local curve = { stretch = { 0 }, force = { 0 } }
  for i = 1, 800 do
    local e = i * 1e-4
    local S = fabric.point(worsted):uniaxial(angle, { e + e * e / 2 }, { "S" }).S[1]
    curve.stretch[i + 1], curve.force[i + 1] = e, S * (1 + e) * worsted.thickness
  end
  return curve
end
local warp, weft = fabric.lab.fast { along = fast(0), bias = fast(45) }, fabric.lab.fast { along = fast(90) }
rows[#rows + 1] = { "worsted: E20 along the warp, per cent", warp.E20, 1.87, absolute = 0.01 }
rows[#rows + 1] = { "worsted: E100 along the warp", warp.E100, 4.60, absolute = 0.01 }
rows[#rows + 1] = { "worsted: E100 along the weft", weft.E100, 5.87, absolute = 0.01 }
rows[#rows + 1] = { "worsted: EB5", warp.EB5, 4.7, absolute = 0.01 }
-- E5 made no part of the card, whose comment tells the difference.
rows[#rows + 1] = { "worsted: E5 along the warp, as the comment says", warp.E5, 0.76, absolute = 0.01 }
rows[#rows + 1] = { "worsted: E5 along the weft, as the comment says", weft.E5, 0.57, absolute = 0.01 }

-- The cantilever at 45 degrees, of which the cards of [feng2022] have their twist: nN.m. The clamped edge holds a strip against
-- twisting, so that cloth which bends and twists together stands up a little more.
for _, cloth in ipairs { { "cloth049", 884.8 }, { "cloth060", 9693.1 }, { "cloth097", 1678.1 }, { "cloth146", 4024.7 }, { "cloth201", 6244.4 },
  { "cloth300", 6364.7 }, { "cloth440", 53827.2 } } do
  local name, B45 = table.unpack(cloth)
  local card = fabric.card(name)
  local angle = chord(card, (B45 * 1e-9 / (card.density * card.thickness * gravity)) ^ (1 / 3), 45, 20)
  rows[#rows + 1] = { name .. ", cantilever of 2 c at 45 degrees", angle, 41.5, absolute = 2 }
end

-- KES' numbers back from the card's
for _, cloth in ipairs { { "broad", 0.118, 0.124 }, { "tropical", 0.077, 0.029 } } do
  local name, B, HB = table.unpack(cloth)
  local b = fabric.card(name).bending
  rows[#rows + 1] = { name .. ": B, gf cm2/cm", b.warp / 9.80665e-5, B, relative = 1e-9 }
  rows[#rows + 1] = { name .. ": 2HB, gf cm/cm", 2 * b.friction_warp.moment / 9.80665e-3, HB, relative = 1e-9 }
end

-- false drops a part of a card, and only that
do
  local broad = fabric.card "broad"
  local free = broad:with { bending = { warp = 1e-5, friction_warp = false } }
  assert(free.bending.warp == 1e-5 and free.bending.friction_warp == nil and free.bending.friction_weft.moment == broad.bending.friction_weft.moment)
  assert(broad:with({ bending = false }).bending == nil and broad.bending ~= nil)
  assert(broad:with({ bending = { twist = 1e-6 } }).bending.friction_warp.moment == broad.bending.friction_warp.moment)
  -- ... and nothing where there is none
  local blend = fabric.card "blend"
  for _, none in ipairs { { warp = { loop = false } }, { bending = { friction_warp = false } }, { bending = { friction_warp = false, friction_weft = false } },
    { bending = false }, { compression = false }, { biaxial = false, viscous = false, fibre_density = false }, { shear = { friction = false } } } do
    assert(blend:with(none) == blend)
  end
  local own = { warp = 1e-5, weft = 1e-5, twist = 5e-6 }
  local bent = blend:with { bending = own }
  assert(bent:with { bending = { friction_warp = false } } == bent)
  own.friction_weft = false
  assert(blend:with { bending = own } == bent)
  assert(blend:with { fibre_density = 1500 }:with { fibre_density = false } == blend)
  assert(blend:with { warp = { loop = { friction = 0.3, reach = 0.2 } } }:with({ warp = { loop = { reach = false } } }).warp.loop.reach == 0.5)
  assert(blend:with { tested = false }.tested.warp == 0 and bent.tested.warp > 0)
  for field, words in pairs { warp = "expected a table {loading, unloading, poisson, loop}, got false", density = "expected a positive number in kg/m^3, got false" } do
    local ok, message = pcall(blend.with, blend, { [field] = false })
    assert(not ok and tostring(message):find(("field '%s': %s"):format(field, words), 1, true), tostring(message))
  end
end

-- fields that only the default law takes are refused at once beside another law; fields that another law does not use are named by check()
do
  local blend = fabric.card "blend"
  for field, part in pairs { ["warp.loop"] = { warp = { loop = { friction = 0.3 } } }, ["weft.loop"] = { weft = { loop = { friction = 0.3 } } },
    ["shear.friction"] = { shear = { friction = { stress = 1e3 } } }, viscous = { viscous = { shear = { modulus = 1e5, time = 1 } } } } do
    for _, law in ipairs { "thesis", "incremental" } do
      local ok, message = pcall(blend.with, blend:with(part), { law = law })
      assert(not ok and tostring(message):find(("with: field '%s': expected law = \"potential\", the only one that takes it, got law = \"%s\""):format(field, law), 1, true),
        tostring(message))
    end
  end
  local fourth = blend:with { law = "thesis", biaxial = { alpha = 1.5, offset = 0.1, loading = 3e8, unloading = 1e8 } }
  assert(tostring(fourth:check()):find("biaxial is not used", 1, true) and not tostring(blend:check()):find("not used", 1, true))
end

-- the page is that of the cards
arg = { [0] = home .. "scripts/cards.lua" }
dofile(arg[0])
fabric.expect(rows)
